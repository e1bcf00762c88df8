// Positions are snapped to a lattice of 2^26 steps across the extent of the points, on which all signs are exact. A
// step is 25 nanometres on the longest side of A0. Heights are interpolated in the triangles of the lattice.

#include "scene/surfaces/scattered_points.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/no_index.hpp"
#include "base/parallel.hpp"
#include "geometry/delaunay.hpp"
#include "geometry/morton.hpp"
#include "scene/surfaces/formula/height_function.hpp"
#include "scene/surfaces/height_filters.hpp"

namespace ligne {
namespace {

constexpr std::size_t kFewestColumns = 100, kMostColumns = 500;
/// Largest number of samples kept in memory, since a picture reads each several times.
constexpr std::size_t kMostHeld = std::size_t{1} << 22;
/// Ratio of side to height from which a triangle is a sliver.
constexpr double kSliver = 8;
/// Number of points per triangle at which a search can start.
constexpr double kPointsPerStart = 2;

/// Maps positions to lattice points. The low corner of the extent becomes -kLatticeLimit on both axes. Each axis has
/// its own scale, since the units of x and y may differ.
struct PlaneLattice {
  Point2 low, step;

  Point2 in_steps(double x, double y) const {
    return {(x - low.x) / step.x - kLatticeLimit, (y - low.y) / step.y - kLatticeLimit};
  }
  LatticePoint snap(double x, double y) const {
    const Point2 p = in_steps(x, y);
    return {static_cast<std::int32_t>(std::lround(p.x)), static_cast<std::int32_t>(std::lround(p.y))};
  }
};

class TriangulatedFunction : public HeightFunction {
 public:
  TriangulatedFunction(PlaneLattice lattice, std::vector<LatticePoint> points, std::vector<double> heights)
      : lattice_(lattice), points_(std::move(points)), heights_(std::move(heights)), mesh_(triangulate_delaunay(points_)) {
    peel_rim();
    find_starts();
  }

  bool is_continuous() const override { return true; }
  bool empty() const {
    return std::all_of(left_out_.begin(), left_out_.end(), [](char out) { return out != 0; });
  }

  void use(FunctionRef<void(At&)> work) const override {
    PointAt at(*this);
    work(at);
  }

 private:
  class PointAt : public At {
   public:
    explicit PointAt(const TriangulatedFunction& function) : function_(function) {}
    double operator()(double x, double y) override { return function_.height(function_.lattice_.in_steps(x, y)); }

   private:
    const TriangulatedFunction& function_;
  };

  std::size_t start_cell(Point2 p) const {
    const auto cell = [&](double at) {
      const double part = (at + kLatticeLimit) / (2. * kLatticeLimit) * static_cast<double>(side_);
      return static_cast<std::size_t>(std::clamp(part, 0., static_cast<double>(side_ - 1)));
    };
    return cell(p.y) * side_ + cell(p.x);
  }

  /// Removes slivers at the rim. The convex hull of points in a frame has few, long sides over slivers, which would
  /// stand as walls at the rim. A rim triangle is left out if its rim side is long against its height; then its
  /// neighbours become rim triangles and are tested too.
  void peel_rim() {
    left_out_.assign(mesh_.triangles.size(), 0);
    std::vector<std::array<std::uint32_t, 2>> rim;  // a triangle and its side
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
      for (std::uint32_t k = 0; k < 3; ++k) {
        if (mesh_.neighbours[t][k] == kNone) rim.push_back({t, k});
      }
    }
    while (!rim.empty()) {
      const auto [t, k] = rim.back();
      rim.pop_back();
      const auto& v = mesh_.triangles[t];
      const LatticePoint &a = points_[v[k]], &b = points_[v[(k + 1) % 3]], &apex = points_[v[(k + 2) % 3]];
      const double side_x = double(b.x) - a.x, side_y = double(b.y) - a.y;
      if (left_out_[t] || side_x * side_x + side_y * side_y < kSliver * orientation(a, b, apex)) continue;
      left_out_[t] = 1;
      for (std::uint32_t side = 0; side < 3; ++side) {
        const std::uint32_t beyond = mesh_.neighbours[t][side];
        if (beyond == kNone || left_out_[beyond]) continue;
        const auto& there = mesh_.neighbours[beyond];
        rim.push_back({beyond, static_cast<std::uint32_t>(std::find(there.begin(), there.end(), t) - there.begin())});
      }
    }
  }

  /// Finds start triangles. The start depends on the place alone, so that every search for a place ends in the same
  /// triangle.
  void find_starts() {
    side_ = 1 + static_cast<std::size_t>(std::sqrt(static_cast<double>(points_.size()) / kPointsPerStart));
    starts_.assign(side_ * side_, kNone);
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
      Point2 middle{0, 0};
      for (const std::uint32_t v : mesh_.triangles[t]) middle += Point2{points_[v].x, points_[v].y} / 3.;
      std::uint32_t& start = starts_[start_cell(middle)];
      if (start == kNone) start = t;
    }
    std::uint32_t last = 0;
    for (std::uint32_t& start : starts_) last = start = start == kNone ? last : start;
  }

  /// Twice the signed area of a triangle of two lattice points and p.
  double area(std::uint32_t a, std::uint32_t b, Point2 p) const {
    const LatticePoint &from = points_[a], &to = points_[b];
    return (double(to.x) - from.x) * (p.y - from.y) - (double(to.y) - from.y) * (p.x - from.x);
  }

