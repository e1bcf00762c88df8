#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "base/no_index.hpp"
#include "contours/shapes/shape_fields.hpp"
#include "contours/shapes/shape_lines.hpp"
#include "scene/form/form_mesh.hpp"

namespace ligne {
namespace {

/// Traces the zero set of a function given at the nodes of a mesh, as chains of segments.

/// Segment i runs from point i to point i + 1 over triangle i. A closed chain repeats its first point.
struct ZeroChain {
  std::vector<Point3> points;
  std::vector<std::uint32_t> triangles;  ///< per segment
  bool closed = false;

  /// Number of segments.
  std::size_t size() const { return triangles.size(); }
};

class ZeroTracer {
 public:
  ZeroTracer(const FormMesh& mesh, const std::vector<double>& value, const std::vector<Point3>& way)
      : mesh_(mesh), value_(value), way_(way), done_(mesh.triangles.size(), 0) {}

  std::vector<ZeroChain> trace() {
    std::vector<ZeroChain> chains;
    const auto n = static_cast<std::uint32_t>(mesh_.triangles.size());
    for (std::uint32_t t = 0; t < n; ++t) {  // open chains, from their ends
      if (done_[t] || !is_crossed(t)) continue;
      for (const int side : crossed_sides(t)) {
        if (!done_[t] && beyond(t, side) == kNone) chains.push_back(walk(t, side, false));
      }
    }
    for (std::uint32_t t = 0; t < n; ++t) {
      if (!done_[t] && is_crossed(t)) chains.push_back(walk(t, crossed_sides(t)[0], true));
    }
    return chains;
  }

 private:
  using Ends = std::array<std::uint32_t, 2>;

  /// The nodes of a side, the lower first, so that both of its triangles get the same pair.
  Ends ends_of(std::uint32_t t, int side) const {
    const auto& node = mesh_.triangles[t].node;
    const std::uint32_t a = node[static_cast<std::size_t>(side)], b = node[static_cast<std::size_t>((side + 1) % 3)];
    return {std::min(a, b), std::max(a, b)};
  }
  double second_value(const Ends& ends) const {
    const bool turned = !way_.empty() && glm::dot(way_[ends[0]], way_[ends[1]]) < 0;
    return turned ? -value_[ends[1]] : value_[ends[1]];
  }
  bool crosses(std::uint32_t t, int side) const {
    const Ends ends = ends_of(t, side);
    return (value_[ends[0]] >= 0) != (second_value(ends) >= 0);
  }
  bool is_crossed(std::uint32_t t) const { return crosses(t, 0) + crosses(t, 1) + crosses(t, 2) == 2; }
  std::array<int, 2> crossed_sides(std::uint32_t t) const {
    if (!crosses(t, 0)) return {1, 2};
    return {0, crosses(t, 1) ? 1 : 2};
  }
  /// The triangle that continues the chain beyond a side, or kNone.
  std::uint32_t beyond(std::uint32_t t, int side) const {
    const std::uint32_t other = mesh_.triangles[t].across[static_cast<std::size_t>(side)];
    return other == kNone || !is_crossed(other) ? kNone : other;
  }
  int same_side(std::uint32_t t, const Ends& ends) const {
    for (int side = 0; side < 2; ++side) {
      if (ends_of(t, side) == ends) return side;
    }
    return 2;
  }

  Point3 point(const Ends& ends) const {
    const double a = value_[ends[0]], b = second_value(ends);
    return mesh_.points[ends[0]] + (a / (a - b)) * (mesh_.points[ends[1]] - mesh_.points[ends[0]]);
  }

  ZeroChain walk(std::uint32_t t, int entry, bool closed) {
    ZeroChain chain;
    chain.closed = closed;
    chain.points.push_back(point(ends_of(t, entry)));
    while (t != kNone && !done_[t]) {
      done_[t] = 1;
      const auto sides = crossed_sides(t);
      const int exit = sides[0] == entry ? sides[1] : sides[0];
      const Ends ends = ends_of(t, exit);
      chain.triangles.push_back(t);
      chain.points.push_back(point(ends));
      t = beyond(t, exit);
      if (t != kNone) entry = same_side(t, ends);
    }
    if (closed) chain.points.back() = chain.points.front();
    return chain;
  }

