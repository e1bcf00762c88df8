#include "picture/choice/faces_in_front.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ligne {
namespace {

/// Number of rows of the regular grid of sample points.
constexpr std::uint32_t kRows = 512;
/// Most columns of that grid, for pictures that are low and wide.
constexpr std::uint32_t kMostColumns = 4096;
/// Adjustable: entries of lists that are looked at, for each facet and in all. About 2 nanoseconds each.
constexpr std::uint64_t kLooksPerFacet = 64, kLeastLooks = 20'000'000;

/// Where a point lies relative to a facet.
enum class Cover : std::uint8_t { outside, border, inside };

class SampleSearch {
 public:
  SampleSearch(const ProjectedScene& scene, const std::vector<Facet>& facets, const CellGrid& grid, const Rect& around)
      : scene_(scene), facets_(facets), grid_(grid), corner_(around.min) {
    const double width = around.max.x - around.min.x, height = around.max.y - around.min.y;
    step_ = std::max({height / kRows, width / kMostColumns, 1.0});
    columns_ = std::max(1.0, std::floor(width / step_));
    rows_ = std::max(1.0, std::floor(height / step_));
    looks_left_ = std::max(kLeastLooks, kLooksPerFacet * facets.size());
    std::uint32_t faces = 0;
    for (const Facet& f : facets) faces = std::max(faces, f.face + 1);
    found_.flags.assign(faces, 0);
  }

  void search(const Cell& cell, const CellSquare& square) {
    if (cell.count == 0) return;
    list_ = grid_.list(cell);
    count_ = cell.count;
    const auto first = [this](double v, double n) { return std::clamp(std::ceil(v / step_ - 0.5), 0.0, n); };
    const double left = first(square.x - corner_.x, columns_), right = first(square.x + square.size - corner_.x, columns_);
    const double top = first(square.y - corner_.y, rows_), bottom = first(square.y + square.size - corner_.y, rows_);
    for (double row = top; row < bottom; ++row) {
      for (double column = left; column < right; ++column) {
        see({std::round(corner_.x + (column + 0.5) * step_), std::round(corner_.y + (row + 0.5) * step_)}, square);
      }
    }
    for (std::uint32_t i = 0; i < count_; ++i) {
      const Facet& f = facets_[list_[i].facet];
      if (found_.flags[f.face]) continue;
      const Point2 middle = middle_of(f);
      const bool own = square.x <= middle.x && middle.x < square.x + square.size && square.y <= middle.y &&
                       middle.y < square.y + square.size;
      if (own && is_in_front(f, middle, square)) found_.flags[f.face] = 1;
    }
  }

  FacesInFront finish() {
    found_.complete = looks_left_ > 0;
    return std::move(found_);
  }

 private:
  /// A facet over a sample point, and its depth there.
  struct Seen {
    const Facet* facet = nullptr;
    double z = std::numeric_limits<double>::infinity();
  };

  LatticePoint at(const Facet& f, int k) const { return scene_.vertices[f.v[k]].p; }

  Point2 middle_of(const Facet& f) const {
    const LatticePoint a = at(f, 0), b = at(f, 1), c = at(f, 2);
    return {std::round((double(a.x) + b.x + c.x) / 3), std::round((double(a.y) + b.y + c.y) / 3)};
  }

  /// Sets z to the depth of the facet at the point, unless the point lies outside.
  Cover cover_of(const Facet& f, LatticePoint q, double& z) const {
    const double e0 = orientation(at(f, 0), at(f, 1), q), e1 = orientation(at(f, 1), at(f, 2), q),
                 e2 = orientation(at(f, 2), at(f, 0), q);
    if (std::min({e0, e1, e2}) < 0) return Cover::outside;
    const auto depth = [&](int k) { return scene_.vertices[f.v[k]].z; };
    z = (e1 * depth(0) + e2 * depth(1) + e0 * depth(2)) / (e0 + e1 + e2);
    return std::min({e0, e1, e2}) > 0 ? Cover::inside : Cover::border;
  }

  static LatticePoint lattice_point(Point2 p) { return {static_cast<std::int32_t>(p.x), static_cast<std::int32_t>(p.y)}; }

  /// Takes one step of the budget.
  bool may_look() {
    if (looks_left_ == 0) return false;
    --looks_left_;
    return true;
  }

  bool is_opaque(const Facet& f) const {
    return f.face >= scene_.face_is_transparent.size() || !scene_.face_is_transparent[f.face];
  }

  static bool hides(const Facet& other, double other_z, const Facet& f, double z) {
    return other_z < z - std::max(f.depth_tolerance, other.depth_tolerance);
  }

  /// Marks the faces that are in front at the point: those that its nearest opaque facet does not hide.
  void see(Point2 p, const CellSquare& square) {
    const CellBox box = square.box(p.x, p.x, p.y, p.y);
    Seen nearest;
    float tolerance = 0;
    seen_.clear();
    for (std::uint32_t i = 0; i < count_ && list_[i].z_near <= nearest.z + tolerance && may_look(); ++i) {
      if (!list_[i].box.meets(box)) continue;
      const Facet& f = facets_[list_[i].facet];
      double z = 0;
      const Cover cover = cover_of(f, lattice_point(p), z);
      if (cover == Cover::outside) continue;
      if (cover == Cover::inside) seen_.push_back({&f, z});
      tolerance = std::max(tolerance, f.depth_tolerance);
      if (z < nearest.z && is_opaque(f)) nearest = {&f, z};
    }
    for (const Seen& s : seen_) {
      if (!nearest.facet || !hides(*nearest.facet, nearest.z, *s.facet, s.z)) found_.flags[s.facet->face] = 1;
    }
  }

  bool is_in_front(const Facet& f, Point2 p, const CellSquare& square) {
    double z = 0;
    if (cover_of(f, lattice_point(p), z) != Cover::inside) return false;
    const CellBox box = square.box(p.x, p.x, p.y, p.y);
    for (std::uint32_t i = 0; i < count_ && list_[i].z_near < z; ++i) {
      if (!may_look()) return false;
      if (!list_[i].box.meets(box)) continue;
      const Facet& other = facets_[list_[i].facet];
      double other_z = 0;
      if (!is_opaque(other) || cover_of(other, lattice_point(p), other_z) == Cover::outside) continue;
      if (hides(other, other_z, f, z)) return false;
    }
    return true;
  }

  const ProjectedScene& scene_;
  const std::vector<Facet>& facets_;
  const CellGrid& grid_;
  Point2 corner_;
  double step_ = 1;  ///< distance of two points of the regular grid, in lattice steps
  double columns_ = 1, rows_ = 1;
  const CellFacet* list_ = nullptr;
  std::uint32_t count_ = 0;
  std::uint64_t looks_left_ = 0;
  std::vector<Seen> seen_;
  FacesInFront found_;
};

}  // namespace

FacesInFront find_faces_in_front(const ProjectedScene& scene, const std::vector<Facet>& facets, const CellGrid& grid,
                                 const Rect& around) {
  SampleSearch search(scene, facets, grid, around);
  for (std::size_t i = 0; i < grid.top_cell_count(); ++i) {
    grid.for_each_leaf_of(i, [&](const Cell& cell, const CellSquare& square) { search.search(cell, square); });
  }
  return search.finish();
}

}  // namespace ligne
