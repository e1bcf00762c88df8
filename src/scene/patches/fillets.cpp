#include "scene/patches/fillets.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <numbers>
#include <utility>

#include "base/no_index.hpp"
#include "scene/patches/face_lines.hpp"

namespace ligne {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;
/// Adjustable. Largest turn of a fillet, in radians. A strip that turns farther is a rod or a bead.
constexpr double kMostTurn = 200.0 / 360 * kTurn;
/// Adjustable. Least ratio between the lengths of the tangent borders on both sides of a fillet, the shorter to the
/// longer.
constexpr double kBothSides = 0.5;

/// Per patch: its triangles.
struct PatchTriangles {
  std::vector<std::uint32_t> begin, triangles;
  std::span<const std::uint32_t> of(std::size_t patch) const {
    return {triangles.data() + begin[patch], triangles.data() + begin[patch + 1]};
  }
};

PatchTriangles triangles_of_patches(const Topology& topology, const Patches& patches) {
  PatchTriangles found;
  found.begin.assign(patches.list.size() + 1, 0);
  const auto patch_of = [&](const Triangle& t) { return patches.patch_of[t.face]; };
  for (const Triangle& t : topology.triangles) {
    if (patch_of(t) != kNone) ++found.begin[patch_of(t) + 1];
  }
  for (std::size_t p = 0; p < patches.list.size(); ++p) found.begin[p + 1] += found.begin[p];
  found.triangles.resize(found.begin.back());
  std::vector<std::uint32_t> next(found.begin.begin(), found.begin.end() - 1);
  for (std::uint32_t t = 0; t < topology.triangles.size(); ++t) {
    if (const std::uint32_t p = patch_of(topology.triangles[t]); p != kNone) found.triangles[next[p]++] = t;
  }
  return found;
}

/// Reduces a difference of two angles to [-pi, pi].
double turned(double angle) { return std::remainder(angle, kTurn); }

/// Measures the angle across a strip: about the axis of a cylinder, about the middle circle of a torus.
class AngleAcross {
 public:
  explicit AngleAcross(const PatchSurface& surface) : surface_(surface), frame_(frame_of(surface.axis)) {}

  double operator()(const Point3& p) const {
    const AxisPlace place = axis_place(surface_, p);
    if (surface_.kind == SurfaceKind::torus) return std::atan2(place.along, place.radius - surface_.radius);
    return std::atan2(glm::dot(place.out, frame_[1]), glm::dot(place.out, frame_[0]));
  }

 private:
  const PatchSurface& surface_;
  std::array<Point3, 2> frame_;
};

/// The arc across a patch that its corners span.
struct Arc {
  double middle = 0, turn = kTurn;  ///< radians
};

class FilletFinder {
 public:
  FilletFinder(const Scene& scene, const Topology& topology, const Patches& patches, std::span<const PatchEdge> edges,
               double widest)
      : scene_(scene),
        topology_(topology),
        patches_(patches),
        edges_(edges),
        widest_(widest),
        triangles_(triangles_of_patches(topology, patches)),
        arcs_(patches.list.size()),
        strips_(patches.list.size(), 0) {}

  FilletMiddles run() {
    find_strips();
    FilletMiddles found{strips_, {}};
    for (std::uint32_t p = 0; p < strips_.size(); ++p) {
      if (!strips_[p]) continue;
      const AngleAcross angle(patches_.list[p].surface);
      add_zero_lines(
          scene_, topology_, triangles_.of(p), [&](const Point3& q) { return turned(angle(q) - arcs_[p].middle); }, {},
          found.lines);
    }
    add_corners(found);
    return found;
  }

 private:
  const Point3& point(std::uint32_t t, std::size_t corner) const {
    return scene_.vertices[topology_.triangles[t].v[corner]];
  }

  /// `last_patch`: per vertex, the last patch for which it was measured.
  Arc arc_of(std::uint32_t p, std::vector<std::uint32_t>& last_patch) const {
    const AngleAcross angle(patches_.list[p].surface);
    std::vector<double> angles;
    for (const std::uint32_t t : triangles_.of(p)) {
      for (const std::uint32_t v : topology_.triangles[t].v) {
        if (std::exchange(last_patch[v], p) != p) angles.push_back(angle(scene_.vertices[v]));
      }
    }
    if (angles.empty()) return {};
    std::sort(angles.begin(), angles.end());
    double gap = angles.front() + kTurn - angles.back();
    std::size_t after = 0;
    for (std::size_t i = 1; i < angles.size(); ++i) {
      if (angles[i] - angles[i - 1] <= gap) continue;
      gap = angles[i] - angles[i - 1];
      after = i;
    }
    return {angles[after] + (kTurn - gap) / 2, kTurn - gap};
  }

  /// Calls visit(patch, edge) for the tangent borders of all patches.
  template <class Visit>
  void for_tangent_borders(Visit visit) const {
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      if (edges_[e] != PatchEdge::tangent) continue;
      const Edge& edge = topology_.edges[e];
      for (const std::uint32_t face : {edge.face0, edge.face1}) {
        if (const std::uint32_t p = patches_.patch_of[face]; p != kNone) visit(p, edge);
      }
    }
  }

