#include "scene/patches/borders/tangent_gaps.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <iterator>
#include <span>
#include <utility>

#include "base/indices_where.hpp"
#include "base/no_index.hpp"
#include "base/parallel.hpp"
#include "scene/model/faces_and_edges.hpp"
#include "scene/patches/borders/edge_chains.hpp"

namespace ligne {
namespace {

// Adjustable.
/// Longest gap that is closed, as a fraction of the line that leads to it.
constexpr double kLargestGapPart = 0.5;
/// Most edges of a gap, and of a line whose length is compared with it.
constexpr std::size_t kMostEdges = 256;

class GapCloser {
 public:
  GapCloser(const Scene& scene, const Topology& topology, const Patches& patches, const std::vector<std::uint8_t>& is_line,
            std::vector<PatchEdge>& edges)
      : scene_(scene), topology_(topology), patches_(patches), is_line_(is_line), edges_(edges) {}

  void run() {
    std::vector<std::uint32_t> candidates;
    std::ranges::set_union(edges_outside_freeforms(topology_, patches_), indices_of_marks(is_line_),
                           std::back_inserter(candidates));
    for (const std::uint32_t e : candidates) {
      const Kind kind = kind_of(e);
      if (kind == Kind::none) continue;
      for (const std::uint32_t v : {topology_.edges[e].v0, topology_.edges[e].v1}) ends_.push_back({v, kind, e});
    }
    parallel_sort(ends_.begin(), ends_.end());
    for (std::size_t first = 0, last = 0; first < ends_.size(); first = last) {
      while (last < ends_.size() && ends_[last].vertex == ends_[first].vertex) ++last;
      // The tangent edges at a vertex come before lines, and lines before open borders.
      if (ends_[first].kind != Kind::tangent || (last - first > 1 && ends_[first + 1].kind != Kind::open)) continue;
      follow(ends_[first]);
    }
    std::ranges::sort(reached_);
    for (const Line& line : unsupported_) {
      if (std::ranges::binary_search(reached_, line.tip)) continue;
      for (const std::uint32_t e : line.edges) edges_[e] = PatchEdge::inside;
    }
    for (const std::uint32_t e : closed_) edges_[e] = PatchEdge::tangent;
  }

 private:
  enum class Kind : std::uint8_t { tangent, line, open, none };

  struct End {
    std::uint32_t vertex;
    Kind kind;
    std::uint32_t edge;
    auto operator<=>(const End&) const = default;
  };

  struct Line {
    std::uint32_t tip;
    std::vector<std::uint32_t> edges;
  };

  Kind kind_of(std::uint32_t e) const {
    if (is_line_[e] || (topology_.edge_flags[e] & (kEdgeBorder | kEdgeManyFaces))) return Kind::line;
    if (edges_[e] == PatchEdge::tangent) return Kind::tangent;
    if (edges_[e] != PatchEdge::unknown) return Kind::none;
    const Edge& edge = topology_.edges[e];
    const bool is_border = patches_.is_freeform[edge.face0] != patches_.is_freeform[edge.face1] ||
                           (!patches_.list.empty() && patches_.patch_of[edge.face0] != patches_.patch_of[edge.face1]);
    return is_border ? Kind::open : Kind::none;
  }

  std::span<const End> ends_at(std::uint32_t vertex) const {
    const auto first = std::ranges::lower_bound(ends_, vertex, {}, &End::vertex);
    auto last = first;
    while (last != ends_.end() && last->vertex == vertex) ++last;
    return {first, last};
  }

  std::uint32_t other_end(std::uint32_t e, std::uint32_t v) const { return ligne::other_end(topology_.edges[e], v); }
  Point3 way_from(std::uint32_t e, std::uint32_t v) const { return scene_.vertices[other_end(e, v)] - scene_.vertices[v]; }

  /// The open border that goes straight on behind an edge at a vertex, or kNone.
  std::uint32_t next_open(std::uint32_t e, std::uint32_t vertex) const {
    const Point3 back = glm::normalize(way_from(e, vertex));
    std::uint32_t best = kNone;
    double best_cosine = kChainCosine;
    for (const End& end : ends_at(vertex)) {
      if (end.kind != Kind::open || end.edge == e) continue;
      const double cosine = -glm::dot(glm::normalize(way_from(end.edge, vertex)), back);
      if (cosine > best_cosine) best = end.edge, best_cosine = cosine;
    }
    return best;
  }

  void follow(const End& loose) {
    std::vector<std::uint32_t> gap;
    double gap_length = 0;
    std::uint32_t vertex = loose.vertex;
    for (std::uint32_t e = loose.edge; gap.size() < kMostEdges;) {
      e = next_open(e, vertex);
      if (e == kNone) return;
      gap.push_back(e);
      gap_length += glm::length(way_from(e, vertex));
      vertex = other_end(e, vertex);
      const auto ends = ends_at(vertex);
      if (ends.front().kind != Kind::open) break;
    }
    if (gap.size() == kMostEdges) return;
    const std::uint32_t reached = vertex;
    Line line{loose.vertex, {}};
    double length = 0;
    vertex = loose.vertex;
    for (std::uint32_t e = loose.edge; line.edges.size() < kMostEdges;) {
      line.edges.push_back(e);
      length += glm::length(way_from(e, vertex));
      vertex = other_end(e, vertex);
      const auto ends = ends_at(vertex);
      const auto tangents = static_cast<std::size_t>(std::ranges::count(ends, Kind::tangent, &End::kind));
      if (tangents != 2 || (ends.size() > 2 && ends[2].kind == Kind::line)) break;
      e = ends[ends[0].edge == e ? 1 : 0].edge;
    }
    if (gap_length <= kLargestGapPart * length) {
      closed_.insert(closed_.end(), gap.begin(), gap.end());
      reached_.push_back(reached);
    } else if (gap_length > length) {
      unsupported_.push_back(std::move(line));
    }
  }

  const Scene& scene_;
  const Topology& topology_;
  const Patches& patches_;
  const std::vector<std::uint8_t>& is_line_;
  std::vector<PatchEdge>& edges_;
  std::vector<End> ends_;               ///< sorted
  std::vector<std::uint32_t> closed_;   ///< edges of gaps
  std::vector<std::uint32_t> reached_;  ///< vertices at which these gaps end
  std::vector<Line> unsupported_;       ///< lines that are shorter than the gap behind their tip
};

}  // namespace

void close_tangent_gaps(const Scene& scene, const Topology& topology, const Patches& patches,
                        const std::vector<std::uint8_t>& is_line, std::vector<PatchEdge>& edges) {
  if (std::ranges::find(edges, PatchEdge::tangent) == edges.end()) return;
  GapCloser(scene, topology, patches, is_line, edges).run();
}

}  // namespace ligne
