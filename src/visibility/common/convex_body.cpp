#include "visibility/common/convex_body.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "base/disjoint_sets.hpp"
#include "base/no_index.hpp"
#include "geometry/convex_hull.hpp"
#include "visibility/common/facet.hpp"

namespace ligne::convexity {
namespace {

/// A side of a triangle, given by the places of its ends.
struct Side {
  std::uint32_t low, high;
  std::uint32_t triangle;
  bool upwards;  ///< runs from `low` to `high`
};

LatticePoint at(const ProjectedScene& scene, std::uint32_t v) { return scene.vertices[v].p; }

double area_of(const ProjectedScene& scene, const Triangle& t) {
  return orientation(at(scene, t.v[0]), at(scene, t.v[1]), at(scene, t.v[2]));
}

std::vector<Side> sides_of(const ProjectedScene& scene) {
  std::vector<Side> sides;
  sides.reserve(3 * scene.triangles.size());
  for (std::uint32_t i = 0; i < scene.triangles.size(); ++i) {
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t a = scene.place(scene.triangles[i].v[k]), b = scene.place(scene.triangles[i].v[(k + 1) % 3]);
      sides.push_back({std::min(a, b), std::max(a, b), i, a < b});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return std::array{a.low, a.high, a.triangle} < std::array{b.low, b.high, b.triangle};
  });
  return sides;
}

/// Depth within which something touches the triangle.
double tolerance_of(const ProjectedScene& scene, const Triangle& t) {
  const ProjectedVertex &a = scene.vertices[t.v[0]], &b = scene.vertices[t.v[1]], &c = scene.vertices[t.v[2]];
  const double abx = double(b.p.x) - a.p.x, aby = double(b.p.y) - a.p.y, acx = double(c.p.x) - a.p.x,
               acy = double(c.p.y) - a.p.y;
  const double zb = b.z - a.z, zc = c.z - a.z;
  const double gradient = (std::abs(zb * acy - zc * aby) + std::abs(zc * abx - zb * acx)) / std::abs(area_of(scene, t));
  return depth_tolerance_mm(scene, gradient, std::min({a.z, b.z, c.z}));
}

/// Position of the vertex relative to the plane of a triangle with area: -1 in front, 1 behind, 0 within the tolerance.
/// Each corner of the triangle may be off by the tolerance, weighted as its depth is.
int side_of(const ProjectedScene& scene, const Triangle& t, double tolerance, std::uint32_t vertex) {
  const ProjectedVertex* p[3] = {&scene.vertices[t.v[0]], &scene.vertices[t.v[1]], &scene.vertices[t.v[2]]};
  const double area = orientation(p[0]->p, p[1]->p, p[2]->p);
  const ProjectedVertex& q = scene.vertices[vertex];
  double depth = 0, weights = 0;
  for (int k = 0; k < 3; ++k) {
    const double weight = orientation(p[(k + 1) % 3]->p, p[(k + 2) % 3]->p, q.p) / area;
    depth += weight * p[k]->z;
    weights += std::abs(weight);
  }
  return depth - q.z > weights * tolerance ? -1 : q.z - depth > weights * tolerance ? 1 : 0;
}

/// Whether a corner of `other` lies outside the plane of `t`: in front of it if `t` is a front triangle, else behind
/// it.
bool is_concave(const ProjectedScene& scene, const Triangle& t, const Triangle& other, bool front) {
  const double tolerance = tolerance_of(scene, t);
  const int outside = front ? -1 : 1;
  return std::any_of(std::begin(other.v), std::end(other.v),
                     [&](std::uint32_t v) { return side_of(scene, t, tolerance, v) == outside; });
}

/// Twice the area of the convex hull of all vertices that triangles use, and the length of its border in |dx| + |dy|.
std::array<double, 2> hull_of(const ProjectedScene& scene) {
  std::vector<LatticePoint> points;
  for (const Triangle& t : scene.triangles) {
    for (const std::uint32_t v : t.v) points.push_back(at(scene, v));
  }
  return area_and_border(convex_hull(std::move(points)));
}

}  // namespace

std::array<double, 2> area_and_border(const std::vector<LatticePoint>& hull) {
  double area = 0, border = 0;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const LatticePoint a = hull[i], b = hull[i + 1 == hull.size() ? 0 : i + 1];
    area += orientation(hull[0], a, b);
    border += std::abs(double(b.x) - a.x) + std::abs(double(b.y) - a.y);
  }
  return {area, border};
}

