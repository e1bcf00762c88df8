#pragma once
/// The kinds of edges by the angles of their faces and by what the file says of them.

#include <cstddef>
#include <span>
#include <vector>

#include "scene/creases/bend.hpp"
#include "scene/creases/face_normals.hpp"
#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"

namespace ligne {

struct FaceBends {
  std::vector<Bend> bends;                            ///< per edge
  std::size_t smooth_by_file = 0, sharp_by_file = 0;  ///< edges that only the file takes for smooth, or for sharp
};

/// The cosine between the normals of two faces below which their edge is a crease. It allows for the rounding of the
/// normals.
float crease_cosine(double degrees);

/// The bends of all edges. `sizes` are those of object_sizes(), per object.
FaceBends bends_by_faces(const Scene& scene, const Topology& topology, const MeshAngles& angles,
                         std::span<const double> sizes, double crease_degrees);

}  // namespace ligne
