#include "scene/creases/parallel_bends.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "base/indices_where.hpp"
#include "base/no_index.hpp"
#include "scene/model/faces_and_edges.hpp"

namespace ligne {
namespace {

/// A fillet has no facets so many times as wide as others beside them.
constexpr double kWideFactor = 4;
/// Adjustable: number of parallel edges on either side of an edge inside a fillet.
constexpr int kRowsBeside = 2;
/// Adjustable, degrees: edges inside a fillet are no lines up to so much above the crease angle. Tubes of twelve sides
/// bend by a little more than 30 degrees where they are bent themselves.
constexpr double kMoreDegrees = 1;

/// Adjustable: evidence for a line of an edge that a cut may have made the last one of its row, where an edge that surely
/// stands out has 1. The rims of bevels and the ridges of coarse hulls look like this, too: the latter need more than a
/// half.
constexpr double kCutEvidence = 0.55;

/// Edges that rows do not decide. Those that the file calls smooth are strong where a fillet is too small for a surface,
/// and is drawn as an edge.
constexpr std::uint16_t kNotByRows = kEdgeManyFaces | kEdgeUnlikeWound | kEdgeSmooth;

/// Makes weak bends of the strong ones of each line with two loose ends for all of whose edges may_soften() holds. A line
/// that leads to another one stays: it may be the rim of a coarse bevel.
template <class MaySoften>
void soften_loose_ends(const Topology& topology, std::span<const BendEnd> ends, const MaySoften& may_soften,
                       std::vector<Bend>& bends) {
  if (ends.empty()) return;
  std::vector<std::uint32_t> strong(ends.back().vertex + 1, 0);  // per vertex: number of its strong bends
  for (const BendEnd& end : ends) strong[end.vertex] += bends[end.edge] >= Bend::strong;
  const auto strong_at = [&](std::uint32_t v) {
    auto end = std::lower_bound(ends.begin(), ends.end(), BendEnd{v, 0});
    while (bends[end->edge] < Bend::strong) ++end;
    return end->edge;
  };
  std::vector<std::uint32_t> loose;
  for (std::uint32_t v = 0; v < strong.size(); ++v) {
    if (strong[v] == 1 && may_soften(strong_at(v))) loose.push_back(v);
  }
  if (loose.empty()) return;
  std::vector<std::uint8_t> on_border(strong.size(), 0);
  for (const Edge& edge : topology.edges) {
    if (edge.face1 != kNone) continue;
    for (const std::uint32_t v : {edge.v0, edge.v1}) {
      if (v < on_border.size()) on_border[v] = 1;
    }
  }
  std::vector<std::uint32_t> line;
  for (std::uint32_t v : loose) {
    line.clear();
    while (strong[v] == 1 && !on_border[v]) {
      const std::uint32_t e = strong_at(v);
      if (!may_soften(e)) break;
      line.push_back(e);
      bends[e] = Bend::weak;
      const std::uint32_t other = topology.edges[e].v0 == v ? topology.edges[e].v1 : topology.edges[e].v0;
      --strong[v], --strong[other];
      v = other;
    }
    if (strong[v] == 0) continue;
    for (const std::uint32_t e : line) {
      bends[e] = Bend::strong;
      ++strong[topology.edges[e].v0], ++strong[topology.edges[e].v1];
    }
  }
}

/// Whether an even row of edges goes on from an edge to one side, and a cut may have left no edge of the row on the other.
bool is_beside_cut(const Topology& topology, const EdgeRows& rows, std::uint32_t e) {
  const Edge& edge = topology.edges[e];
  if (edge.face1 == kNone) return false;
  const auto goes_on = [&](std::uint32_t face, const RowBends& bends) {
    return static_cast<bool>(rows.next({e, face}, bends));
  };
  return (goes_on(edge.face0, kEvenBends) && !goes_on(edge.face1, kRoundingBends)) ||
         (goes_on(edge.face1, kEvenBends) && !goes_on(edge.face0, kRoundingBends));
}

}  // namespace

bool is_inside_fillet(const EdgeRows& rows, std::uint32_t edge) {
  const auto beside = rows.beside(edge, kRoundingBends);
  return beside && std::ranges::all_of(*beside, [&](EdgeRows::Step step) {
           for (int row = 1; row < kRowsBeside && step; ++row) step = rows.next(step, kRoundingBends);
           return static_cast<bool>(step);
         });
}

bool stands_out(const EdgeRows& rows, std::uint32_t edge, const RowBends& bends) {
  const auto beside = rows.beside(edge, bends);
  if (!beside) return true;
  const auto [near, far] = std::minmax((*beside)[0].distance, (*beside)[1].distance);
  return far >= kWideFactor * near;
}

bool is_line(const Scene& scene, const Topology& topology, const EdgeRows& rows, std::span<const std::uint32_t> way) {
  double standing = 0;
  for (const std::uint32_t e : way) {
    const double length = edge_length(scene, topology.edges[e]);
    if (!stands_out(rows, e, kEvenBends)) {
      standing -= length;
    } else {
      standing += is_beside_cut(topology, rows, e) ? kCutEvidence * length : length;
    }
  }
  return standing >= 0;
}

void soften_fillets(const Scene& scene, const Topology& topology, const BendEnds& at, double crease_degrees,
                    std::vector<Bend>& bends) {
  const auto may_soften = [&](std::uint32_t e) {
    return bends[e] == Bend::strong && at.patch_edges[e] == PatchEdge::unknown && topology.edges[e].face1 != kNone &&
           !(topology.edge_flags[e] & kNotByRows) && is_inside_fillet(at.rows, e);
  };
  const double least = std::cos((crease_degrees + kMoreDegrees) * std::numbers::pi / 180);
  const auto is_soft = [&](std::size_t k) {
    const Edge& edge = topology.edges[at.list[k].edge];
    return edge.v0 == at.list[k].vertex && may_soften(at.list[k].edge) &&
           glm::dot(face_normal(scene, edge.face0), face_normal(scene, edge.face1)) >= least;
  };
  const std::vector<std::uint32_t> soft = indices_where(at.list.size(), is_soft, kSearchBlock);
  for (const std::uint32_t k : soft) bends[at.list[k].edge] = Bend::weak;
  soften_loose_ends(topology, at.list, may_soften, bends);
}

}  // namespace ligne
