#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "scene/patches/search/surface_search.hpp"

namespace ligne {
namespace {

// Adjustable parameters.
/// Number of facets at which a strip stops growing.
constexpr std::size_t kMostStrip = 24;
/// Least ratio of length to width of the facet from which a strip grows: the square of its length divided by twice its
/// area.
constexpr double kLongFacet = 3;
/// Least length of the edges between facets of a strip, as a fraction of the first facet's length.
constexpr double kRulingPart = 0.5;

}  // namespace

/// The seed, and facets within `rings` arcs of it that may be curved, at most `most` facets in all.
std::vector<std::uint32_t> SurfaceSearch::around(std::uint32_t seed, int rings, std::size_t most) {
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

/// Up to seven neighbours of a facet that may be curved.
std::vector<std::uint32_t> SurfaceSearch::beside(std::uint32_t seed) {
  std::vector<std::uint32_t> near = around(seed, 1, 8);
  near.erase(near.begin());
  return near;
}

/// Sorts neighbours of a facet by the lengths of the sides they share with it, the longest first: those of one strip come
/// before those at its ends.
void SurfaceSearch::sort_by_sides(std::uint32_t seed, std::vector<std::uint32_t>& near) const {
  const auto side = [&](std::uint32_t f) {
    double most = 0;
    for (const FacetGraph::Arc& arc : graph_.arcs_of(seed)) {
      const Edge& edge = topology_.edges[arc.edge];
      if (arc.facet == f) most = std::max(most, glm::distance(scene_.vertices[edge.v0], scene_.vertices[edge.v1]));
    }
    return most;
  };
  std::ranges::stable_sort(near, std::ranges::greater{}, side);
}

/// Largest distance between two corners of a facet.
double SurfaceSearch::longest_diagonal(std::uint32_t f) const {
  const auto corners = graph_.vertices[f];
  double square = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      const Point3 way = scene_.vertices[corners[i]] - scene_.vertices[corners[k]];
      square = std::max(square, glm::dot(way, way));
    }
  }
  return std::sqrt(square);
}

/// The facets of a strip of triangles or quadrilaterals on both sides of a seed. The strip crosses edges about as long
/// as the seed, and avoids much larger facets, such as the planes beside a fillet.
std::vector<std::uint32_t> SurfaceSearch::strip_of(std::uint32_t seed) {
  const double longest = longest_diagonal(seed);
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
