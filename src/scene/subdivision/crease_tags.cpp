#include "scene/subdivision/crease_tags.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

namespace ligne {

void CreaseTags::sort() {
  // The sharpest of equal edges comes first, and the others are dropped.
  std::ranges::sort(edges, {}, [](const Edge& e) { return std::tuple(e.v0, e.v1, -e.sharpness); });
  const auto same_edge = [](const Edge& a, const Edge& b) { return a.v0 == b.v0 && a.v1 == b.v1; };
  edges.erase(std::unique(edges.begin(), edges.end(), same_edge), edges.end());
  std::ranges::sort(corners, {}, [](const Corner& c) { return std::pair(c.vertex, -c.sharpness); });
  const auto same_corner = [](const Corner& a, const Corner& b) { return a.vertex == b.vertex; };
  corners.erase(std::unique(corners.begin(), corners.end(), same_corner), corners.end());
}

float CreaseTags::of_edge(std::uint32_t a, std::uint32_t b) const {
  if (edges.empty()) return 0;
  const std::pair<std::uint32_t, std::uint32_t> key = std::minmax({in_file(a), in_file(b)});
  const auto at = std::ranges::lower_bound(edges, key, {}, [](const Edge& e) { return std::pair(e.v0, e.v1); });
  return at != edges.end() && at->v0 == key.first && at->v1 == key.second ? at->sharpness : 0;
}

float CreaseTags::of_vertex(std::uint32_t v) const {
  if (corners.empty()) return 0;
  const std::uint32_t vertex = in_file(v);
  const auto at = std::ranges::lower_bound(corners, vertex, {}, &Corner::vertex);
  return at != corners.end() && at->vertex == vertex ? at->sharpness : 0;
}

}  // namespace ligne
