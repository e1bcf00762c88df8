#pragma once
/// The limit surface of a control mesh in the place of its polygons (docs/subdivision.md).

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

#include "scene/model/diagnostics.hpp"
#include "scene/model/scene.hpp"
#include "scene/subdivision/crease_tags.hpp"
#include "scene/subdivision/subdivision_mesh.hpp"

namespace ligne {

/// Most triangles that subdivision may make of a scene: a few gigabytes of memory for the drawing.
inline constexpr std::size_t kMostSubdividedTriangles = std::size_t{1} << 24;
/// Most levels that can be asked for: a cube then has 50 million triangles, which is too many.
inline constexpr unsigned kMostSubdivisionLevels = 11;

struct Subdivision {
  SubdivisionScheme scheme = SubdivisionScheme::catmull_clark;
  std::optional<unsigned> levels{};  ///< 1 or more; nothing: by the size of the edges
};

struct SubdivisionRequest {
  Subdivision how;
  std::function<bool(const Object&, std::size_t)> is_wanted{};  ///< by an object and its number; none: all are
  bool mark_creases = false;  ///< the edges of the surface are kCornerSmooth or kCornerSharp; otherwise neither
};

struct SubdivisionReport {
  unsigned levels = 0;          ///< 0: nothing was subdivided
  std::size_t faces = 0;        ///< of the control mesh
  std::size_t triangles = 0;    ///< of the surface
  std::size_t sharp_edges = 0;  ///< of the control mesh, beside its borders
};

/// Takes the polygons of the objects that are wanted as control meshes: triangles take their place, with vertices on the
/// limit surface of Catmull and Clark's or Loop's scheme. The scene is as read, not cleaned. Objects, materials, names and
/// sources of faces stay; details of those faces are dropped. Edges are sharp as in make_control_mesh(); `tags` need not be
/// sorted. Without levels, there are as many as make the edges shorter than a hundredth of the scene, without more than a
/// million triangles. Throws InputError, which begins with `name`, where there would be more than kMostSubdividedTriangles.
/// Faces and details that are left out are counted in `warnings`. Time grows with the number of triangles.
SubdivisionReport subdivide(Scene& scene, const SubdivisionRequest& request, CreaseTags tags, const std::string& name,
                            Warnings& warnings);

}  // namespace ligne