  const FormMesh& mesh_;
  const std::vector<double>& value_;
  const std::vector<Point3>& way_;
  std::vector<std::uint8_t> done_;
};

/// Traces the zero set of a function that is linear over each triangle. Zero at a node counts as positive, so chains
/// never branch. If `way` is given, the values are derivatives along its directions, whose signs are arbitrary. Then
/// the signs of directions (and values) are made to agree before two values are compared. Triangles whose three
/// directions can not be made to agree have no segment, and chains end there.
std::vector<ZeroChain> trace_zero_set(const FormMesh& mesh, const std::vector<double>& value,
                                      const std::vector<Point3>& way = {}) {
  return ZeroTracer(mesh, value, way).trace();
}

// Adjustable. Curvatures are multiplied by the size of the object (shape_fields.hpp).
/// Derivative of the radial curvature towards the viewer at which a suggestive contour is strong.
constexpr double kStrongGrowth = 25;
/// A ridge or valley is strong if its curvature reaches kStrongBend, and if the negative second derivative of the
/// curvature across it, divided by the curvature, reaches kStrongFall.
constexpr double kStrongBend = 12, kStrongFall = 60;
/// Least strength at which a line continues; 1 is strong.
constexpr double kWeak = 0.6;
/// Number of segments before and behind over which the strength is averaged.
constexpr std::size_t kWindow = 4;
/// Least length of a line, least length of its strong parts, and least length of a gap that stays open, in pen widths.
constexpr double kShortestInPens = 28, kStrongInPens = 10, kGapInPens = 10;

/// A chain with its strength: 1 is strong.
struct RatedChain {
  LineClass line_class;
  ZeroChain chain;
  std::vector<double> strength;  ///< per segment
};

std::array<std::size_t, 3> corners_of(const FormMesh& mesh, std::uint32_t t) {
  const auto& node = mesh.triangles[t].node;
  return {node[0], node[1], node[2]};
}

double mean_at(const std::vector<double>& values, const std::array<std::size_t, 3>& nodes) {
  return (values[nodes[0]] + values[nodes[1]] + values[nodes[2]]) / 3;
}

void add_suggestive(const ShapeFields& fields, const Camera& camera, std::vector<RatedChain>& rated) {
  const RadialField field = radial_field(fields, camera);
  for (ZeroChain& chain : trace_zero_set(fields.mesh, field.value)) {
    RatedChain line{LineClass::suggestive, std::move(chain), {}};
    for (const std::uint32_t t : line.chain.triangles) {
      const auto nodes = corners_of(fields.mesh, t);
      const bool told = std::ranges::none_of(nodes, [&](std::size_t n) { return field.growth[n] == 0; });
      line.strength.push_back(told ? std::max(0.0, mean_at(field.growth, nodes) / kStrongGrowth) : 0);
    }
    rated.push_back(std::move(line));
  }
}

/// +1 if the normal points to the relevant side of the surface, -1 if it points to the other, 0 if the nodes disagree.
/// The relevant side of a closed body is the outer one, and of a sheet the visible one.
int side_of(const ShapeFields& fields, const Camera& camera, const std::array<std::size_t, 3>& nodes) {
  if (const int outward = fields.outward[nodes[0]]; outward != 0) return outward;
  int sum = 0;
  for (const std::size_t n : nodes) sum += glm::dot(fields.normals[n], to_eye(camera, fields.mesh.points[n])) < 0 ? -1 : 1;
  return sum == 3 ? 1 : sum == -3 ? -1 : 0;
}

/// Strength of an extremum over a triangle; 1 is strong.
double strength_of(const ShapeFields& fields, const ExtremumField& field, std::uint32_t t) {
  const auto nodes = corners_of(fields.mesh, t);
  const double bend = mean_at(field.curvature, nodes);
  if (std::ranges::any_of(nodes, [&](std::size_t n) { return field.curvature[n] <= 0; })) return 0;
  std::array<double, 3> values{};
  Point3 way{0, 0, 0};
  for (std::size_t k = 0; k < 3; ++k) {
    const int sign = glm::dot(field.way[nodes[0]], field.way[nodes[k]]) < 0 ? -1 : 1;
    values[k] = sign * field.value[nodes[k]];
    way += double(sign) * field.way[nodes[k]];
  }
  const double fall = -glm::dot(fields.slope(t, values), unit(way)) / bend;
  return std::max(0.0, std::min(bend / kStrongBend, fall / kStrongFall));
}

void add_extrema(const ShapeFields& fields, const Camera& camera, LineClasses classes, int sign,
                 std::vector<RatedChain>& rated) {
  const ExtremumField field = extremum_field(fields, sign);
  for (const ZeroChain& chain : trace_zero_set(fields.mesh, field.value, field.way)) {
    RatedChain ridge{LineClass::ridge, chain, {}}, valley{LineClass::valley, chain, {}};
    for (const std::uint32_t t : chain.triangles) {
      const int convex = sign * side_of(fields, camera, corners_of(fields.mesh, t));
      const double strength = strength_of(fields, field, t);
      ridge.strength.push_back(convex > 0 ? strength : 0);
      valley.strength.push_back(convex < 0 ? strength : 0);
    }
    if (classes.has(LineClass::ridge)) rated.push_back(std::move(ridge));
    if (classes.has(LineClass::valley)) rated.push_back(std::move(valley));
  }
}

/// Strength of each segment, averaged over its neighbours with their lengths as weights.
std::vector<double> evened_strength(const RatedChain& line) {
  const std::size_t n = line.chain.size();
  std::vector<double> result(n);
  for (std::size_t i = 0; i < n; ++i) {
    double sum = 0, all = 0;
    const auto take = [&](std::size_t k) {
      const double length = glm::length(line.chain.points[k + 1] - line.chain.points[k]);
      sum += length * line.strength[k];
      all += length;
    };
    take(i);
    for (std::size_t k = 1; k <= kWindow; ++k) {
      if (line.chain.closed && n > 2 * kWindow) {
        take((i + k) % n);
        take((i + n - k) % n);
      } else {
        if (i + k < n) take(i + k);
        if (i >= k) take(i - k);
      }
    }
    result[i] = all > 0 ? sum / all : 0;
  }
  return result;
}

/// Cuts chains to the parts that are drawn, by two thresholds (hysteresis).
class Cutter {
 public:
  Cutter(const FormMesh& mesh, const View& view, double pen_mm) : mesh_(mesh), view_(view), pen_mm_(pen_mm) {}

