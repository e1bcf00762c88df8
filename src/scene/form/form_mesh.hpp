#pragma once
/// Smooth surfaces of a scene as triangles with their neighbours, for strokes that follow the form.

#include <array>
#include <cstdint>
#include <vector>

#include "base/no_index.hpp"
#include "scene/model/topology.hpp"

namespace ligne {

struct FormTriangle {
  std::array<std::uint32_t, 3> node{};
  /// Neighbour across the edge from corner k to the next one; kNone where the surface ends, at borders and creases.
  std::array<std::uint32_t, 3> across{kNone, kNone, kNone};
  std::uint32_t face = kNone;
};

/// A node is a vertex of the scene on one surface; a vertex has one node per surface at it, so that each normal is that
/// of one surface. Windings of neighbours agree, except in one-sided surfaces.
struct FormMesh {
  std::vector<Point3> points, normals;  ///< per node; normals are unit vectors or zero
  std::vector<double> areas;            ///< per node: a third of the area of its triangles
  std::vector<std::uint32_t> vertex;    ///< per node: the vertex of the scene
  std::vector<FormTriangle> triangles;  ///< ordered by face
  std::vector<std::uint32_t> first;     ///< per face: its first triangle; then the number of all triangles

  Point3 point(std::uint32_t triangle, int corner) const { return points[triangles[triangle].node[corner]]; }
  /// Vector along the normal, twice the area long.
  Point3 area_vector(std::uint32_t triangle) const;
};

/// Ends surfaces where faces turn by more than `crease_degrees`. With `creases` (not 0 per edge of the topology that is
/// one), ends them there instead, and where faces turn by more than twice the angle. O(n log n).
FormMesh form_mesh(const Scene& scene, const Topology& topology, double crease_degrees,
                   const std::vector<std::uint8_t>* creases = nullptr);

/// Scales the vector to length 1; zero stays zero.
Point3 unit(const Point3& v);

/// The corner of triangle `next` at the scene vertex of the node, or -1.
int corner_at(const FormMesh& mesh, std::uint32_t next, std::uint32_t node);

}  // namespace ligne
