#include "scene/patches/borders/freeform_seams.hpp"

#include <algorithm>
#include <cstddef>
#include <glm/geometric.hpp>
#include <optional>
#include <utility>

#include "base/disjoint_sets.hpp"
#include "base/indices_where.hpp"
#include "base/no_index.hpp"
#include "base/parallel.hpp"
#include "base/parallel_each.hpp"
#include "scene/creases/across_edge.hpp"
#include "scene/model/bounds.hpp"
#include "scene/model/faces_and_edges.hpp"
#include "scene/patches/borders/seam_section.hpp"
#include "scene/patches/freeform.hpp"

namespace ligne {
namespace {

// Adjustable.
/// An edge proves a seam if the flat side bends by less than this part of the round one, and that by so many radians over
/// its first face. So many edges between two of them, or between one and another line, may prove nothing.
constexpr double kFlatRatio = 0.33, kLeastSeamTurn = 0.03, kLargestSeamTurn = 1.3;
constexpr std::size_t kMostWeakEdges = 2;
/// Least ratio of the depths of the two faces of an edge that may prove a seam, and least number of such edges in a line.
constexpr double kUnlikeDepths = 1.2;
constexpr std::uint32_t kFewestUnlike = 3;
/// Least cosine of the bend at an edge (31 degrees): more is a matter of the rules for meshes.
constexpr double kSeamBendCosine = 0.857;
/// Least cosine of the turn from one edge of a line to the next (30 degrees), and between the directions of the flat sides.
constexpr double kSeamStraightCosine = 0.866, kFlatSideCosine = 0.5;
/// Most edges at a vertex through which a line may go: none goes through the apex of a fan.
constexpr std::ptrdiff_t kMostAtVertex = 64;
/// Longest gap up to another line, as a part of the line before it, and its most edges.
constexpr double kLongestSeamGap = 0.5;
constexpr std::size_t kMostSeamGapEdges = 64;
/// A gap does not lead through faces that bend alike and are so many times as deep as those of the round side of the line.
constexpr double kDeeperGap = 2;
/// Least number of the edges of a line, unless it lies between two other lines.
constexpr std::size_t kFewestSeamEdges = 4;  // at least 4, for roughness()
/// Largest roughness() of a line, and of one across which the mesh clearly bends otherwise: lines that follow facets turn to
/// and fro.
constexpr double kRoughness = 0.02, kClearRoughness = 0.03;
/// Least length of a line that meets no other one, as a part of the diagonal of its object.
constexpr double kShortestOpen = 1.0 / 8;
/// A shorter line that meets one at one end alone lies between faces whose depths differ by such a factor.
constexpr double kShortestHalfOpen = 1.0 / 32, kDepthsOfShort = 1.5;

constexpr std::uint16_t kSpokenFor =
    kEdgeManyFaces | kEdgeUnlikeWound | kEdgeSharp | kEdgeSmooth | kEdgeCrossing | kEdgeFileHidden | kEdgeInner;

class SeamFinder {
 public:
  SeamFinder(const Scene& scene, const Topology& topology, const Patches& patches, const std::vector<std::uint8_t>& is_line,
             std::vector<PatchEdge>& edges)
      : scene_(scene), topology_(topology), patches_(patches), is_line_(is_line), edges_(edges) {}

  void run() {
    find_inner();
    measure();
    if (std::ranges::none_of(inner_, &Inner::is_proof)) return;
    hold();
    for (const Inner& inner : inner_)
      for (const std::uint32_t v : {topology_.edges[inner.edge].v0, topology_.edges[inner.edge].v1})
        ends_.emplace_back(v, inner.edge);
    std::ranges::sort(ends_);
    std::vector<Line> lines;
    for (std::uint32_t i = 0; i < inner_.size(); ++i) {
      if (!inner_[i].is_proof || inner_[i].is_done) continue;
      Line line = line_through(i);
      line.bend = bend_along(sections_along(line.vertices));
      if (line.bend.may_be_seam()) lines.push_back(std::move(line));
    }
    for (const Line& line : lines)
      for (const std::uint32_t v : line.vertices) is_held_[v] |= kOnSeam;
    for (Line& line : lines) {
      for (int end = 0; end < 2; ++end) {
        std::ranges::reverse(line.vertices);
        close_gap(line);
      }
    }
    std::erase_if(lines, [&](const Line& line) { return !is_seam(line); });
    drop_loose(lines);
    for (const Line& line : lines) {
      for (std::size_t i = 1; i < line.vertices.size(); ++i)
        edges_[edge_between(topology_, line.vertices[i - 1], line.vertices[i])] = PatchEdge::tangent;
    }
  }

