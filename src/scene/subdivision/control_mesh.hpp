#pragma once
/// The control mesh of an object.

#include <span>
#include <vector>

#include "scene/model/diagnostics.hpp"
#include "scene/model/scene.hpp"
#include "scene/subdivision/crease_tags.hpp"
#include "scene/subdivision/subdivision_mesh.hpp"

namespace ligne {

/// One diagonal of a quad is shorter than the other when it is so by more than rounding: others are alike in all positions.
inline constexpr double kShorterDiagonal = 1 - 1e-9;

/// Faces that are left out.
struct LeftOutFaces {
  std::size_t degenerate = 0, not_finite = 0;
};

struct ControlMesh {
  SubdivisionMesh mesh;                    ///< connected
  std::vector<std::uint32_t> face_source;  ///< per face, that of the scene
  std::size_t tagged = 0;                  ///< edges that a crease tag names
  LeftOutFaces left_out;
};

/// The faces of an object of a scene that is not cleaned yet, with the vertices `first[v]` (kNone: not finite) in the place
/// of its vertices. Faces with holes are cut into triangles, and with `triangles` all other polygons too; faces with fewer
/// than three distinct vertices, or not finite ones, are left out. Edges that the file calls sharp (kCornerSharp) are always
/// sharp, others are by their tags; so are vertices of a single face. Tags are sorted.
ControlMesh make_control_mesh(const Scene& scene, const Object& object, std::span<const std::uint32_t> first,
                              const CreaseTags& tags, bool triangles);

}  // namespace ligne
