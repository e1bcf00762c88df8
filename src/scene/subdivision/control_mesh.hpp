#pragma once
/// Makes the control mesh of an object.

#include <span>
#include <vector>

#include "scene/model/diagnostics.hpp"
#include "scene/model/scene.hpp"
#include "scene/subdivision/crease_tags.hpp"
#include "scene/subdivision/subdivision_mesh.hpp"

namespace ligne {

/// Largest ratio of a diagonal of a quad to the other one at which it counts as shorter. A smaller difference is
/// rounding, and the choice must not depend on the position of the quad.
inline constexpr double kShorterDiagonal = 1 - 1e-9;

/// Numbers of faces that are left out.
struct LeftOutFaces {
  std::size_t degenerate = 0, not_finite = 0;
};

struct ControlMesh {
  SubdivisionMesh mesh;                    ///< connected
  std::vector<std::uint32_t> face_source;  ///< per face: face of the scene
  std::size_t tagged = 0;                  ///< number of edges with a crease tag
  LeftOutFaces left_out;
};

/// Makes the control mesh of an object's faces, in a scene that is not cleaned yet. Vertices v are replaced by
/// `first[v]` (kNone: not finite). Faces with holes are cut into triangles, and so are all other polygons if
/// `triangles` is set. Faces with fewer than three distinct vertices, or with vertices that are not finite, are left
/// out. Edges that the file calls sharp (kCornerSharp) are always sharp, and so are vertices of a single face; others
/// follow the tags, which must be sorted.
ControlMesh make_control_mesh(const Scene& scene, const Object& object, std::span<const std::uint32_t> first,
                              const CreaseTags& tags, bool triangles);

}  // namespace ligne
