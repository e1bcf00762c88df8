#include "scene/creases/plane_slivers.hpp"

#include <algorithm>
#include <utility>

#include "base/no_index.hpp"
#include "scene/model/planarity.hpp"

namespace ligne {

std::vector<std::uint32_t> turn_plane_slivers(const Scene& scene, const Topology& topology,
                                              std::span<const std::uint32_t> plane_edges, std::vector<glm::vec3>& normals) {
  std::vector<std::uint32_t> turned;
  for (const std::uint32_t e : plane_edges) {
    const Edge& edge = topology.edges[e];
    const bool is_first = is_sliver_face(scene, edge.face0);
    if (is_first == is_sliver_face(scene, edge.face1)) continue;
    const auto [sliver, plane] = is_first ? std::pair(edge.face0, edge.face1) : std::pair(edge.face1, edge.face0);
    normals[sliver] = topology.edge_flags[e] & kEdgeUnlikeWound ? -normals[plane] : normals[plane];
    turned.push_back(sliver);
  }
  std::vector<std::uint32_t> edges;
  for (const std::uint32_t sliver : turned) {
    const auto corners = scene.faces.contour(sliver, 0);
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const Edge* edge = find_edge(topology, {corners[k], corners[(k + 1) % corners.size()]});
      if (!edge || edge->face1 == kNone) continue;
      const auto e = static_cast<std::uint32_t>(edge - topology.edges.data());
      if (!std::ranges::binary_search(plane_edges, e)) edges.push_back(e);
    }
  }
  return edges;
}

}  // namespace ligne
