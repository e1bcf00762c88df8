#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>

#include "scene/model/faces_and_edges.hpp"
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
/// Bend of an edge from which on it counts as a rim, by the median of the bends near it.
constexpr double kRimBends = 6;

}  // namespace

/// The seed, and facets within `rings` arcs of it that may be curved, at most `most` facets in all. `may_cross`: for a facet
/// and one beside it, whether the way may lead from one to the other.
template <class MayCross>
std::vector<std::uint32_t> SurfaceSearch::reach(std::uint32_t seed, int rings, std::size_t most, MayCross may_cross) {
  std::vector<std::uint32_t> facets;
  facets.reserve(most);
  facets.push_back(seed);
  ++round_;
  stamp_[seed] = round_;
  std::size_t begin = 0;
  for (int ring = 0; ring < rings && begin < facets.size(); ++ring) {
    const std::size_t end = facets.size();
    for (; begin < end; ++begin) {
      for (const FacetGraph::Arc& arc : graph_.arcs_of(facets[begin])) {
        if (stamp_[arc.facet] == round_ || facets.size() >= most || !is_left_and_may_curve(arc.facet)) continue;
        if (!may_cross(facets[begin], arc.facet)) continue;
        stamp_[arc.facet] = round_;
        facets.push_back(arc.facet);
      }
    }
    if (ring < kRingSteps) near_count_ = facets.size();
  }
  return facets;
}

std::vector<std::uint32_t> SurfaceSearch::around(std::uint32_t seed, int rings, std::size_t most) {
  return reach(seed, rings, most, [](std::uint32_t, std::uint32_t) { return true; });
}

/// The facets of around() that are reached from the first of them without crossing an edge that bends far more than most
/// near it. Empty if there are no such edges. `near`: the facets of around(). Long triangles between two rims touch both, so
/// that around() goes over these.
std::vector<std::uint32_t> SurfaceSearch::within_rims(std::span<const std::uint32_t> near, int rings, std::size_t most) {
  const auto cosine = [&](std::uint32_t f, std::uint32_t g) {
    return std::clamp(glm::dot(graph_.frames[f].normal, graph_.frames[g].normal), -1.0, 1.0);
  };
  ++round_;
  for (const std::uint32_t f : near) stamp_[f] = round_;
  numbers_.clear();
  for (const std::uint32_t f : near) {
    for (const FacetGraph::Arc& arc : graph_.arcs_of(f)) {
      if (arc.facet > f && stamp_[arc.facet] == round_) numbers_.push_back(cosine(f, arc.facet));
    }
  }
  if (numbers_.empty()) return {};
  // The larger the cosine, the smaller the bend.
  const auto median = numbers_.begin() + static_cast<std::ptrdiff_t>(numbers_.size() / 2);
  std::nth_element(numbers_.begin(), median, numbers_.end(), std::greater<>{});
  const double largest = kRimBends * std::acos(*median);
  if (std::acos(std::ranges::min(numbers_)) <= largest) return {};
  return reach(near.front(), rings, most,
               [&](std::uint32_t f, std::uint32_t g) { return std::acos(cosine(f, g)) <= largest; });
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
      if (arc.facet == f) most = std::max(most, edge_length(scene_, topology_.edges[arc.edge]));
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
      if (stamp_[arc.facet] == round_ || !is_left_and_may_curve(arc.facet)) continue;
      if (edge_length(scene_, topology_.edges[arc.edge]) < kRulingPart * longest) continue;
      if (kLikeArea * graph_.area[arc.facet] > graph_.area[seed]) continue;
      stamp_[arc.facet] = round_;
      facets.push_back(arc.facet);
    }
  }
  return facets;
}

}  // namespace ligne
