#pragma once
/// Makes the scene of the needed part of a streamed model.

#include <cstdint>
#include <vector>

#include "scene/model/scene.hpp"
#include "scene/readers/triangle_file.hpp"
#include "visibility/stream/page_layers.hpp"

namespace ligne {

/// Makes a scene of one object with the given triangles of the file (ascending) and those that keep clusters of vertices
/// whole. Faces and vertices have the same order as in the whole scene of read_scene(). For that, vertices are ordered
/// by the first vertex of the file at their position, whether or not a kept triangle uses it.
Scene scene_of_needed(const TriangleFile& file, const StreamFacets& facets, std::vector<std::uint32_t> triangles);

}  // namespace ligne