 private:
  /// An edge inside a free form.
  struct Inner {
    std::uint32_t edge = kNone;
    std::uint32_t deep = kNone;  ///< its deeper face, if that is clearly deeper than the other one
    std::optional<SeamSection> section{};
    bool is_proof = false, is_done = false;  ///< whether it proves a seam; whether it belongs to a line
  };

  struct Line {
    std::vector<std::uint32_t> vertices;
    std::vector<const Inner*> edges;
    double length = 0;
    LineBend bend{};  ///< of the line before gaps were closed
    bool is_closed() const { return vertices.front() == vertices.back(); }
  };

  enum Held : std::uint8_t { kFree = 0, kOnLine = 1, kOnSeam = 2 };

  bool is_free(std::uint32_t face) const { return patches_.is_freeform[face] && patches_.patch_of[face] == kNone; }
  bool is_curved(std::uint32_t face) const { return patches_.is_freeform[face] || patches_.patch_of[face] != kNone; }

  void find_inner() {
    for (const Object& object : scene_.objects) {
      if (!is_part(scene_, patches_, object)) continue;
      is_inner_.resize(topology_.edges.size(), 0);
      const EdgeRange range = edges_of(topology_, object);
      for (std::uint32_t e = range.begin; e < range.end; ++e) {
        const Edge& edge = topology_.edges[e];
        is_inner_[e] = edge.face1 != kNone && !is_line_[e] && edges_[e] != PatchEdge::tangent &&
                       edges_[e] != PatchEdge::sharp && is_curved(edge.face0) && is_curved(edge.face1);
      }
    }
  }

  /// `e`: an inner edge.
  bool may_hold_seam(std::uint32_t e) const {
    const Edge& edge = topology_.edges[e];
    return (is_free(edge.face0) || patches_.patch_of[edge.face0] != patches_.patch_of[edge.face1]) &&
           !(topology_.edge_flags[e] & kSpokenFor) &&
           glm::dot(face_normal(scene_, edge.face0), face_normal(scene_, edge.face1)) >= kSeamBendCosine;
  }

  void measure() {
    const std::vector<std::uint32_t> all = indices_of_marks(is_inner_);
    const std::vector<std::uint32_t> may_hold = indices_where(
        all.size(), [&](std::size_t k) { return may_hold_seam(all[k]); }, kSearchBlock);
    inner_.resize(may_hold.size());
    parallel_each(
        may_hold.size(),
        [&](std::size_t i) {
          const std::uint32_t e = all[may_hold[i]];
          const Edge& edge = topology_.edges[e];
          const double one = depth_behind(scene_, scene_.faces.contour(edge.face0, 0), edge);
          const double other = depth_behind(scene_, scene_.faces.contour(edge.face1, 0), edge);
          const bool is_unlike = std::max(one, other) >= kUnlikeDepths * std::min(one, other);
          inner_[i] = {e, !is_unlike ? kNone : one > other ? edge.face0 : edge.face1};
        },
        kSearchBlock);
    const std::vector<std::uint32_t> in_line = in_lines_by_depth();
    parallel_each(
        in_line.size(),
        [&](std::size_t i) {
          Inner& inner = inner_[in_line[i]];
          inner.section = sections_.at(inner.edge);
          inner.is_proof = inner.section && proves_seam(*inner.section);
        },
        kSearchBlock);
  }

  static bool proves_seam(const SeamSection& section) {
    const std::size_t round = section.round_side();
    const double turn = section.turn(round);
    return section.curvatures[1 - round] / section.curvatures[round] < kFlatRatio && turn > kLeastSeamTurn &&
           turn < kLargestSeamTurn;
  }

  /// The inner edges of unlike depths that others continue straight, with their deeper faces on the same side: most edges
  /// need not be measured. Numbers in inner_, ascending.
  std::vector<std::uint32_t> in_lines_by_depth() const {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> ends;
    for (std::uint32_t i = 0; i < inner_.size(); ++i) {
      const Edge& edge = topology_.edges[inner_[i].edge];
      if (inner_[i].deep != kNone) ends.insert(ends.end(), {{edge.v0, i}, {edge.v1, i}});
    }
    std::ranges::sort(ends);
    DisjointSets sets(inner_.size());
    for (auto first = ends.begin(), last = first; first != ends.end(); first = last) {
      const std::uint32_t v = first->first;
      while (last != ends.end() && last->first == v) ++last;
      if (last - first > kMostAtVertex) continue;
      for (auto end = first; end != last; ++end) {
        for (auto before = first; before != end; ++before) {
          const Inner &one = inner_[before->second], &other = inner_[end->second];
          const double cosine = -glm::dot(way(v, other_end(one.edge, v)), way(v, other_end(other.edge, v)));
          if (cosine < kSeamStraightCosine ||
              glm::dot(way_into(one, one.deep), way_into(other, other.deep)) < kFlatSideCosine)
            continue;
          sets.join(before->second, end->second);
        }
      }
    }
    std::vector<std::uint32_t> sizes(inner_.size());
    for (std::uint32_t i = 0; i < inner_.size(); ++i) ++sizes[sets.find(i)];
    return indices_where(inner_.size(),
                         [&](std::size_t i) { return sizes[sets.find(static_cast<std::uint32_t>(i))] >= kFewestUnlike; });
  }

