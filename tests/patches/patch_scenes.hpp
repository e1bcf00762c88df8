#pragma once
/// Meshes of known surfaces.

#include "scene/creases/face_normals.hpp"
#include "scene/model/bounds.hpp"
#include "scene/patches/borders/patch_edges.hpp"
#include "support/scene_parts.hpp"
#include "support/standard.hpp"

namespace ligne::test {

inline constexpr double kPi = std::numbers::pi;
using Corners = std::vector<Point3>;

/// A scene of one object, of polygons. Coordinates are those of float32, as in STL, where they are not to stay exact.
inline Scene scene_of(const std::vector<Corners>& polygons, bool exact = false) {
  constexpr double kExact = 1e-12;
  Scene scene;
  for (const Corners& polygon : polygons) {
    std::vector<std::uint32_t> corners;
    for (const Point3& p : polygon) {
      corners.push_back(static_cast<std::uint32_t>(scene.vertices.size()));
      scene.vertices.push_back(exact ? p : Point3(glm::vec3(p)));
    }
    scene.faces.add_face(corners);
  }
  Object object;
  object.vertex_end = static_cast<std::uint32_t>(scene.vertices.size());
  object.face_end = static_cast<std::uint32_t>(scene.faces.size());
  double largest = 0;
  for (const Point3& p : scene.vertices) largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  object.precision = exact ? kExact : largest * 0x1p-25;
  scene.objects.push_back(object);
  finish(scene);
  return scene;
}

/// Quadrilaterals of a surface point(u, v) over [0, columns] x [0, rows], as two triangles each where asked.
inline void add_grid(std::vector<Corners>& polygons, int columns, int rows, bool triangles,
                     const std::function<Point3(int, int)>& point) {
  for (int v = 0; v < rows; ++v) {
    for (int u = 0; u < columns; ++u) {
      const Point3 a = point(u, v), b = point(u + 1, v), c = point(u + 1, v + 1), d = point(u, v + 1);
      if (triangles) {
        polygons.push_back({a, b, c});
        polygons.push_back({a, c, d});
      } else {
        polygons.push_back({a, b, c, d});
      }
    }
  }
}

inline Point3 on_circle(double radius, double angle, double z = 0) {
  return {radius * std::cos(angle), radius * std::sin(angle), z};
}

/// The patches found in a scene.
struct FoundPatches {
  Scene scene;
  Topology topology;
  MeshAngles angles;
  Patches patches;
  std::vector<PatchEdge> edges;

  explicit FoundPatches(Scene made, double sharp = kSurfaceCreaseDegrees)
      : scene(std::move(made)),
        topology(build_topology(scene)),
        angles(mesh_angles(scene, topology, object_sizes(scene))),
        patches(find_patches(scene, topology, angles)),
        edges(classify_patch_edges(scene, topology, angles, patches, sharp)) {}
  explicit FoundPatches(const std::vector<Corners>& polygons) : FoundPatches(scene_of(polygons)) {}

  std::size_t count(PatchEdge kind) const { return static_cast<std::size_t>(std::count(edges.begin(), edges.end(), kind)); }
  /// Surfaces that faces have, by the number of these faces.
  std::map<std::uint32_t, std::size_t> faces() const {
    std::map<std::uint32_t, std::size_t> counts;
    for (const std::uint32_t p : patches.patch_of) {
      if (p != kNone) ++counts[p];
    }
    return counts;
  }
  const PatchSurface& only() const { return patches.list[faces().begin()->first].surface; }
};

/// The polygons of a convex body about the origin, all wound so that they look away from it.
inline std::vector<Corners> outward(std::vector<Corners> polygons) {
  for (Corners& polygon : polygons) {
    const Point3 normal = glm::cross(polygon[1] - polygon[0], polygon[2] - polygon[0]);
    if (glm::dot(normal, polygon[0]) < 0) std::reverse(polygon.begin(), polygon.end());
  }
  return polygons;
}

/// A box of half the size `size` with fillets of radius 1 along its edges, of `steps` facets each.
inline std::vector<Corners> rounded_box(const Point3& size, int steps) {
  std::vector<Corners> polygons;
  const Point3 inner = size - Point3(1, 1, 1);
  // An eighth of a sphere about each corner of the inner box; its points by directions, so that neighbours share them.
  const auto corner = [&](int i) {
    return Point3(i & 1 ? inner.x : -inner.x, i & 2 ? inner.y : -inner.y, i & 4 ? inner.z : -inner.z);
  };
  const auto sign = [&](int i, int axis) { return i >> axis & 1 ? 1.0 : -1.0; };
  for (int i = 0; i < 8; ++i) {
    const auto point = [&](int k, int ring) {
      const double up = kPi / 2 * ring / steps, around = kPi / 2 * k / steps;
      return corner(i) + Point3(sign(i, 0) * std::cos(up) * std::cos(around), sign(i, 1) * std::cos(up) * std::sin(around),
                                sign(i, 2) * std::sin(up));
    };
    for (int ring = 0; ring < steps; ++ring) {
      for (int k = 0; k < steps; ++k) {
        Corners polygon{point(k, ring), point(k + 1, ring), point(k + 1, ring + 1), point(k, ring + 1)};
        if (ring + 1 == steps) polygon.pop_back();
        polygons.push_back(polygon);
      }
    }
  }
  // Cylinders along each axis, and the six sides.
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (int su = 0; su < 2; ++su) {
      for (int sv = 0; sv < 2; ++sv) {
        const int low = su << u | sv << v, high = low | 1 << axis;
        const auto point = [&](int i, int k) {
          Point3 p = corner(i);
          p[u] += sign(i, u) * std::cos(kPi / 2 * k / steps);
          p[v] += sign(i, v) * std::sin(kPi / 2 * k / steps);
          return p;
        };
        for (int k = 0; k < steps; ++k) {
          polygons.push_back({point(low, k), point(low, k + 1), point(high, k + 1), point(high, k)});
        }
      }
    }
    for (int s = 0; s < 2; ++s) {
      Corners side;
      for (const int i : {s << axis, s << axis | 1 << u, s << axis | 1 << u | 1 << v, s << axis | 1 << v}) {
        Point3 p = corner(i);
        p[axis] += sign(i, axis);
        side.push_back(p);
      }
      polygons.push_back(side);
    }
  }
  return outward(std::move(polygons));
}

