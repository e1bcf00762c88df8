#pragma once
/// The scene that is left of a streamed model.

#include <cstdint>
#include <vector>

#include "scene/model/scene.hpp"
#include "scene/readers/triangle_file.hpp"
#include "visibility/stream/stream_facet.hpp"

namespace ligne {

/// A scene of one object with some of the file's triangles, ascending, and those by which crowds of vertices stay whole.
/// Faces and vertices have the order of those of the whole scene, as read_scene() makes it: a place has the number of the
/// first vertex of the file there, whether a triangle that is left has it or not.
Scene scene_of_needed(const TriangleFile& file, const StreamFacets& facets, std::vector<std::uint32_t> triangles);

}  // namespace ligne