Faces face_the_viewer(const ProjectedScene& scene) {
  Faces faces;
  std::uint32_t count = 0;
  for (const Triangle& t : scene.triangles) count = std::max(count, t.face + 1);
  std::vector<double> areas(count, 0);
  // Six times the volume between each triangle and the plane of depth 0.
  double& volume = faces.volume;
  for (const Triangle& t : scene.triangles) {
    const double area = area_of(scene, t);
    volume += area * (scene.vertices[t.v[0]].z + scene.vertices[t.v[1]].z + scene.vertices[t.v[2]].z);
    if (!scene.is_edge_on(t)) areas[t.face] += area;
  }
  // The front is nearer, so its areas are negative if the volume is positive.
  const double of_front = volume > 0 ? -1 : 1;
  faces.facing.assign(count, Facing::edge_on);
  faces.known.assign(count, 0);
  for (const Triangle& t : scene.triangles) faces.known[t.face] = 1;
  for (std::uint32_t f = 0; f < count; ++f) {
    if (!faces.known[f]) continue;
    if (areas[f] != 0) faces.facing[f] = areas[f] * of_front > 0 ? Facing::front : Facing::back;
    ++(faces.facing[f] == Facing::front ? faces.front : faces.facing[f] == Facing::back ? faces.back : faces.edge_on);
  }
  return faces;
}

bool looks_like_one_convex_body(const ProjectedScene& scene) {
  // Adjustable: a dent between the samples is found by why_not_one_convex_body().
  constexpr std::size_t kSamples = 64;
  if (scene.triangles.empty()) return false;
  const auto has_end = [](const ProjectedEdge& e) { return e.face0 == kNone || e.face1 == kNone; };
  if (std::any_of(scene.edges.begin(), scene.edges.end(), has_end)) return false;
  if (std::ranges::count(scene.face_is_transparent, std::uint8_t{0}) != std::ssize(scene.face_is_transparent)) return false;
  const std::size_t step = std::max<std::size_t>(1, scene.triangles.size() / kSamples);
  for (std::size_t i = 0; i < scene.triangles.size(); i += step) {
    const Triangle& t = scene.triangles[i];
    if (scene.is_edge_on(t) || area_of(scene, t) == 0) continue;
    const double tolerance = tolerance_of(scene, t);
    bool before = false, behind = false;
    for (std::size_t k = 0; k < scene.triangles.size(); k += step) {
      for (const std::uint32_t v : scene.triangles[k].v) {
        const int side = side_of(scene, t, tolerance, v);
        before = before || side < 0;
        behind = behind || side > 0;
      }
    }
    if (before && behind) return false;
  }
  return true;
}

std::string why_not_one_convex_body(const ProjectedScene& scene, const Faces& faces) {
  if (scene.triangles.empty()) return "it has no faces in view";
  for (const Triangle& t : scene.triangles) {
    if (t.face < scene.face_is_transparent.size() && scene.face_is_transparent[t.face]) return "faces are transparent";
  }
  const std::vector<Side> sides = sides_of(scene);
  DisjointSets sets(scene.triangles.size());
  for (std::size_t i = 0; i < sides.size(); i += 2) {
    const bool two = i + 1 < sides.size() && sides[i].low == sides[i + 1].low && sides[i].high == sides[i + 1].high &&
                     sides[i].upwards != sides[i + 1].upwards;
    const bool more = i + 2 < sides.size() && sides[i].low == sides[i + 2].low && sides[i].high == sides[i + 2].high;
    if (!two || more) return "it is not a closed body entirely in view";
    sets.join(sides[i].triangle, sides[i + 1].triangle);
  }
  for (std::uint32_t i = 0; i < scene.triangles.size(); ++i) {
    if (sets.find(i) != 0) return "it is more than one body";
  }
  const auto has_triangles = [&](std::uint32_t face) { return face < faces.known.size() && faces.known[face]; };
  for (const ProjectedEdge& e : scene.edges) {
    const bool of_no_face = e.face0 == kNone && e.face1 == kNone;
    if (!of_no_face && !(has_triangles(e.face0) && has_triangles(e.face1))) return "some faces occur more than once";
  }
  const auto concave = [&](const Triangle& t, const Triangle& other) {
    const Facing facing = faces.facing[t.face];
    return facing != Facing::edge_on && area_of(scene, t) != 0 && is_concave(scene, t, other, facing == Facing::front);
  };
  for (std::size_t i = 0; i < sides.size(); i += 2) {
    const Triangle &a = scene.triangles[sides[i].triangle], &b = scene.triangles[sides[i + 1].triangle];
    if (concave(a, b) || concave(b, a)) return "it is not convex";
  }
  double front = 0, six_times_tolerance = 0;
  for (const Triangle& t : scene.triangles) {
    const double area = std::abs(area_of(scene, t));
    if (faces.facing[t.face] == Facing::edge_on || area == 0) continue;
    if (faces.facing[t.face] == Facing::front) front += area;
    six_times_tolerance += 3 * area * tolerance_of(scene, t);
  }
  if (std::abs(faces.volume) <= six_times_tolerance) return "it has no volume";
  const auto [hull, border] = hull_of(scene);
  if (std::abs(hull - front) > 2 * border) return "it is not convex";
  return "";
}

}  // namespace ligne::convexity
