#pragma once
/// Smooth surfaces of a scene as triangles that know their neighbours, for strokes that follow the form.

#include <array>
#include <cstdint>
#include <vector>

#include "base/no_index.hpp"
#include "scene/model/topology.hpp"

namespace ligne {

struct FormTriangle {
  std::array<std::uint32_t, 3> node{};
  /// The triangle beyond the edge from corner k to the next one; kNone where the surface ends, at borders and creases.
  std::array<std::uint32_t, 3> across{kNone, kNone, kNone};
  std::uint32_t face = kNone;
};

/// Nodes are vertices of the scene, one for each surface that meets there, so that a normal is that of one surface.
/// Neighbours are wound alike, but where a surface has one side only.
struct FormMesh {
  std::vector<Point3> points, normals;  ///< of nodes; a normal is of unit length, or zero
  std::vector<double> areas;            ///< of nodes: a third of those of their triangles
  std::vector<std::uint32_t> vertex;    ///< of nodes, in the scene
  std::vector<FormTriangle> triangles;  ///< ordered by face
  std::vector<std::uint32_t> first;     ///< of each face, and the number of all

  Point3 point(std::uint32_t triangle, int corner) const { return points[triangles[triangle].node[corner]]; }
  /// Along the normal, twice the area long.
  Point3 area_vector(std::uint32_t triangle) const;
};

/// Surfaces end where faces turn by more than `crease_degrees`; with `creases`, which says it of each edge of the topology,
/// at these, and where faces turn by more than twice the angle. O(n log n).
FormMesh form_mesh(const Scene& scene, const Topology& topology, double crease_degrees,
                   const std::vector<std::uint8_t>* creases = nullptr);

/// The vector at length 1; zero stays zero.
Point3 unit(const Point3& v);

/// The corner of `next` that is at the scene's vertex of the node, or -1.
int corner_at(const FormMesh& mesh, std::uint32_t next, std::uint32_t node);

}  // namespace ligne
