#include "view/edge_classes.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "geometry/large_vector.hpp"
#include "geometry/parallel.hpp"
#include "scene/model/flat_faces.hpp"
#include "geometry/prefetch.hpp"
#include "scene/model/triangle_normal.hpp"

namespace ligne {
namespace {

/// Float32 coordinates turn the normals of small faces by about this much; an edge at the crease angle itself is no crease.
constexpr double kCreaseSlackDegrees = 0.01;

struct FacePlane {
  glm::vec3 normal{0, 0, 0};  ///< unit length; zero for a face without area
  std::int8_t facing = 0;
};

/// `sight`: a line of sight to the face, of the given length.
std::int8_t facing_of(const Point3& normal, const Point3& sight, double length) {
  const double d = glm::dot(normal, sight);
  if (std::abs(d) <= kEdgeOnSine * length) return 0;
  return d < 0 ? 1 : -1;
}

std::vector<FacePlane> face_planes(const Scene& scene, const Camera& camera) {
  std::vector<FacePlane> planes = large_vector<FacePlane>(scene.faces.size());
  const auto set_plane = [&, forward_length = glm::length(camera.forward)](FacePlane& plane, const Point3& normal,
                                                                           const Point3& on_face) {
    plane.normal = normal;
    const Point3 sight = on_face - camera.eye;
    plane.facing = camera.perspective ? facing_of(normal, sight, glm::length(sight))
                                      : facing_of(normal, camera.forward, forward_length);
  };
  const std::span<const std::uint32_t> corners = scene.faces.corners();
  const bool all_triangles = scene.faces.all_triangles();
  parallel_blocks(planes.size(), kShortWorkBlock, [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f) {
      if (all_triangles) {
        prefetch_corners(scene.vertices, corners, f);
        const Point3& a = scene.vertices[corners[3 * f]];
        const Point3 &b = scene.vertices[corners[3 * f + 1]], &c = scene.vertices[corners[3 * f + 2]];
        set_plane(planes[f], triangle_normal(a, b, c), a);
      } else {
        const auto face = static_cast<std::uint32_t>(f);
        set_plane(planes[f], face_normal(scene, face), scene.vertices[scene.faces.contour(face, 0)[0]]);
      }
    }
  });
  return planes;
}

/// Gives faces without area the plane of the face across their longest edge.
void mend_flat_faces(const Scene& scene, const Topology& topology, std::vector<FacePlane>& planes) {
  const auto is_flat = [](const FacePlane& plane) { return plane.normal == glm::vec3{0, 0, 0}; };
  if (std::none_of(planes.begin(), planes.end(), is_flat)) return;
  std::vector<std::uint8_t> flat(planes.size());
  std::transform(planes.begin(), planes.end(), flat.begin(), is_flat);
  const auto neighbours = longest_neighbours(scene, topology, flat, FlatNeighbours::passed_over);
  for (const auto& [face, neighbour] : neighbours) {
    const FacePlane& plane = planes[neighbour.face];
    planes[face] = neighbour.turned ? FacePlane{-plane.normal, static_cast<std::int8_t>(-plane.facing)} : plane;
  }
}

}  // namespace

std::vector<std::int8_t> face_facings(const Scene& scene, const Camera& camera) {
  const auto planes = face_planes(scene, camera);
  std::vector<std::int8_t> facings(planes.size());
  for (std::size_t f = 0; f < planes.size(); ++f) facings[f] = planes[f].facing;
  return facings;
}

std::vector<LineClass> classify_edges(const Scene& scene, const Topology& topology, const Camera& camera,
                                      double crease_degrees, const std::vector<std::uint8_t>* creases) {
  std::vector<FacePlane> planes = face_planes(scene, camera);
  mend_flat_faces(scene, topology, planes);
  const double degree = 3.14159265358979323846 / 180;
  const float crease_cosine = static_cast<float>(std::cos(std::min(180.0, crease_degrees + kCreaseSlackDegrees) * degree));
  std::vector<LineClass> classes(topology.edges.size());
  parallel_blocks(classes.size(), kShortWorkBlock, [&](std::size_t begin, std::size_t end) {
    for (std::size_t e = begin; e < end; ++e) {
      prefetch_faces(planes, topology.edges, e);
      const Edge& edge = topology.edges[e];
      const std::uint16_t flags = topology.edge_flags[e];
      LineClass& result = classes[e];
      if (flags & kEdgeCrossing) {
        result = LineClass::intersection;
      } else if ((flags & kEdgeContour) && edge.face1 != kNone) {
        result = LineClass::contour;
      } else if (flags & kEdgeCurve) {
        result = LineClass::horizon;
      } else if (edge.face1 == kNone) {
        result = LineClass::border;
      } else if (flags & kEdgeManyFaces) {
        // Of its faces two are known, which depend on the order of the file: no outline can be told from them.
        result = !creases || (*creases)[e] ? LineClass::crease : LineClass::mesh;
      } else {
        const FacePlane& a = planes[edge.face0];
        const FacePlane& b = planes[edge.face1];
        const int turn = flags & kEdgeUnlikeWound ? -1 : 1;
        if (a.facing != b.facing * turn) {
          result = LineClass::outline;
        } else if (creases) {
          result = (*creases)[e] ? LineClass::crease : LineClass::mesh;
        } else if (flags & (kEdgeFileHidden | kEdgeInner)) {
          result = LineClass::mesh;
        } else {
          const float cosine = glm::dot(a.normal, b.normal) * static_cast<float>(turn);
          result = cosine < crease_cosine ? LineClass::crease : LineClass::mesh;
        }
      }
    }
  });
  return classes;
}

}  // namespace ligne
