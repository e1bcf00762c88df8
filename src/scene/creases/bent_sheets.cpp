#include "scene/creases/bent_sheets.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <utility>

#include "geometry/stop.hpp"
#include "scene/creases/across_edge.hpp"

namespace ligne {

std::vector<std::uint8_t> bent_sheets(const Scene& scene, const Topology& topology, float crease_cosine) {
  std::vector<std::pair<std::pair<std::uint32_t, std::uint32_t>, std::size_t>> wanted;
  for (std::size_t e = 0; e < topology.edges.size(); ++e) {
    if (topology.edge_flags[e] & kEdgeManyFaces) wanted.push_back({{topology.edges[e].v0, topology.edges[e].v1}, e});
  }
  std::vector<std::uint8_t> bent(wanted.size(), 0), goes_on(wanted.size(), 0);
  if (wanted.empty()) return bent;
  std::vector<Point3> first(wanted.size(), Point3(0));
  std::vector<std::uint32_t> last_face(wanted.size(), kNone);
  for (std::uint32_t f = 0; f < scene.faces.size(); ++f) {
    for (std::size_t c = 0; c < scene.faces.contour_count(f); ++c) {
      const auto contour = scene.faces.contour(f, c);
      for (std::size_t k = 0; k < contour.size(); ++k) {
        const auto [low, high] = std::minmax(contour[k], contour[k + 1 == contour.size() ? 0 : k + 1]);
        const std::pair key(std::pair(low, high), std::size_t{0});
        const auto at = std::lower_bound(wanted.begin(), wanted.end(), key);
        if (at == wanted.end() || at->first != key.first) continue;
        const auto i = static_cast<std::size_t>(at - wanted.begin());
        if (std::exchange(last_face[i], f) == f) continue;
        check_stop();
        const Point3 across = across_face(scene, topology.edges[at->second], f);
        if (across == Point3(0)) continue;
        const Point3 direction = across / glm::length(across);
        // All others are in line with the first one, or two of them bend.
        if (first[i] == Point3(0)) first[i] = direction;
        const double cosine = glm::dot(direction, first[i]);
        if (std::abs(cosine) < crease_cosine) bent[i] = 1;
        if (cosine < 0) goes_on[i] = 1;
      }
    }
  }
  for (std::size_t i = 0; i < bent.size(); ++i) bent[i] |= first[i] != Point3(0) && !goes_on[i];
  return bent;
}

}  // namespace ligne
