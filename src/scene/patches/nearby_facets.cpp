#include <algorithm>
#include <glm/geometric.hpp>

#include "scene/patches/patch_finder.hpp"

namespace ligne {
namespace {

// Adjustable parameters.
/// Facets of a strip at the most.
constexpr std::size_t kMostStrip = 24;
/// Facets of a strip are so many times as long as they are wide, or more: the square of their length by twice their area.
constexpr double kLongFacet = 3;
/// The edges between the facets of a strip have at least this part of the length of the first facet.
constexpr double kRulingPart = 0.5;

}  // namespace

/// The seed and facets that may be curved, within so many arcs of it.
std::vector<std::uint32_t> PatchFinder::around(std::uint32_t seed, int rings, std::size_t most) {
  std::vector<std::uint32_t> facets{seed};
  ++round_;
  stamp_[seed] = round_;
  std::size_t begin = 0;
  for (int ring = 0; ring < rings && begin < facets.size(); ++ring) {
    const std::size_t end = facets.size();
    for (; begin < end; ++begin) {
      for (const FacetGraph::Arc& arc : graph_.arcs_of(facets[begin])) {
        if (stamp_[arc.facet] == round_ || !may_curve(arc.facet) || facets.size() >= most) continue;
        stamp_[arc.facet] = round_;
        facets.push_back(arc.facet);
      }
    }
  }
  return facets;
}

/// The facets of a strip of triangles or quadrilaterals on both sides of a seed: over edges about as long as the seed, to
/// facets that are not much larger, as the planes beside a fillet are.
std::vector<std::uint32_t> PatchFinder::strip_of(std::uint32_t seed) {
  double longest = 0;
  for (const std::uint32_t v : graph_.vertices[seed]) {
    for (const std::uint32_t w : graph_.vertices[seed]) {
      longest = std::max(longest, glm::distance(scene_.vertices[v], scene_.vertices[w]));
    }
  }
  std::vector<std::uint32_t> facets{seed};
  if (longest * longest < kLongFacet * 2 * graph_.area[seed]) return facets;
  ++round_;
  stamp_[seed] = round_;
  for (std::size_t i = 0; i < facets.size() && facets.size() < kMostStrip; ++i) {
    for (const FacetGraph::Arc& arc : graph_.arcs_of(facets[i])) {
      if (stamp_[arc.facet] == round_ || !may_curve(arc.facet)) continue;
      const Edge& edge = topology_.edges[arc.edge];
      if (glm::distance(scene_.vertices[edge.v0], scene_.vertices[edge.v1]) < kRulingPart * longest) continue;
      if (kLikeArea * graph_.area[arc.facet] > graph_.area[seed]) continue;
      stamp_[arc.facet] = round_;
      facets.push_back(arc.facet);
    }
  }
  return facets;
}

}  // namespace ligne
