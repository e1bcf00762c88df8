#pragma once
/// [Boulle1980] 2.2.2.6: transparent faces are taken out of the description model before the study.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "view/projected_scene.hpp"

namespace ligne {

struct OpaqueScene {
  ProjectedScene scene;
  std::size_t faces_left_out = 0;

  std::string left_out() const { return std::to_string(faces_left_out) + " transparent faces"; }
};

/// Edges that only transparent faces have: left out, or kept as lines that no face bounds.
enum class TransparentEdges : std::uint8_t { left_out, kept };

/// The scene without its transparent faces and, unless they are kept, without the edges that have only such faces. An edge
/// that also has an opaque face keeps its class. Nothing if all faces in view are opaque.
std::optional<OpaqueScene> without_transparent_faces(const ProjectedScene& scene,
                                                     TransparentEdges edges = TransparentEdges::left_out);

}  // namespace ligne
