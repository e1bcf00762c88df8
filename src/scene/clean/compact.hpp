#pragma once
/// Keeping the parts of a scene consistent when faces or vertices go.

#include <cstdint>
#include <vector>

#include "scene/model/diagnostics.hpp"
#include "scene/model/scene.hpp"

namespace ligne {

/// Drops the vertices that no face uses and renumbers the others; their order stays. Copies nothing when all are used.
void drop_unused_vertices(Scene& scene);

/// Puts the vertices target[v] in the place of the vertices v of a scene that uses all of them, and drops those that went
/// elsewhere; the order of the others stays. A target stays where it is, in the object of the vertex.
void merge_vertices(Scene& scene, std::vector<std::uint32_t> target);

/// Carries objects and details over to new face numbers. `first_new[f]` is the number of the first face made of face f, or
/// of the next one that is kept when f was dropped; it has one entry more than there were faces. Details of dropped faces
/// are dropped and counted.
void renumber_faces(Scene& scene, const std::vector<std::uint32_t>& first_new, Warnings& warnings);

}  // namespace ligne