  void hold() {
    is_held_.assign(scene_.vertices.size(), kFree);
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      const Edge& edge = topology_.edges[e];
      if (edge.face1 == kNone || is_line_[e] || edges_[e] == PatchEdge::tangent)
        is_held_[edge.v0] = is_held_[edge.v1] = kOnLine;
    }
  }

  std::uint32_t other_end(std::uint32_t e, std::uint32_t v) const { return ligne::other_end(topology_.edges[e], v); }
  Point3 way(std::uint32_t from, std::uint32_t to) const {
    return glm::normalize(scene_.vertices[to] - scene_.vertices[from]);
  }
  double length_of(std::uint32_t e) const { return edge_length(scene_, topology_.edges[e]); }
  Inner& inner_at(std::uint32_t e) { return *std::ranges::lower_bound(inner_, e, {}, &Inner::edge); }

  /// Unit vector across an edge into one of its faces.
  Point3 way_into(const Inner& inner, std::uint32_t face) const {
    return glm::normalize(across_face(scene_, topology_.edges[inner.edge], face));
  }

  Point3 flat_way(const Inner& inner) const {
    const Edge& edge = topology_.edges[inner.edge];
    return way_into(inner, inner.section->round_side() == 1 ? edge.face0 : edge.face1);
  }

  /// The inner edge that goes straight on behind an edge, or kNone.
  std::uint32_t edge_behind(std::uint32_t before, std::uint32_t v) const {
    std::uint32_t best = kNone;
    double best_cosine = kSeamStraightCosine;
    const auto first = std::ranges::lower_bound(ends_, std::pair(v, 0u));
    for (auto end = first; end != ends_.end() && end->first == v; ++end) {
      if (end - first >= kMostAtVertex) return kNone;
      const std::uint32_t behind = other_end(end->second, v);
      const double cosine = glm::dot(way(before, v), way(v, behind));
      if (behind != before && cosine > best_cosine) best = end->second, best_cosine = cosine;
    }
    return best;
  }

  /// Adds the edges that go on straight behind the last vertex of a line, up to another line, or the last one that proves a
  /// seam with its flat side on that of the line. A few edges between may prove nothing.
  void go_on(Line& line) {
    std::vector<Inner*> way_on;
    std::vector<std::uint32_t> vertices;
    const Inner* proof = line.edges.back();
    std::uint32_t before = line.vertices[line.vertices.size() - 2], v = line.vertices.back();
    for (std::uint32_t last = proof->edge; way_on.size() <= kMostWeakEdges;) {
      if (is_held_[v] || line.is_closed()) break;
      const std::uint32_t e = edge_behind(before, v);
      if (e == kNone || edge_behind(other_end(e, v), v) != last) return;
      Inner& inner = inner_at(last = e);
      before = std::exchange(v, other_end(e, v));
      vertices.push_back(v);
      way_on.push_back(&inner);
      if (inner.is_proof && glm::dot(flat_way(*proof), flat_way(inner)) >= kFlatSideCosine) {
        if (inner.is_done) return;
        proof = &inner;
      } else if (!is_held_[v]) {
        continue;
      }
      for (Inner* added : way_on) add(line, *added);
      line.vertices.insert(line.vertices.end(), vertices.begin(), vertices.end());
      way_on.clear();
      vertices.clear();
    }
  }

  void add(Line& line, Inner& inner) const {
    line.edges.push_back(&inner);
    line.length += length_of(inner.edge);
    inner.is_done = true;
  }

  Line line_through(std::uint32_t i) {
    Line line;
    line.vertices = {topology_.edges[inner_[i].edge].v0, topology_.edges[inner_[i].edge].v1};
    add(line, inner_[i]);
    go_on(line);
    std::ranges::reverse(line.vertices);
    std::ranges::reverse(line.edges);
    go_on(line);
    return line;
  }