  void cut(const RatedChain& line, std::vector<ShapeLine>& lines) {
    const std::size_t n = line.chain.size();
    const std::vector<double> strength = evened_strength(line);
    lengths_.resize(n);
    weak_.resize(n);
    strong_.resize(n);
    for (std::size_t i = 0; i < n; ++i) {
      lengths_[i] = page_length(line.chain.points[i], line.chain.points[i + 1]);
      weak_[i] = strength[i] >= kWeak && lengths_[i] >= 0;
      strong_[i] = strength[i] >= 1;
    }
    // A closed chain starts at a segment that is not drawn.
    std::size_t start = 0;
    if (line.chain.closed) start = static_cast<std::size_t>(std::ranges::find(weak_, std::uint8_t{0}) - weak_.begin());
    if (start == n) return add(line, 0, n, lines);
    close_gaps(start, line.chain.closed);
    for (std::size_t i = 0; i < n;) {
      std::size_t end = i;
      while (end < n && weak_[(start + end) % n]) ++end;
      if (end > i) add(line, start + i, start + end, lines);
      i = end + 1;
    }
  }

 private:
  /// Length of a segment on the page, mm; negative if one end is not in view.
  double page_length(const Point3& a, const Point3& b) const {
    const HomogeneousPoint p = to_homogeneous(view_, a), q = to_homogeneous(view_, b);
    const double least = view_.camera.perspective ? view_.near_distance : 0;
    if (p.w <= least || q.w <= least) return -1;
    return std::hypot(p.x / p.w - q.x / q.w, p.y / p.w - q.y / q.w);
  }

  void close_gaps(std::size_t start, bool closed) {
    const std::size_t n = weak_.size();
    for (std::size_t i = 0; i < n;) {
      std::size_t end = i;
      double length = 0;
      bool in_view = true;
      for (; end < n && !weak_[(start + end) % n]; ++end) {
        length += lengths_[(start + end) % n];
        in_view = in_view && lengths_[(start + end) % n] >= 0;
      }
      const bool inside = i > 0 && end < n && !(closed && i == 0);
      if (inside && in_view && length < kGapInPens * pen_mm_) {
        for (std::size_t k = i; k < end; ++k) weak_[(start + k) % n] = 1;
      }
      i = std::max(end, i + 1);
    }
  }

  void add(const RatedChain& line, std::size_t from, std::size_t to, std::vector<ShapeLine>& lines) const {
    const std::size_t n = line.chain.size();
    if (to - from < n) {  // weak ends are dropped: a line turns aside there, and would end in a hook
      while (from < to && line.strength[from % n] < kWeak) ++from;
      while (from < to && line.strength[(to - 1) % n] < kWeak) --to;
      if (from == to) return;
    }
    double length = 0, strong = 0;
    for (std::size_t i = from; i < to; ++i) {
      length += lengths_[i % n];
      if (strong_[i % n]) strong += lengths_[i % n];
    }
    if (length < kShortestInPens * pen_mm_ || strong < kStrongInPens * pen_mm_) return;
    ShapeLine out{.line_class = line.line_class, .closed = line.chain.closed && to - from == n};
    out.points.push_back(line.chain.points[from % n]);
    for (std::size_t i = from; i < to; ++i) {
      out.points.push_back(line.chain.points[i % n + 1]);
      out.faces.push_back(mesh_.triangles[line.chain.triangles[i % n]].face);
    }
    lines.push_back(std::move(out));
  }

  const FormMesh& mesh_;
  const View& view_;
  double pen_mm_;
  std::vector<double> lengths_;
  std::vector<std::uint8_t> weak_, strong_;
};

}  // namespace

std::vector<ShapeLine> find_shape_lines(const Scene& scene, const Topology& topology, const View& view, LineClasses classes,
                                        const ContourOptions& options) {
  const ShapeFields fields = shape_fields(scene, topology, options.borders);
  std::vector<RatedChain> rated;
  if (classes.has(LineClass::suggestive)) add_suggestive(fields, view.camera, rated);
  if (classes.has(LineClass::ridge) || classes.has(LineClass::valley)) {
    for (const int sign : {1, -1}) add_extrema(fields, view.camera, classes, sign, rated);
  }
  std::vector<ShapeLine> lines;
  Cutter cutter(fields.mesh, view, options.pen_width_mm);
  for (const RatedChain& line : rated) cutter.cut(line, lines);
  return lines;
}

}  // namespace ligne
