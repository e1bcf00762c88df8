#include "view/edge_classes.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "geometry/large_vector.hpp"
#include "geometry/parallel.hpp"
#include "scene/model/flat_faces.hpp"
#include "geometry/prefetch.hpp"

namespace ligne {
namespace {

/// Float32 coordinates turn the normals of small faces by about this much; an edge at the crease angle itself is no crease.
constexpr double kCreaseSlackDegrees = 0.01;

struct FacePlane {
  glm::vec3 normal{0, 0, 0};  ///< unit length; zero for a face without area
  std::int8_t facing = 0;
};

std::int8_t facing_of(const Point3& normal, const Point3& on_face, const Camera& camera) {
  const Point3 sight = camera.perspective ? on_face - camera.eye : camera.forward;
  const double d = glm::dot(normal, sight);
  if (std::abs(d) <= kEdgeOnSine * glm::length(sight)) return 0;
  return d < 0 ? 1 : -1;
}

std::vector<FacePlane> face_planes(const Scene& scene, const Camera& camera) {
  std::vector<FacePlane> planes = large_vector<FacePlane>(scene.faces.size());
  const bool all_triangles = scene.faces.all_triangles();
  parallel_blocks(planes.size(), kShortWorkBlock, [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f) {
      if (all_triangles) prefetch_corners(scene.vertices, scene.faces.corners(), f);
      const Point3 normal = face_normal(scene, static_cast<std::uint32_t>(f));
      planes[f].normal = normal;
      planes[f].facing = facing_of(normal, scene.vertices[scene.faces.contour(f, 0)[0]], camera);
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
