#pragma once
/// Faces and objects that are stored twice.

#include <cstdint>
#include <vector>

#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"

namespace ligne {

/// The face that stands for each face.
struct DuplicateFaces {
  std::vector<std::uint32_t> first;  ///< per face the face that stands for it, mostly itself; empty: each for itself
  std::size_t objects = 0;           ///< that coincide with an earlier one
  std::size_t faces = 0;             ///< for which another one stands
};

/// Finds the faces of each object that have the same contours as an earlier one (face_key.hpp), and the objects all of whose
/// faces lie exactly on those of an earlier object, which has no others. A face of one object that lies on a face of another
/// one is no duplicate otherwise: where two bodies stand on each other both have their own.
/// `within_objects`: whether the first kind is looked for.
DuplicateFaces find_duplicate_faces(const Scene& scene, bool within_objects = true);

/// Whether triangles of one object may have the same corners: at their lowest vertex these have two edges in common. False
/// is certain.
bool may_repeat_triangles(const Topology& topology);

/// Leaves out the faces for which another one stands. An edge stays marked as hidden or inner when all its faces say so, and
/// as part of a curve when one does. Details move. Objects may stay without faces.
void drop_duplicate_faces(Scene& scene, const DuplicateFaces& duplicates);

}  // namespace ligne