/// A half space: its inside lies against the direction of the normal.
struct HalfSpace {
  Point3 at, normal;
};

/// The polygons of the convex body that half spaces have in common, as CSG makes it of bodies with flat faces. `size`: more
/// than the distance of any corner from the origin.
inline std::vector<Corners> common_body(const std::vector<HalfSpace>& spaces, double size) {
  const auto rounded = [](const Point3& p) {
    constexpr double kGrid = 1e-5;  // corners that several polygons share get the same coordinates
    return Point3(std::round(p.x / kGrid) * kGrid, std::round(p.y / kGrid) * kGrid, std::round(p.z / kGrid) * kGrid);
  };
  std::vector<Corners> polygons;
  for (const HalfSpace& own : spaces) {
    const Point3 u =
        glm::normalize(glm::cross(own.normal, std::abs(own.normal.z) < 0.9 ? Point3(0, 0, 1) : Point3(1, 0, 0)));
    const Point3 v = glm::cross(own.normal, u), middle = own.at - glm::dot(own.at, u) * u - glm::dot(own.at, v) * v;
    Corners polygon{middle - size * u - size * v, middle + size * u - size * v, middle + size * u + size * v,
                    middle - size * u + size * v};
    for (const HalfSpace& other : spaces) {
      if (&other == &own) continue;
      Corners kept;
      for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Point3 &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
        const double from = glm::dot(a - other.at, other.normal), to = glm::dot(b - other.at, other.normal);
        if (from <= 0) kept.push_back(a);
        if ((from <= 0) != (to <= 0)) kept.push_back(a + from / (from - to) * (b - a));
      }
      polygon = kept;
    }
    Corners corners;
    for (const Point3& p : polygon) {
      if (corners.empty() || rounded(p) != corners.back()) corners.push_back(rounded(p));
    }
    if (corners.size() > 1 && corners.front() == corners.back()) corners.pop_back();
    if (corners.size() > 2) polygons.push_back(corners);
  }
  return polygons;
}

/// A ball of flat facets, so many to a turn about z, cut by a prism of as many sides about x: a plug whose corners at the
/// cuts lie on chords of the sphere or the cylinder.
inline std::vector<Corners> csg_plug(double ball, double plug, int facets) {
  std::vector<HalfSpace> spaces;
  const int rings = facets / 2;
  const auto at = [&](int ring, int k) {
    const double angle = kPi * (ring + 0.5) / rings;
    return on_circle(ball * std::sin(angle), 2 * kPi * k / facets, ball * std::cos(angle));
  };
  for (int ring = 0; ring + 1 < rings; ++ring) {
    for (int k = 0; k < facets; ++k) {
      const Point3 a = at(ring, k), b = at(ring, k + 1), c = at(ring + 1, k);
      const Point3 normal = glm::normalize(glm::cross(b - a, c - a));
      spaces.push_back({a, glm::dot(normal, a) < 0 ? -normal : normal});
    }
  }
  spaces.push_back({at(0, 0), {0, 0, 1}});
  spaces.push_back({at(rings - 1, 0), {0, 0, -1}});
  for (int k = 0; k < facets; ++k) {
    const double angle = 2 * kPi * (k + 0.5) / facets, near = plug * std::cos(kPi / facets);
    const Point3 normal(0, std::cos(angle), std::sin(angle));
    spaces.push_back({near * normal, normal});
  }
  return common_body(spaces, 2 * ball);
}

}  // namespace ligne::test