  /// Finds the narrow patches that have tangent borders on both sides.
  void find_strips() {
    std::vector<std::uint8_t> is_narrow(strips_.size(), 0), has_tangent(strips_.size(), 0);
    std::vector<std::uint32_t> last_patch(scene_.vertices.size(), kNone);
    for_tangent_borders([&](std::uint32_t p, const Edge&) { has_tangent[p] = 1; });
    for (std::uint32_t p = 0; p < strips_.size(); ++p) {
      const PatchSurface& s = patches_.list[p].surface;
      if (!has_tangent[p] || (s.kind != SurfaceKind::cylinder && s.kind != SurfaceKind::torus)) continue;
      const double radius = s.kind == SurfaceKind::torus ? s.tube : s.radius;
      arcs_[p] = arc_of(p, last_patch);
      is_narrow[p] = arcs_[p].turn <= kMostTurn && arcs_[p].turn * radius <= widest_;
    }
    std::vector<std::array<double, 2>> sides(strips_.size(), {0, 0});  // lengths of tangent borders
    for_tangent_borders([&](std::uint32_t p, const Edge& edge) {
      if (!is_narrow[p]) return;
      const Point3 &a = scene_.vertices[edge.v0], &b = scene_.vertices[edge.v1];
      const double place = turned(AngleAcross(patches_.list[p].surface)((a + b) * 0.5) - arcs_[p].middle);
      // Borders near the middle are the ends of the strip.
      if (std::abs(place) < arcs_[p].turn / 4) return;
      sides[p][place > 0] += glm::distance(a, b);
    });
    for (std::uint32_t p = 0; p < strips_.size(); ++p) {
      const auto [least, most] = std::minmax(sides[p][0], sides[p][1]);
      strips_[p] = is_narrow[p] && least > 0 && least >= kBothSides * most;
    }
  }

  /// Adds the small spheres at the ends of strips.
  void add_corners(FilletMiddles& found) const {
    // The borders at which strips of cylinders end at spheres, by sphere and strip.
    struct End {
      Point3 sum{0, 0, 0};
      double length = 0;
    };
    std::map<std::pair<std::uint32_t, std::uint32_t>, End> ends;
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      if (edges_[e] != PatchEdge::tangent) continue;
      const Edge& edge = topology_.edges[e];
      std::uint32_t p = patches_.patch_of[edge.face0], q = patches_.patch_of[edge.face1];
      if (p == kNone || q == kNone) continue;
      if (patches_.list[p].surface.kind != SurfaceKind::sphere) std::swap(p, q);
      if (patches_.list[p].surface.kind != SurfaceKind::sphere || !strips_[q]) continue;
      if (patches_.list[q].surface.kind != SurfaceKind::cylinder) continue;
      const double length = glm::distance(scene_.vertices[edge.v0], scene_.vertices[edge.v1]);
      End& end = ends[{p, q}];
      end.sum += length / 2 * (scene_.vertices[edge.v0] + scene_.vertices[edge.v1]);
      end.length += length;
    }
    for (const auto& [key, end] : ends) {
      const auto& [sphere, strip] = key;
      const PatchSurface& ball = patches_.list[sphere].surface;
      if (ball.radius * std::numbers::pi / 2 > widest_) continue;
      found.is_fillet[sphere] = 1;
      // The line lies in the plane through the axis and the middle of the strip. It runs from the end of the strip to
      // the middle of the corner.
      const PatchSurface& s = patches_.list[strip].surface;
      const auto [u, v] = frame_of(s.axis);
      const double angle = arcs_[strip].middle;
      const Point3 across = -std::sin(angle) * u + std::cos(angle) * v;
      const Point3 middle = middle_direction(sphere);
      Point3 towards = end.sum / end.length - ball.at;
      towards -= glm::dot(towards, middle) * middle;
      add_zero_lines(
          scene_, topology_, triangles_.of(sphere), [&](const Point3& p) { return glm::dot(p - s.at, across); },
          [&](const Point3& p) { return glm::dot(p - ball.at, towards); }, found.lines);
    }
  }

  /// Unit vector from the centre of a sphere to the middle of its patch.
  Point3 middle_direction(std::uint32_t sphere) const {
    Point3 sum(0, 0, 0);
    for (const std::uint32_t t : triangles_.of(sphere)) {
      sum += glm::cross(point(t, 1) - point(t, 0), point(t, 2) - point(t, 0));
    }
    const double length = glm::length(sum);
    if (!(length > 0)) return {0, 0, 1};
    return patches_.list[sphere].outward ? sum / length : -sum / length;
  }

  const Scene& scene_;
  const Topology& topology_;
  const Patches& patches_;
  std::span<const PatchEdge> edges_;
  double widest_;
  PatchTriangles triangles_;
  std::vector<Arc> arcs_;             ///< per patch
  std::vector<std::uint8_t> strips_;  ///< per patch
};

}  // namespace

FilletMiddles fillet_middles(const Scene& scene, const Topology& topology, const Patches& patches,
                             std::span<const PatchEdge> edges, double widest) {
  if (patches.list.empty()) return {};
  return FilletFinder(scene, topology, patches, edges, widest).run();
}

}  // namespace ligne
