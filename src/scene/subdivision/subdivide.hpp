#pragma once
/// Replaces polygons by the limit surface of their control mesh (docs/subdivision.md).

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

#include "scene/model/diagnostics.hpp"
#include "scene/model/scene.hpp"
#include "scene/subdivision/crease_tags.hpp"
#include "scene/subdivision/subdivision_mesh.hpp"

namespace ligne {

/// Largest number of triangles that subdivision may make of a scene: a few gigabytes of memory for the drawing.
inline constexpr std::size_t kMostSubdividedTriangles = std::size_t{1} << 24;
/// Largest number of levels that can be requested: a cube then has 50 million triangles, which is too many.
inline constexpr unsigned kMostSubdivisionLevels = 11;

struct Subdivision {
  SubdivisionScheme scheme = SubdivisionScheme::catmull_clark;
  std::optional<unsigned> levels{};  ///< 1 or more; nothing: chosen by the length of the edges
};

struct SubdivisionRequest {
  Subdivision how;
  std::function<bool(const Object&, std::size_t)> is_wanted{};  ///< by an object and its number; empty: all objects
  bool mark_creases = false;  ///< mark edges of the surface as kCornerSmooth or kCornerSharp
};

struct SubdivisionReport {
  unsigned levels = 0;          ///< 0: nothing was subdivided
  std::size_t faces = 0;        ///< of the control mesh
  std::size_t triangles = 0;    ///< of the surface
  std::size_t sharp_edges = 0;  ///< of the control mesh, without its borders
};

/// Takes the polygons of the selected objects as control meshes and replaces them by triangles with vertices on the
/// limit surface of the Catmull-Clark or Loop scheme. The scene is as read, not cleaned. Objects, materials, names and
/// face sources stay; details of these faces are dropped. Edges are sharp as in make_control_mesh(); `tags` need not be
/// sorted. By default there are as many levels as make the edges shorter than a hundredth of the scene, with at most a
/// million triangles. Throws InputError, which begins with `name`, for more than kMostSubdividedTriangles. Omitted
/// faces and details are counted in `warnings`. Takes time proportional to the number of triangles.
SubdivisionReport subdivide(Scene& scene, const SubdivisionRequest& request, CreaseTags tags, const std::string& name,
                            Warnings& warnings);

}  // namespace ligne
