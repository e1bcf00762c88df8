#include "picture/choice/face_pairs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/parallel.hpp"
#include "view/tolerances.hpp"
#include "visibility/penetration/penetration.hpp"

namespace ligne {
namespace {

/// Largest number of overlapping pairs along the privileged axis, as a part of those along the next one. Below a half the
/// two differ by more than the shape of the picture explains: that of a page differs from a square by a third.
constexpr double kPrivilegedPart = 0.5;

/// Number of pairs of faces with disjoint extents along the axis.
std::uint64_t pairs_apart(std::span<const FaceExtent> faces, std::size_t axis) {
  std::vector<double> begins, ends;
  begins.reserve(faces.size());
  ends.reserve(faces.size());
  for (const FaceExtent& f : faces) {
    begins.push_back(f.low[axis]);
    ends.push_back(f.high[axis]);
  }
  std::sort(begins.begin(), begins.end());
  std::sort(ends.begin(), ends.end());
  std::uint64_t pairs = 0;
  std::size_t ended = 0;
  for (const double begin : begins) {
    while (ended < ends.size() && ends[ended] < begin) ++ended;
    pairs += ended;
  }
  return pairs;
}

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

/// Adjustable: largest number of pairs of facets that are tested, at about 0.1 microseconds each.
constexpr std::uint64_t kMaxTests = 4'000'000;

std::uint64_t pair_of(std::uint32_t a, std::uint32_t b) { return std::uint64_t{std::min(a, b)} << 32 | std::max(a, b); }

void keep_each_once(std::vector<std::uint64_t>& pairs) {
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
}

/// Tests the pairs of each leaf of the grid, until kMaxTests tests are done.
class PairSearch {
 public:
  PairSearch(const ProjectedScene& scene, const std::vector<Facet>& facets, const CellGrid& grid)
      : facets_(facets), grid_(grid), penetrations_(facets, scene.vertices) {}

  void look(const Cell& cell) {
    if (cell.count < 2 || cell.one_face) return;
    const CellFacet* list = grid_.list(cell);
    placed_.clear();
    for (std::uint32_t i = 0; i < cell.count; ++i) placed_.push_back(penetrations_.place(list[i].facet));
    for (std::uint32_t i = 0; i < cell.count; ++i) {
      for (std::uint32_t k = i + 1; k < cell.count; ++k) {
        if (tests_ == kMaxTests) return;
        ++tests_;
        if (placed_[i].face == placed_[k].face || !list[i].box.meets(list[k].box)) continue;
        // The list is sorted by the nearest depth. If the second facet is wholly behind the first one, they can only
        // overlap.
        const bool may_penetrate = list[k].z_near <= facets_[list[i].facet].z_far;
        if (may_penetrate) penetrations_.test(placed_[i], placed_[k], [](const PageSegment&) { return true; });
        if (overlap_on_page(placed_[i], placed_[k])) found_.overlapping.push_back(pair_of(placed_[i].face, placed_[k].face));
      }
    }
    penetrations_.forget_repeated();
  }

  FacePairs finish(double least_steps) {
    keep_each_once(found_.overlapping);
    for (const Intersection& x : penetrations_.finish(least_steps)) {
      if (x.face0 != x.face1) found_.penetrating.push_back(pair_of(x.face0, x.face1));
    }
    keep_each_once(found_.penetrating);
    found_.complete = tests_ < kMaxTests;
    return std::move(found_);
  }

 private:
  const std::vector<Facet>& facets_;
  const CellGrid& grid_;
  PenetrationSearch penetrations_;
  std::vector<PlacedFacet> placed_;
  std::uint64_t tests_ = 0;
  FacePairs found_;
};

}  // namespace

CellGrid grid_of_all(const ProjectedScene& scene, const std::vector<Facet>& facets, double coincidence_steps) {
  CellGrid::Options options{.margin_steps = coincidence_steps + 1, .drop_hidden = false};
  return {scene, facets, options};
}

FacePairs find_face_pairs(const ProjectedScene& scene, const std::vector<Facet>& facets, const CellGrid& grid) {
  PairSearch search(scene, facets, grid);
  for (std::size_t i = 0; i < grid.top_cell_count(); ++i) {
    grid.for_each_leaf_of(i, [&](const Cell& cell, const CellSquare&) { search.look(cell); });
  }
  return search.finish(kLeastPartMm / scene.lattice.step_mm);
}

FacesInFront find_faces_in_front(const ProjectedScene& scene, const std::vector<Facet>& facets, const CellGrid& grid,
                                 const Rect& around) {
  SampleSearch search(scene, facets, grid, around);
  for (std::size_t i = 0; i < grid.top_cell_count(); ++i) {
    grid.for_each_leaf_of(i, [&](const Cell& cell, const CellSquare& square) { search.search(cell, square); });
  }
  return search.finish();
}

FaceSpread spread_of(std::span<const FaceExtent> faces) {
  FaceSpread spread;
  if (faces.size() < 2) return spread;
  const std::uint64_t n = faces.size(), all = n * (n - 1) / 2;
  std::array<std::uint64_t, 3> together{};
  parallel_tasks(3, [&](std::size_t axis) { together[axis] = all - pairs_apart(faces, axis); });
  std::size_t least = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    spread.apart[axis] = double(all - together[axis]) / double(all);
    if (together[axis] < together[least]) least = axis;
  }
  const std::uint64_t next = std::min(together[(least + 1) % 3], together[(least + 2) % 3]);
  if (double(together[least]) <= kPrivilegedPart * double(next) && together[least] < next) {
    spread.privileged = static_cast<int>(least);
  }
  return spread;
}

}  // namespace ligne
