#pragma once
/// Finds faces and objects that are stored twice.

#include <cstdint>
#include <vector>

#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"

namespace ligne {

/// The face that replaces each face.
struct DuplicateFaces {
  std::vector<std::uint32_t> first;  ///< per face: the face that replaces it, mostly itself; empty if none is replaced
  std::size_t objects = 0;           ///< number of objects that coincide with an earlier one
  std::size_t faces = 0;             ///< number of replaced faces
};

/// Finds two kinds of duplicates: faces of each object that have the contours of an earlier one (duplicate_faces.cpp), and
/// objects whose faces are exactly the faces of an earlier object. A face on a face of another object is not a duplicate
/// otherwise: if two bodies stand on each other, both keep their own. `within_objects`: whether to look for the first
/// kind.
DuplicateFaces find_duplicate_faces(const Scene& scene, bool within_objects = true);

/// Whether triangles of one object may have the same corners: such triangles share two edges at their lowest vertex.
/// False is certain; true is not.
bool may_repeat_triangles(const Topology& topology);

/// Drops the replaced faces. An edge stays marked as hidden or inner if all its faces mark it, and as part of a curve
/// if one does. Details move to the replacing face. Objects may be left without faces.
void drop_duplicate_faces(Scene& scene, const DuplicateFaces& duplicates);

}  // namespace ligne
