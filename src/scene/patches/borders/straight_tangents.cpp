#include "scene/patches/borders/straight_tangents.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <span>

#include "base/indices_where.hpp"
#include "base/no_index.hpp"
#include "scene/model/faces_and_edges.hpp"

namespace ligne {
namespace {

// Adjustable.
/// Least sum of the turns of a detour, in radians (6 degrees), and largest part of it that is left when the line goes
/// straight: half if the line goes on at both ends, else less, since the turn at one of them is not known.
constexpr double kLeastTurns = 0.1, kMostLeft = 0.5, kMostLeftAtEnd = 0.2;
/// Largest number of edges of a detour, its largest length by that of the straight way, and its largest turn, in radians (60
/// degrees): a line that turns more goes round a corner.
constexpr std::size_t kMostDetourEdges = 4;
constexpr double kLongestDetour = 1.3, kCornerTurn = 1.05;
/// Least cosine of the bend at the edge that takes the place of a detour: 31 degrees.
constexpr double kPastCosine = 0.857;

constexpr std::uint16_t kNoWayPast = kEdgeManyFaces | kEdgeUnlikeWound | kEdgeSharp | kEdgeCrossing | kEdgeFileHidden;

/// Tangent lines as vertices with their neighbours.
class TangentLines {
 public:
  TangentLines(const Scene& scene, const Topology& topology, const std::vector<std::uint8_t>& is_line,
               std::vector<PatchEdge>& edges)
      : scene_(scene), topology_(topology), is_line_(is_line), edges_(edges) {
    for (const std::uint32_t e : indices_of_marks(edges)) {
      if (edges[e] != PatchEdge::tangent) continue;
      const Edge& edge = topology.edges[e];
      add(edge.v0, edge.v1);
      add(edge.v1, edge.v0);
    }
    if (next_.empty()) return;
    for (const std::uint32_t e : indices_of_marks(is_line))
      count_[topology.edges[e].v0] = count_[topology.edges[e].v1] = kBranch;
  }

  /// Each change removes edges, and leads to further looks at its ends alone.
  void straighten() {
    std::vector<std::uint32_t> open = inner_;
    std::ranges::sort(open);
    while (!open.empty()) {
      const std::uint32_t v = open.back();
      open.pop_back();
      if (count_[v] != 2) continue;
      const std::uint32_t end = lead_on(v);
      if (end != kNone) open.insert(open.end(), {v, end});
    }
  }

 private:
  static constexpr std::uint8_t kBranch = 3;  ///< number of tangent edges where lines branch or meet other ones

  void add(std::uint32_t v, std::uint32_t w) {
    if (next_.empty()) {
      next_.assign(scene_.vertices.size(), {kNone, kNone});
      count_.assign(scene_.vertices.size(), 0);
    }
    if (count_[v] < 2) next_[v][count_[v]] = w;
    count_[v] = static_cast<std::uint8_t>(std::min(count_[v] + 1, int{kBranch}));
    if (count_[v] == 2) inner_.push_back(v);
  }

  /// The neighbour of a vertex on the other side, or kNone at an end and where lines branch.
  std::uint32_t behind(std::uint32_t v, std::uint32_t before) const {
    return count_[v] == 2 ? next_[v][next_[v][0] == before ? 1 : 0] : kNone;
  }

  double turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    const Point3 way = scene_.vertices[b] - scene_.vertices[a], on = scene_.vertices[c] - scene_.vertices[b];
    return std::atan2(glm::length(glm::cross(way, on)), glm::dot(way, on));
  }

  /// Whether a tangent line may lie on an edge, which is none yet and no other line.
  bool may_pass(std::uint32_t e) const {
    const Edge& edge = topology_.edges[e];
    if (edge.face1 == kNone || is_line_[e] || (topology_.edge_flags[e] & kNoWayPast)) return false;
    if (edges_[e] == PatchEdge::tangent || edges_[e] == PatchEdge::sharp) return false;
    return glm::dot(face_normal(scene_, edge.face0), face_normal(scene_, edge.face1)) >= kPastCosine;
  }

  /// The vertices of the line from its inner vertex v on, toward one of its neighbours, up to an end or a branch.
  std::vector<std::uint32_t> way_on(std::uint32_t v, std::uint32_t neighbour) const {
    std::vector<std::uint32_t> way{v};
    for (std::uint32_t on = neighbour; way.size() <= kMostDetourEdges && on != v && on != kNone;) {
      way.push_back(on);
      on = behind(on, way[way.size() - 2]);
    }
    return way;
  }

  /// Whether a way from an inner vertex goes to and fro so much that the edge between its ends is to take its place. No line
  /// turns at an end or a branch.
  bool is_detour(std::span<const std::uint32_t> way) const {
    const std::uint32_t a = way.front(), c = way.back();
    const std::uint32_t before = behind(a, way[1]), after = behind(c, way[way.size() - 2]);
    if (before == c || after == a) return false;
    double turns = 0, straight = turn(before, a, c), length = 0;
    bool has_corner = false;
    const auto add_turn = [&](std::uint32_t u, std::uint32_t v, std::uint32_t w) {
      const double one = turn(u, v, w);
      turns += one;
      has_corner |= one > kCornerTurn;
    };
    add_turn(before, a, way[1]);
    for (std::size_t i = 1; i < way.size(); ++i) {
      length += glm::distance(scene_.vertices[way[i - 1]], scene_.vertices[way[i]]);
      if (i + 1 < way.size()) add_turn(way[i - 1], way[i], way[i + 1]);
    }
    if (after != kNone) {
      add_turn(way[way.size() - 2], c, after);
      straight += turn(a, c, after);
    }
    return !has_corner && turns >= kLeastTurns && straight <= (after != kNone ? kMostLeft : kMostLeftAtEnd) * turns &&
           length <= kLongestDetour * glm::distance(scene_.vertices[a], scene_.vertices[c]);
  }

  /// Leads the line straight from an inner vertex to one of the next vertices, if it makes a detour between. Returns the
  /// other end, or kNone.
  std::uint32_t lead_on(std::uint32_t v) {
    for (const std::uint32_t neighbour : next_[v]) {
      const std::vector<std::uint32_t> way = way_on(v, neighbour);
      for (std::size_t n = 3; n <= way.size(); ++n) {
        const std::span part(way.data(), n);
        const std::uint32_t past = edge_between(topology_, v, part.back());
        if (past == kNone || !may_pass(past) || !is_detour(part)) continue;
        for (std::size_t i = 1; i < n; ++i) edges_[edge_between(topology_, part[i - 1], part[i])] = PatchEdge::inside;
        for (const std::uint32_t inner : part.subspan(1, n - 2)) count_[inner] = 0;
        edges_[past] = PatchEdge::tangent;
        std::ranges::replace(next_[v], part[1], part.back());
        std::ranges::replace(next_[part.back()], part[n - 2], v);
        return part.back();
      }
    }
    return kNone;
  }

  const Scene& scene_;
  const Topology& topology_;
  const std::vector<std::uint8_t>& is_line_;
  std::vector<PatchEdge>& edges_;
  std::vector<std::array<std::uint32_t, 2>> next_;  ///< per vertex: its first two neighbours
  std::vector<std::uint8_t> count_;                 ///< per vertex: number of tangent edges, at most kBranch
  std::vector<std::uint32_t> inner_;                ///< vertices that had two neighbours
};

}  // namespace

void straighten_tangents(const Scene& scene, const Topology& topology, const std::vector<std::uint8_t>& is_line,
                         std::vector<PatchEdge>& edges) {
  TangentLines(scene, topology, is_line, edges).straighten();
}

}  // namespace ligne
