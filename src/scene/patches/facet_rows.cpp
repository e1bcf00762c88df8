#include "scene/patches/facet_rows.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "base/no_index.hpp"
#include "scene/patches/freeform.hpp"

namespace ligne {
namespace {

// Adjustable.
/// Largest sine of the angle between edges of a row, and largest relative difference of its bends and widths.
constexpr double kParallelSine = 0.01, kEqualPart = 0.02;
/// Largest sine of a bend in a long row (14 degrees), largest factor between bends and between widths beside each other, and
/// least number of its facets: planes that bend as little and as evenly are seldom so many.
constexpr double kLongRowSine = 0.242, kGradual = 1.5;
constexpr std::size_t kLongRow = 5;
/// Largest number of arcs of a facet in a row. The search compares all pairs of them.
constexpr std::size_t kMostRowArcs = 16;

/// Two parallel edges of a facet with equal bends.
struct RowEdges {
  FacetGraph::Arc one, other;
  double sine = 0, width = 0;  ///< sine of the bends, positive where the body bulges; distance of the edges

  bool has(std::uint32_t edge) const { return one.edge == edge || other.edge == edge; }
};

bool alike(double a, double b) { return std::abs(a - b) <= kEqualPart * std::abs(b) && b != 0; }

}  // namespace

/// Sine of the bend at an arc of a facet: positive where the neighbour falls away from the facet's plane.
double bend_at(const FacetGraph& graph, std::uint32_t f, const FacetGraph::Arc& arc) {
  const FacetFrame &here = graph.frames[f], &there = graph.frames[arc.facet];
  const double sine = glm::length(glm::cross(here.normal, there.normal));
  return glm::dot(there.middle - here.middle, here.normal) < 0 ? sine : -sine;
}

Point3 FacetRows::along(std::uint32_t e) const {
  return glm::normalize(scene_.vertices[topology_.edges[e].v1] - scene_.vertices[topology_.edges[e].v0]);
}

/// Whether two edges of a facet are RowEdges that fulfil a condition.
template <class Condition>
bool FacetRows::any_row(std::uint32_t f, const Condition& condition) const {
  const auto arcs = graph_.arcs_of(f);
  if (patch_of_[f] != kNone || graph_.is_sliver[f] || arcs.size() < 2 || arcs.size() > kMostRowArcs) return false;
  for (std::size_t i = 0; i < arcs.size(); ++i) {
    const double sine = bend_at(graph_, f, arcs[i]);
    if (std::abs(sine) < kLeastRowSine) continue;
    const Point3 direction = along(arcs[i].edge), &at = scene_.vertices[topology_.edges[arcs[i].edge].v0];
    for (std::size_t j = i + 1; j < arcs.size(); ++j) {
      if (arcs[j].facet == arcs[i].facet || !alike(bend_at(graph_, f, arcs[j]), sine)) continue;
      if (glm::length(glm::cross(direction, along(arcs[j].edge))) > kParallelSine) continue;
      const Point3 way = scene_.vertices[topology_.edges[arcs[j].edge].v0] - at;
      const double width = glm::length(way - glm::dot(way, direction) * direction);
      if (condition(RowEdges{arcs[i], arcs[j], sine, width})) return true;
    }
  }
  return false;
}

bool FacetRows::is_in_row(std::uint32_t f) const {
  return any_row(f, [&](const RowEdges& row) {
    return std::ranges::any_of(std::array{row.one, row.other}, [&](const FacetGraph::Arc& arc) {
      return any_row(arc.facet, [&](const RowEdges& next) {
        return next.has(arc.edge) && alike(next.sine, row.sine) && alike(next.width, row.width);
      });
    });
  });
}

bool FacetRows::ends_row(std::uint32_t f) const {
  return std::ranges::any_of(graph_.arcs_of(f), [&](const FacetGraph::Arc& arc) {
    const double width = depth_behind(scene_, graph_.vertices[f], topology_.edges[arc.edge]);
    const auto is_behind = [&](const RowEdges& row) { return row.has(arc.edge) && alike(width, row.width); };
    return any_row(arc.facet, is_behind) && is_in_row(arc.facet);
  });
}

/// Whether a facet and the one beyond an arc may be neighbours in a long row.
bool FacetRows::goes_on_behind(std::uint32_t f, const FacetGraph::Arc& arc) const {
  for (const std::uint32_t g : {f, arc.facet}) {
    if (patch_of_[g] != kNone || graph_.is_sliver[g] || graph_.arcs_of(g).size() > kMostRowArcs) return false;
  }
  const double sine = std::abs(bend_at(graph_, f, arc));
  if (sine < kLeastRowSine || sine > kLongRowSine) return false;
  const Edge& edge = topology_.edges[arc.edge];
  const double ratio =
      depth_behind(scene_, graph_.vertices[f], edge) / depth_behind(scene_, graph_.vertices[arc.facet], edge);
  return ratio >= 1 / kGradual && ratio <= kGradual;
}

/// Whether two edges are parallel, and two bends there differ by little.
bool FacetRows::are_gradual(std::uint32_t edge, double sine, std::uint32_t other, double other_sine) const {
  const double ratio = sine / other_sine;
  return ratio >= 1 / kGradual && ratio <= kGradual && glm::length(glm::cross(along(edge), along(other))) <= kParallelSine;
}

/// Number of facets of a long row beyond an arc, kLongRow at most.
std::size_t FacetRows::count_behind(std::uint32_t f, FacetGraph::Arc arc) const {
  double sine = bend_at(graph_, f, arc);
  std::size_t count = 1;
  for (; count < kLongRow; ++count) {
    f = arc.facet;
    const auto arcs = graph_.arcs_of(f);
    const auto next = std::ranges::find_if(arcs, [&](const FacetGraph::Arc& a) {
      return a.edge != arc.edge && goes_on_behind(f, a) && are_gradual(arc.edge, sine, a.edge, bend_at(graph_, f, a));
    });
    if (next == arcs.end()) break;
    arc = *next;
    sine = bend_at(graph_, f, arc);
  }
  return count;
}

bool FacetRows::is_in_long_row(std::uint32_t f) const {
  const auto arcs = graph_.arcs_of(f);
  for (std::size_t i = 0; i < arcs.size(); ++i) {
    if (!goes_on_behind(f, arcs[i])) continue;
    const double sine = bend_at(graph_, f, arcs[i]);
    const std::size_t count = 1 + count_behind(f, arcs[i]);
    if (count >= kLongRow) return true;
    for (std::size_t k = 0; k < i; ++k) {
      const bool is_gradual =
          goes_on_behind(f, arcs[k]) && are_gradual(arcs[i].edge, sine, arcs[k].edge, bend_at(graph_, f, arcs[k]));
      if (is_gradual && count + count_behind(f, arcs[k]) >= kLongRow) return true;
    }
  }
  return false;
}

}  // namespace ligne
