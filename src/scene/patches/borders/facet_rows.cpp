#include "scene/patches/borders/facet_rows.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace ligne {
namespace {

// Adjustable.
/// In a row of facets, edges are parallel by at least this cosine (25 degrees), and the angles at them, and their widths,
/// differ by less than kRowFactor. Narrower angles, by kRowFold, are those of the triangles of one facet of the row.
constexpr double kRowCosine = 0.9, kRowFactor = 1.4, kRowFold = 3;
/// Most neighbours of a facet of a row.
constexpr std::size_t kMostRowArcs = 8;
/// Most facets across a patch whose curvature in this direction may be an accident.
constexpr int kMostShallowFacets = 2;

}  // namespace

bool are_alike_in_row(double a, double b) { return a < kRowFactor * b && b < kRowFactor * a; }

double FacetRows::bend(std::uint32_t f, const FacetGraph::Arc& arc) const {
  const FacetFrame &here = graph_.frames[f], &there = graph_.frames[arc.facet];
  const double angle = std::atan2(glm::length(glm::cross(here.normal, there.normal)), glm::dot(here.normal, there.normal));
  return glm::dot(there.middle - here.middle, here.normal) < 0 ? angle : -angle;
}

FacetRows::Step FacetRows::next(std::uint32_t f, std::uint32_t edge, double angle) const { return next(f, edge, angle, 1); }

FacetRows::Step FacetRows::next(std::uint32_t f, std::uint32_t edge, double angle, int rest) const {
  const auto arcs = graph_.arcs_of(f);
  if (arcs.size() > kMostRowArcs) return {};
  for (const FacetGraph::Arc& arc : arcs) {
    const double other = bend(f, arc);
    if (arc.edge != edge && other * angle > 0 && are_alike_in_row(std::abs(other), std::abs(angle)) &&
        std::abs(glm::dot(direction(arc.edge), direction(edge))) > kRowCosine)
      return {f, arc};
  }
  if (rest == 0) return {};
  for (const FacetGraph::Arc& arc : arcs) {
    if (std::abs(bend(f, arc)) * kRowFold >= std::abs(angle)) continue;
    if (const Step step = next(arc.facet, edge, angle, rest - 1)) return step;
  }
  return {};
}

int FacetRows::depth(std::uint32_t f, const FacetGraph::Arc& arc, std::span<const std::uint32_t> patch_of, int most) const {
  const std::uint32_t patch = patch_of[f];
  std::uint32_t edge = arc.edge;
  double angle = bend(f, arc);
  for (int count = 1; count <= most; ++count) {
    const Step step = next(f, edge, angle);
    if (!step || patch_of[step.arc.facet] != patch) return count;
    angle = bend(step.last, step.arc);
    f = step.arc.facet;
    edge = step.arc.edge;
  }
  return most + 1;
}

double FacetRows::width(std::uint32_t f, std::uint32_t edge) const {
  const Point3 &from = scene_.vertices[topology_.edges[edge].v0], along = direction(edge);
  double most = 0;
  for (const std::uint32_t v : graph_.vertices[f])
    most = std::max(most, glm::length(glm::cross(scene_.vertices[v] - from, along)));
  return most;
}

Point3 FacetRows::direction(std::uint32_t edge) const {
  return glm::normalize(scene_.vertices[topology_.edges[edge].v1] - scene_.vertices[topology_.edges[edge].v0]);
}

std::vector<std::uint32_t> row_edges(const Scene& scene, const Topology& topology, const FacetGraph& graph,
                                     std::span<const std::uint32_t> patch_of) {
  const FacetRows rows(scene, topology, graph);
  const auto is_shallow = [&](std::uint32_t f, const FacetGraph::Arc& arc) {
    return rows.depth(f, arc, patch_of, kMostShallowFacets) <= kMostShallowFacets;
  };
  std::vector<std::uint32_t> found;
  for (std::uint32_t f = 0; f < graph.size(); ++f) {
    if (patch_of[f] == kNone) continue;
    for (const FacetGraph::Arc& arc : graph.arcs_of(f)) {
      const std::uint32_t g = arc.facet;
      if (g < f || patch_of[g] == kNone || patch_of[g] == patch_of[f]) continue;
      if (rows.goes_on(f, arc) && are_alike_in_row(rows.width(f, arc.edge), rows.width(g, arc.edge)) &&
          (is_shallow(f, arc) || is_shallow(g, {f, arc.edge})))
        found.push_back(arc.edge);
    }
  }
  std::ranges::sort(found);
  return found;
}

}  // namespace ligne
