#pragma once
/// Normals of faces, including slivers, and the angles between them.

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"

namespace ligne {

/// Unit normals of all faces, in the direction of their winding. A triangle no higher than the precision of its
/// coordinates has a random normal, so it takes that of its neighbour across its longest edge. If that is such a sliver
/// too, the chain of longest edges is followed to the next face that has a normal. If it finds none, the triangle keeps
/// its own normal. Zero without a neighbour or without area.
std::vector<glm::vec3> face_normals(const Scene& scene, const Topology& topology);

/// The cosine of edges of one face in MeshAngles: less than that of any angle.
inline constexpr float kNoCosine = -2;

/// The normals and heights of triangles, for quick tests that nearly all triangles pass.
struct TriangleShapes {
  std::vector<glm::vec3> normals;  ///< per face, as of face_normals()
  /// Per face: square of its least height, in `height_units` of its object. Empty if not all faces are triangles.
  std::vector<float> heights;
  std::vector<double> height_units;  ///< per object: square of the distance of two triangles from one plane, with a margin
};

/// A triangle of a greater TriangleShapes::heights is no sliver, so its normal is that of its own plane.
inline constexpr float kOwnNormalHeight = 2;

/// The angles at all edges, which passes over the edges of a large mesh read in place of vertices and normals.
struct MeshAngles : TriangleShapes {
  std::vector<float> cosines;       ///< per edge: of the angle between its first two faces, computed in float32
  std::vector<std::uint32_t> flat;  ///< edges whose faces may lie in one plane, ascending: all others certainly bend
};

/// `sizes`: those of object_sizes(), per object.
MeshAngles mesh_angles(const Scene& scene, const Topology& topology, std::span<const double> sizes);

/// Gives slivers that lie in a plane the normal of that plane, and returns the edges at which they border on others, not
/// sorted. A sliver at the edge of two planes has taken its normal from one of them (face_normals()), but may belong to the
/// other: then the edge lies on its other side. `plane_edges`: see Patches.
std::vector<std::uint32_t> turn_plane_slivers(const Scene& scene, const Topology& topology,
                                              std::span<const std::uint32_t> plane_edges, std::vector<glm::vec3>& normals);

}  // namespace ligne
