#pragma once
/// Keeps the parts of a scene consistent when faces or vertices are removed.

#include <cstdint>
#include <vector>

#include "scene/model/diagnostics.hpp"
#include "scene/model/scene.hpp"

namespace ligne {

/// Drops unused vertices and renumbers the others; their order stays. Copies nothing if all are used.
void drop_unused_vertices(Scene& scene);

/// Replaces each vertex v by target[v], in a scene that uses all vertices, and drops the replaced ones; the order of
/// the others stays. A target must be its own target, in the object of the vertex.
void merge_vertices(Scene& scene, std::vector<std::uint32_t> target);

/// Carries objects and details over to new face numbers. `first_new[f]` is the number of the first face made from face
/// f, or of the next kept one if f was dropped; it has one entry more than there were faces. Details of dropped faces
/// are dropped and counted.
void renumber_faces(Scene& scene, const std::vector<std::uint32_t>& first_new, Warnings& warnings);

}  // namespace ligne