  /// The sections across the edges of a line, those of its other edges too.
  std::vector<LineSection> sections_along(std::span<const std::uint32_t> vertices) {
    std::vector<LineSection> sections;
    for (std::size_t i = 1; i < vertices.size(); ++i) {
      const Inner& inner = inner_at(edge_between(topology_, vertices[i - 1], vertices[i]));
      const std::uint32_t face = topology_.edges[inner.edge].face0;
      LineSection at{length_of(inner.edge), inner.section ? inner.section : sections_.at(inner.edge)};
      const Point3 left = glm::cross(face_normal(scene_, face), way(vertices[i - 1], vertices[i]));
      if (at.section && glm::dot(left, way_into(inner, face)) < 0) {
        std::swap(at.section->curvatures[0], at.section->curvatures[1]);
        std::swap(at.section->depths[0], at.section->depths[1]);
      }
      sections.push_back(at);
    }
    return sections;
  }

  /// Continues a line from its last vertex, straight on up to another line, if that is not far.
  void close_gap(Line& line) {
    if (line.is_closed() || is_held_[line.vertices.back()] & kOnLine) return;
    std::uint32_t before = line.vertices[line.vertices.size() - 2], v = line.vertices.back();
    std::vector<std::uint32_t> gap{v};
    double length = 0;
    while (gap.size() <= kMostSeamGapEdges) {
      const std::uint32_t e = edge_behind(before, v);
      if (e == kNone) return;
      before = std::exchange(v, other_end(e, v));
      length += length_of(e);
      gap.push_back(v);
      if (length > kLongestSeamGap * line.length) return;
      if (is_held_[v]) break;
    }
    const LineBend bend = bend_along(sections_along(gap));
    if (bend.is_even() && bend.depth > kDeeperGap * line.bend.depth) return;
    line.vertices.insert(line.vertices.end(), gap.begin() + 1, gap.end());
  }

  /// Whether a line is smooth, or too short to tell but whole between two others.
  bool is_seam(const Line& line) const {
    if (line.vertices.size() > kFewestSeamEdges)
      return roughness(scene_, line.vertices) <= (line.bend.is_clear() ? kClearRoughness : kRoughness);
    return line.bend.is_whole() && (is_held_[line.vertices.front()] & is_held_[line.vertices.back()] & kOnLine) != 0;
  }

  double size_of(const Line& line) const {
    return object_size(scene_, scene_.objects[object_of_vertex(scene_, line.vertices[0])]);
  }

  /// Drops short lines that meet no other one, or one at one end alone.
  void drop_loose(std::vector<Line>& lines) const {
    std::vector<std::uint32_t> lines_at(scene_.vertices.size(), 0);
    for (const Line& line : lines)
      for (const std::uint32_t v : line.vertices) ++lines_at[v];
    const auto is_loose = [&](const Line& line) {
      const auto meets = [&](std::uint32_t v) { return (is_held_[v] & kOnLine) != 0 || lines_at[v] > 1; };
      const int ends = meets(line.vertices.front()) + meets(line.vertices.back());
      if (line.is_closed() || ends == 2) return false;
      if (ends == 1) return line.bend.depths < kDepthsOfShort && line.length < kShortestHalfOpen * size_of(line);
      return line.length < kShortestOpen * size_of(line);
    };
    for (bool changes = true; changes;) {
      std::vector<Line> kept, loose;
      for (Line& line : lines) (is_loose(line) ? loose : kept).push_back(std::move(line));
      for (const Line& line : loose)
        for (const std::uint32_t v : line.vertices) --lines_at[v];
      lines = std::move(kept);
      changes = !loose.empty();
    }
  }

  const Scene& scene_;
  const Topology& topology_;
  const Patches& patches_;
  const std::vector<std::uint8_t>& is_line_;
  std::vector<PatchEdge>& edges_;
  std::vector<std::uint8_t> is_inner_;  ///< per edge: 1 between two faces of free forms
  const SeamSections sections_{scene_, topology_, is_inner_};
  std::vector<Inner> inner_;                                   ///< edges that may_hold_seam(), ascending
  std::vector<std::uint8_t> is_held_;                          ///< per vertex: Held bits
  std::vector<std::pair<std::uint32_t, std::uint32_t>> ends_;  ///< vertices and edges of inner_, sorted
};

}  // namespace

void find_freeform_seams(const Scene& scene, const Topology& topology, const Patches& patches,
                         const std::vector<std::uint8_t>& is_line, std::vector<PatchEdge>& edges) {
  SeamFinder(scene, topology, patches, is_line, edges).run();
}

}  // namespace ligne
