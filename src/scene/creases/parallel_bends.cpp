#include "scene/creases/parallel_bends.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "base/no_index.hpp"

namespace ligne {
namespace {

/// Adjustable: number of parallel edges on either side of an edge inside a rounding.
constexpr int kRowsBeside = 2;
/// Least cosine of the angle between edges of one row (25 degrees).
constexpr double kRowCosine = 0.9;
/// Adjustable, degrees: edges inside a rounding are no lines up to so much above the crease angle. Tubes of twelve sides
/// bend by a little more than 30 degrees where they are bent themselves.
constexpr double kMoreDegrees = 1;
/// Most edges that bend at a vertex at which a row is followed.
constexpr std::size_t kMostRowEnds = 64;

class RowWalker {
 public:
  RowWalker(const Scene& scene, const Topology& topology, const std::vector<Bend>& bends, std::span<const BendEnd> ends)
      : scene_(scene), topology_(topology), bends_(bends), ends_(ends) {}

  /// Whether so many edges follow in a row behind a face of an edge.
  bool goes_on(std::uint32_t e, std::uint32_t face) const {
    const bool convex = is_convex(e);
    for (int row = 0; row < kRowsBeside; ++row) {
      const std::uint32_t next = next_in_row(e, face, convex);
      if (next == kNone) return false;
      const Edge& edge = topology_.edges[next];
      const Point3 &at = scene_.vertices[topology_.edges[e].v0], along = direction(e);
      const auto depth = [&](std::uint32_t f) { return glm::length(glm::cross(middle(f) - at, along)); };
      face = depth(edge.face0) > depth(edge.face1) ? edge.face0 : edge.face1;
      e = next;
    }
    return true;
  }

 private:
  Point3 direction(std::uint32_t e) const {
    return glm::normalize(scene_.vertices[topology_.edges[e].v1] - scene_.vertices[topology_.edges[e].v0]);
  }

  Point3 middle(std::uint32_t face) const {
    const auto corners = scene_.faces.contour(face, 0);
    Point3 sum(0.0);
    for (const std::uint32_t v : corners) sum += scene_.vertices[v];
    return sum / static_cast<double>(corners.size());
  }

  bool is_convex(std::uint32_t e) const {
    const Edge& edge = topology_.edges[e];
    return glm::dot(face_normal(scene_, edge.face0), middle(edge.face1) - scene_.vertices[edge.v0]) < 0;
  }

  /// The edge most nearly parallel to e at a corner of the face, that bends to the same side and is no corner by itself.
  std::uint32_t next_in_row(std::uint32_t e, std::uint32_t face, bool convex) const {
    const Edge& edge = topology_.edges[e];
    const Point3 along = direction(e);
    std::uint32_t best = kNone;
    double best_cosine = kRowCosine;
    for (const std::uint32_t v : scene_.faces.contour(face, 0)) {
      if (v == edge.v0 || v == edge.v1) continue;
      const auto first = std::lower_bound(ends_.begin(), ends_.end(), BendEnd{v, 0});
      auto end = first;
      for (; end != ends_.end() && end->vertex == v && end - first < std::ptrdiff_t{kMostRowEnds}; ++end) {
        const Edge& other = topology_.edges[end->edge];
        const bool touches = other.v0 == edge.v0 || other.v1 == edge.v0 || other.v0 == edge.v1 || other.v1 == edge.v1;
        if (touches || other.face1 == kNone || bends_[end->edge] == Bend::firm || is_convex(end->edge) != convex) continue;
        const double cosine = std::abs(glm::dot(direction(end->edge), along));
        if (cosine > best_cosine) best = end->edge, best_cosine = cosine;
      }
    }
    return best;
  }

  const Scene& scene_;
  const Topology& topology_;
  const std::vector<Bend>& bends_;
  std::span<const BendEnd> ends_;
};

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

}  // namespace

bool is_inside_rounding(const Scene& scene, const Topology& topology, const std::vector<Bend>& bends,
                        std::span<const BendEnd> ends, std::uint32_t edge) {
  const RowWalker walker(scene, topology, bends, ends);
  const Edge& at = topology.edges[edge];
  return at.face1 != kNone && walker.goes_on(edge, at.face0) && walker.goes_on(edge, at.face1);
}

void soften_roundings(const Scene& scene, const Topology& topology, const BendEnds& at, double crease_degrees,
                      std::vector<Bend>& bends) {
  const std::span<const BendEnd> ends = at.list;
  const auto may_soften = [&](std::uint32_t e) {
    return bends[e] == Bend::strong && at.patch_edges[e] == PatchEdge::unknown && topology.edges[e].face1 != kNone &&
           !(topology.edge_flags[e] & (kEdgeManyFaces | kEdgeUnlikeWound)) &&
           is_inside_rounding(scene, topology, bends, ends, e);
  };
  const double least = std::cos((crease_degrees + kMoreDegrees) * std::numbers::pi / 180);
  std::vector<std::uint32_t> soft;
  for (const BendEnd& end : ends) {
    const Edge& edge = topology.edges[end.edge];
    if (edge.v0 != end.vertex || !may_soften(end.edge)) continue;
    if (glm::dot(face_normal(scene, edge.face0), face_normal(scene, edge.face1)) >= least) soft.push_back(end.edge);
  }
  for (const std::uint32_t e : soft) bends[e] = Bend::weak;
  soften_loose_ends(topology, ends, may_soften, bends);
}

}  // namespace ligne