  /// Walks from triangle to triangle across sides beyond which the place lies; in a Delaunay triangulation no such walk
  /// returns. If rounding puts the place beyond the common side of two triangles from both, it counts as inside.
  double height(Point2 p) const {
    if (!(std::abs(p.x) <= kLatticeLimit && std::abs(p.y) <= kLatticeLimit)) return kNaN;
    std::uint32_t t = starts_[start_cell(p)], before = kNone;
    for (std::size_t step = 0; step <= mesh_.triangles.size(); ++step) {
      const auto& v = mesh_.triangles[t];
      const double across[] = {area(v[0], v[1], p), area(v[1], v[2], p), area(v[2], v[0], p)};
      std::uint32_t beyond = t;
      for (int k = 0; k < 3 && beyond == t; ++k) {
        const std::uint32_t neighbour = mesh_.neighbours[t][static_cast<std::size_t>(k)];
        if (across[k] < 0 && neighbour != before) beyond = neighbour;
        if (across[k] < 0 && neighbour == kNone) return kNaN;
      }
      if (beyond == t && left_out_[t]) return kNaN;
      if (beyond == t) {
        const double all = across[0] + across[1] + across[2];
        return (across[1] * heights_[v[0]] + across[2] * heights_[v[1]] + across[0] * heights_[v[2]]) / all;
      }
      before = t;
      t = beyond;
    }
    return kNaN;
  }

  static constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

  PlaneLattice lattice_;
  std::vector<LatticePoint> points_;
  std::vector<double> heights_;
  Delaunay mesh_;
  std::vector<char> left_out_;  ///< per triangle: 1 if removed from the rim
  std::size_t side_ = 1;
  std::vector<std::uint32_t> starts_;
};

struct PlacedHeight {
  std::uint64_t key;  ///< position along the Morton curve, by which the triangulation is ordered
  LatticePoint at;
  double height;
};

/// Merges points at the same place.
std::size_t merge_places(std::vector<PlacedHeight>& points) {
  parallel_sort(points.begin(), points.end(), [](const PlacedHeight& a, const PlacedHeight& b) {
    return a.key != b.key ? a.key < b.key : a.height < b.height;
  });
  std::size_t count = 0, merged = 0;
  for (std::size_t i = 0; i < points.size();) {
    std::size_t end = i;
    double sum = 0;
    while (end < points.size() && points[end].key == points[i].key) sum += points[end++].height;
    points[count++] = {points[i].key, points[i].at, sum / static_cast<double>(end - i)};
    merged += end - i - 1;
    i = end;
  }
  points.resize(count);
  return merged;
}

std::vector<double> spaced(double from, double to, std::size_t count) {
  std::vector<double> at(count);
  for (std::size_t i = 0; i < count; ++i) {
    at[i] = i + 1 == count ? to : from + (to - from) * (static_cast<double>(i) / static_cast<double>(count - 1));
  }
  return at;
}

class PointHeights : public HeightSource {
 public:
  PointHeights(std::shared_ptr<const HeightFunction> function, std::vector<double> x, std::vector<double> y)
      : HeightSource(x, y), function_(function), heights_(heights_of(std::move(function), std::move(x), std::move(y))) {
    if (heights_->x().size() <= kMostHeld / heights_->y().size()) heights_ = held(*heights_);
  }

  void read_row(std::size_t j, std::span<double> z) const override { heights_->read_row(j, z); }
  std::shared_ptr<const HeightFunction> function() const override { return function_; }

 private:
  std::shared_ptr<const HeightFunction> function_;
  std::unique_ptr<HeightSource> heights_;
};

}  // namespace

std::unique_ptr<HeightSource> surface_of_points(std::vector<Point3> points, std::optional<unsigned> columns,
                                                const std::string& name, Warnings& warnings) {
  Point2 low{INFINITY, INFINITY}, high{-INFINITY, -INFINITY};
  for (const Point3& p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  const auto on_a_line = [&] { return InputError(name, "has only points along a line, which make no surface"); };
  if (points.size() < 3 || !(low.x < high.x) || !(low.y < high.y) || !std::isfinite(high.x - low.x + high.y - low.y))
    throw on_a_line();
  const PlaneLattice lattice{low, (high - low) / (2. * kLatticeLimit)};
  std::vector<PlacedHeight> placed(points.size());
  parallel_for(points.size(), [&](std::size_t i) {
    const LatticePoint p = lattice.snap(points[i].x, points[i].y);
    placed[i] = {morton_key(p), p, points[i].z};
  });
  const std::size_t merged = merge_places(placed);
  if (merged > 0) warnings.add("points at equal positions: heights averaged", merged);
  std::vector<LatticePoint> at;
  std::vector<double> heights;
  at.reserve(placed.size());
  heights.reserve(placed.size());
  for (const PlacedHeight& p : placed) {
    at.push_back(p.at);
    heights.push_back(p.height);
  }
  const auto root = static_cast<std::size_t>(std::sqrt(static_cast<double>(at.size())));
  const std::size_t count = columns ? *columns : std::clamp(root, kFewestColumns, kMostColumns);
  const auto function = std::make_shared<TriangulatedFunction>(lattice, std::move(at), std::move(heights));
  if (function->empty()) throw on_a_line();
  const double alike = (high.y - low.y) / (high.x - low.x) * static_cast<double>(count);
  const auto rows =
      static_cast<std::size_t>(std::clamp(alike, static_cast<double>(count) / 4, static_cast<double>(count) * 4));
  return std::make_unique<PointHeights>(function, spaced(low.x, high.x, count),
                                        spaced(low.y, high.y, std::max<std::size_t>(rows, 2)));
}

}  // namespace ligne
