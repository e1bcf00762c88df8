#include "visibility/common/opaque_scene.hpp"

#include <algorithm>
#include <utility>

#include "base/no_index.hpp"

namespace ligne {

std::optional<OpaqueScene> without_transparent_faces(const ProjectedScene& scene, TransparentEdges edges) {
  const auto transparent = [&](std::uint32_t face) {
    return face < scene.face_is_transparent.size() && scene.face_is_transparent[face] != 0;
  };
  std::vector<std::uint8_t> is_out(scene.face_is_transparent.size(), 0);
  for (const Triangle& t : scene.triangles) {
    if (transparent(t.face)) is_out[t.face] = 1;
  }
  const auto faces = static_cast<std::size_t>(std::count(is_out.begin(), is_out.end(), std::uint8_t{1}));
  if (faces == 0) return std::nullopt;
  OpaqueScene opaque{scene, faces};
  std::erase_if(opaque.scene.triangles, [&](const Triangle& t) { return transparent(t.face); });
  opaque.scene.edges.clear();
  opaque.scene.edge_parts.clear();
  for (std::size_t i = 0; i < scene.edges.size(); ++i) {
    ProjectedEdge edge = scene.edges[i];
    const bool has_face = edge.face0 != kNone || edge.face1 != kNone;
    if (transparent(edge.face0)) edge.face0 = kNone;
    if (transparent(edge.face1)) edge.face1 = kNone;
    if (edge.face0 == kNone) std::swap(edge.face0, edge.face1);
    if (has_face && edge.face0 == kNone && edges == TransparentEdges::left_out) continue;
    opaque.scene.edges.push_back(edge);
    if (!scene.edge_parts.empty()) opaque.scene.edge_parts.push_back(scene.edge_parts[i]);
  }
  opaque.scene.face_is_transparent.clear();
  return opaque;
}

}  // namespace ligne
