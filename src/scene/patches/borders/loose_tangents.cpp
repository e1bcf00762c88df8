#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <span>

#include "base/disjoint_sets.hpp"
#include "base/indices_where.hpp"
#include "base/no_index.hpp"
#include "scene/model/bounds.hpp"
#include "scene/model/faces_and_edges.hpp"
#include "scene/model/topology.hpp"
#include "scene/patches/borders/edge_chains.hpp"
#include "scene/patches/borders/patch_edges.hpp"
#include "scene/patches/borders/tangent_evidence.hpp"

namespace ligne {
namespace {

/// Adjustable. Largest number of edges of a chain of tangent edges that is dropped if no other line begins at its end.
/// Chains with the side of a strip of a cylinder are kept.
constexpr std::size_t kMostLooseEdges = 3;
/// Adjustable. Longest line of up to kMostLooseEdges edges from a free end to a corner that is dropped as a hook at the
/// line beyond, as a fraction of the diagonal of its object's bounding box.
constexpr double kLongestHook = 1.0 / 16;
/// Adjustable. Chains of up to kMostLooseEdges edges beside a plane are kept where one end lies on another line and they are
/// longer than this part of that diagonal.
constexpr double kLongRow = 1.0 / 8;
/// Adjustable. Largest total length of connected tangent edges that are dropped because they meet no other line, as a
/// fraction of the diagonal of their object's bounding box. Longer ones tell more of the shape than their loose ends
/// disturb.
constexpr double kLongestLoneTree = 0.25;
/// Adjustable. The same of those that enclose something. They are the borders of facets in the midst of a surface that
/// are no part of it by accident, or of dimples that are too small to be seen.
constexpr double kLongestLoneLoop = 1.0 / 32;

/// Adjustable. Of a tooth in a border beside a free form or between curved surfaces: the largest cosine of the turn at
/// either end (40 degrees), and its largest length, in depths of the facet behind it.
constexpr double kToothCosine = 0.77, kToothDepths = 3;
/// Adjustable. A line of more edges for each of its teeth is no jagged one: single facets are on its wrong side.
constexpr std::size_t kEdgesPerTooth = 24;

/// A vertex at which tangent edges end: their number, the exclusive or of their indices (the index itself if one edge
/// is left), and whether another line ends there too.
struct TangentNode {
  std::uint32_t vertex = 0, count = 0, numbers = 0;
  bool is_held = false;
  bool is_loose() const { return count == 1 && !is_held; }
  bool is_passed() const { return count == 2 && !is_held; }  ///< a line goes on there
};

/// Connected tangent edges. They form a tree if they have one node more than edges.
struct TangentTree {
  std::int64_t nodes_less_edges = 0;
  double length = 0;
  bool is_kept = false;
};

std::vector<std::uint32_t> tangent_edges(const std::vector<PatchEdge>& edges) {
  std::vector<std::uint32_t> tangent = indices_of_marks(edges);
  std::erase_if(tangent, [&](std::uint32_t e) { return edges[e] != PatchEdge::tangent; });
  return tangent;
}

class TangentChains {
 public:
  TangentChains(const Scene& scene, const Topology& topology, const Patches& patches, std::vector<PatchEdge>& edges)
      : scene_(scene), topology_(topology), patches_(patches), edges_(edges) {
    for (const std::uint32_t e : tangents_) {
      for (const std::uint32_t v : ends_of(e)) nodes_.push_back({v});
    }
    std::ranges::sort(nodes_, {}, &TangentNode::vertex);
    const auto is_same = [](const TangentNode& l, const TangentNode& r) { return l.vertex == r.vertex; };
    nodes_.erase(std::unique(nodes_.begin(), nodes_.end(), is_same), nodes_.end());
    for (const std::uint32_t e : tangents_) {
      for (const std::uint32_t v : ends_of(e)) {
        TangentNode& node = *node_at(v);
        ++node.count;
        node.numbers ^= e;
      }
    }
  }

  bool empty() const { return nodes_.empty(); }

  /// Marks the vertices at which other lines end. These lines hold the tangent edges there.
  void hold(const std::vector<std::uint8_t>& is_line) {
    const auto hold_ends = [&](std::span<const std::uint32_t> lines) {
      for (const std::uint32_t e : lines) {
        for (const std::uint32_t v : ends_of(e)) {
          if (TangentNode* node = node_at(v)) node->is_held = true;
        }
      }
    };
    hold_ends(indices_of_marks(is_line));
    hold_ends(edges_with(topology_, kEdgeBorder | kEdgeManyFaces));
  }

  /// Drops the lines with teeth. A border that turns to one side and back within a facet follows the facets, as it does
  /// where a surface or plane was found by accident, and not the shape.
  void drop_jagged() {
    std::vector<std::uint32_t> teeth, line;
    for (const std::uint32_t e : tangents_) {
      if (edges_[e] == PatchEdge::tangent && is_tooth(e)) teeth.push_back(e);
    }
    for (const std::uint32_t tooth : teeth) {
      if (edges_[tooth] != PatchEdge::tangent) continue;
      line.assign(1, tooth);
      for (const std::uint32_t v : ends_of(tooth)) {
        std::uint32_t e = tooth;
        for (const TangentNode* node = node_at(v); node->is_passed(); node = other_end(e, *node)) {
          e ^= node->numbers;
          if (e == tooth) break;
          line.push_back(e);
        }
        if (line.size() > 1 && e == tooth) break;  // a ring
      }
      const auto count = std::ranges::count_if(line, [&](std::uint32_t e) { return std::ranges::binary_search(teeth, e); });
      if (static_cast<std::size_t>(count) * kEdgesPerTooth < line.size()) continue;
      for (const std::uint32_t e : line) drop(e);
    }
  }

  /// Drops lines between curved surfaces that are loose at both ends, as those along the bands of a bent tube. A line with
  /// an edge between unlike surfaces is none of those.
  void drop_between_curved() {
    std::vector<std::uint32_t> line;
    for (const TangentNode& first : nodes_) {
      if (!first.is_loose()) continue;
      line.clear();
      const TangentNode* node = &first;
      for (std::uint32_t e = first.numbers; is_between_curved(e) && !is_between_unlike(e); e ^= node->numbers) {
        line.push_back(e);
        node = other_end(e, *node);
        if (!node->is_passed()) break;
      }
      if (!node->is_loose() || line.empty()) continue;
      for (const std::uint32_t e : line) drop(e);
    }
  }

  /// Drops the shorter one of two lines beside a free form that meet at a corner where no third line ends, except beside
  /// sides of strips and single teeth. Where three surfaces meet, three borders do: a border with corners of its own follows
  /// the facets of a surface that lies in a free form by accident.
  void drop_cornered() {
    std::vector<std::uint32_t> shorter;
    Line line, other;
    for (const std::uint32_t e : tangents_) {
      if (edges_[e] != PatchEdge::tangent || !is_in_freeform(e)) continue;
      for (const std::uint32_t v : ends_of(e)) {
        const TangentNode& node = *node_at(v);
        const std::uint32_t next = node.numbers ^ e;
        if (!node.is_passed() || !is_in_freeform(next) || !is_corner(e, next, v)) continue;
        if (is_tooth(e) || is_tooth(next)) continue;
        follow(e, node, line);
        follow(next, node, other);
        const bool is_kept = line.is_of_strip || other.is_of_strip || line.length > other.length;
        if (!is_kept) shorter.insert(shorter.end(), line.edges.begin(), line.edges.end());
      }
    }
    std::ranges::sort(shorter);
    shorter.erase(std::unique(shorter.begin(), shorter.end()), shorter.end());
    for (const std::uint32_t e : shorter) drop(e);
  }

  /// Drops connected tangent edges that meet no other line and are short for their object, shorter where they enclose
  /// something than where they form a tree. Those with a side of a strip, or between unlike surfaces, are kept.
  void drop_lone_trees() {
    std::vector<std::uint32_t> tangent;
    for (const std::uint32_t e : tangents_) {
      if (edges_[e] == PatchEdge::tangent) tangent.push_back(e);
    }
    DisjointSets sets(nodes_.size());
    for (const std::uint32_t e : tangent) sets.join(end_number(e, 0), end_number(e, 1));
    std::vector<TangentTree> trees(nodes_.size());
    for (std::uint32_t n = 0; n < nodes_.size(); ++n) {
      TangentTree& tree = trees[sets.find(n)];
      ++tree.nodes_less_edges;
      tree.is_kept |= nodes_[n].is_held;
    }
    for (const std::uint32_t e : tangent) {
      TangentTree& tree = trees[sets.find(end_number(e, 0))];
      --tree.nodes_less_edges;
      tree.length += edge_length(scene_, topology_.edges[e]);
      tree.is_kept |= is_of_strip(e) || is_between_unlike(e);
    }
    for (const std::uint32_t e : tangent) {
      TangentTree& tree = trees[sets.find(end_number(e, 0))];
      if (tree.is_kept) continue;
      const double longest = tree.nodes_less_edges == 1 ? kLongestLoneTree : kLongestLoneLoop;
      tree.is_kept = tree.length > longest * size_of_object(ends_of(e)[0]);
      if (!tree.is_kept) edges_[e] = PatchEdge::inside;
    }
  }

  /// Drops loose chains of up to kMostLooseEdges edges, except sides of strips, and of longer ones the hooks at their ends.
  void drop_flecks() {
    std::vector<std::uint32_t> chain, loose;
    for (const TangentNode& first : nodes_) {
      if (!first.is_loose()) continue;
      chain.assign(1, first.numbers);
      std::size_t hook = 0;  // number of edges up to the first corner
      const TangentNode* node = other_end(chain.back(), first);
      while (node->is_passed() && chain.size() <= kMostLooseEdges) {
        const std::uint32_t next = node->numbers ^ chain.back();  // the other one of the two edges
        if (hook == 0 && is_corner(chain.back(), next, node->vertex)) hook = chain.size();
        chain.push_back(next);
        node = other_end(chain.back(), *node);
      }
      if (node->is_held && is_long_row(chain)) continue;
      const auto is_strip = [&](std::uint32_t e) { return is_of_strip(e); };
      if (chain.size() > kMostLooseEdges || std::ranges::any_of(chain, is_strip)) {
        chain.resize(hook);
        if (chain.empty() || std::ranges::any_of(chain, is_strip) || !is_short(chain)) continue;
      }
      loose.insert(loose.end(), chain.begin(), chain.end());
    }
    for (const std::uint32_t e : loose) edges_[e] = PatchEdge::inside;
  }

 private:
  std::array<std::uint32_t, 2> ends_of(std::uint32_t e) const { return {topology_.edges[e].v0, topology_.edges[e].v1}; }

  void drop(std::uint32_t e) {
    edges_[e] = PatchEdge::inside;
    for (const std::uint32_t v : ends_of(e)) {
      TangentNode& node = *node_at(v);
      --node.count;
      node.numbers ^= e;
    }
  }

  /// Whether an edge lies between a surface and a free form.
  bool is_in_freeform(std::uint32_t e) const {
    return is_between_curved(e) &&
           (patches_.is_freeform[topology_.edges[e].face0] || patches_.is_freeform[topology_.edges[e].face1]);
  }

  struct Line {
    std::vector<std::uint32_t> edges;
    double length = 0;
    bool is_of_strip = false;  ///< whether one of its edges is a side of a strip
  };

  /// The line that begins with an edge at a node, up to the next corner, end of another line or other kind of faces.
  void follow(std::uint32_t first, const TangentNode& from, Line& line) {
    line.edges.clear();
    line.length = 0;
    line.is_of_strip = false;
    const TangentNode* node = &from;
    for (std::uint32_t e = first; is_between_curved(e);) {
      line.edges.push_back(e);
      line.is_of_strip |= is_of_strip(e);
      line.length += edge_length(scene_, topology_.edges[e]);
      node = other_end(e, *node);
      const std::uint32_t next = node->numbers ^ e;
      if (!node->is_passed() || next == first || is_corner(e, next, node->vertex)) return;
      e = next;
    }
  }

  bool is_curved(std::uint32_t face) const { return patches_.patch_of[face] != kNone || patches_.is_freeform[face]; }

  /// Whether an edge lies between two surfaces at which the shape changes, see are_unlike().
  bool is_between_unlike(std::uint32_t e) const {
    return is_between_curved(e) && are_unlike(scene_, patches_, topology_.edges[e]);
  }

  bool is_between_curved(std::uint32_t e) const {
    return is_curved(topology_.edges[e].face0) && is_curved(topology_.edges[e].face1);
  }

  /// Whether the line turns to one side and back at the ends of an edge, see kToothDepths.
  bool is_tooth(std::uint32_t e) {
    const Edge& edge = topology_.edges[e];
    const TangentNode &first = *node_at(edge.v0), &last = *node_at(edge.v1);
    if (!first.is_passed() || !last.is_passed() || are_unlike(scene_, patches_, edge)) return false;
    const Point3 &from = scene_.vertices[edge.v0], &to = scene_.vertices[edge.v1], way = to - from;
    const double squared = glm::dot(way, way);
    const auto is_short = [&](std::uint32_t face, std::uint32_t beyond) {
      if (!patches_.is_freeform[face] && !(is_curved(face) && is_curved(beyond))) return false;
      return std::ranges::any_of(scene_.faces.contour(face, 0), [&](std::uint32_t v) {
        return squared <= kToothDepths * glm::length(glm::cross(way, scene_.vertices[v] - from));
      });
    };
    if (!is_short(edge.face0, edge.face1) && !is_short(edge.face1, edge.face0)) return false;
    const Point3 before = from - scene_.vertices[other_end(first.numbers ^ e, first)->vertex];
    const Point3 behind = scene_.vertices[other_end(last.numbers ^ e, last)->vertex] - to;
    const auto turns = [&](const Point3& a, const Point3& b) {
      return glm::dot(a, b) <= kToothCosine * glm::length(a) * glm::length(b);
    };
    const Point3 normal = face_normal(scene_, edge.face0) + face_normal(scene_, edge.face1);
    const double left = glm::dot(glm::cross(before, way), normal), back = glm::dot(glm::cross(way, behind), normal);
    return turns(before, way) && turns(way, behind) && left * back < 0;
  }

  /// Whether a chain is a hook by its length.
  bool is_short(std::span<const std::uint32_t> chain) {
    return length_of(chain) <= kLongestHook * size_of_object(ends_of(chain[0])[0]);
  }

  /// Whether a chain is long, and lies between a plane and rows of a free form.
  bool is_long_row(std::span<const std::uint32_t> chain) {
    const auto is_row = [&](std::uint32_t e) { return is_of_row_at_plane(scene_, topology_, patches_, e); };
    return length_of(chain) >= kLongRow * size_of_object(ends_of(chain[0])[0]) && std::ranges::all_of(chain, is_row);
  }

  double length_of(std::span<const std::uint32_t> chain) const {
    double length = 0;
    for (const std::uint32_t e : chain) length += edge_length(scene_, topology_.edges[e]);
    return length;
  }

  /// Whether two edges that meet at a vertex belong to different lines.
  bool is_corner(std::uint32_t e, std::uint32_t next, std::uint32_t vertex) const {
    const auto away = [&](std::uint32_t edge) {
      return scene_.vertices[ligne::other_end(topology_.edges[edge], vertex)] - scene_.vertices[vertex];
    };
    const Point3 from = away(e), to = away(next);
    return -glm::dot(from, to) < kChainCosine * glm::length(from) * glm::length(to);
  }

  bool is_of_strip(std::uint32_t e) const { return ligne::is_of_strip(scene_, topology_, patches_, e); }

  /// Diagonal of the bounding box of the object that a vertex belongs to.
  double size_of_object(std::uint32_t vertex) {
    const std::size_t object = object_of_vertex(scene_, vertex);
    sizes_.resize(scene_.objects.size(), -1);
    if (sizes_[object] < 0) sizes_[object] = object_size(scene_, scene_.objects[object]);
    return sizes_[object];
  }

  TangentNode* node_at(std::uint32_t v) {
    const auto at = std::ranges::lower_bound(nodes_, v, {}, &TangentNode::vertex);
    return at != nodes_.end() && at->vertex == v ? &*at : nullptr;
  }

  /// Index of the node at an end of a tangent edge: 0 for its first vertex, 1 for its second one.
  std::uint32_t end_number(std::uint32_t e, int end) {
    return static_cast<std::uint32_t>(node_at(ends_of(e)[end]) - nodes_.data());
  }

  TangentNode* other_end(std::uint32_t e, const TangentNode& node) {
    return node_at(ligne::other_end(topology_.edges[e], node.vertex));
  }

  const Scene& scene_;
  const Topology& topology_;
  const Patches& patches_;
  std::vector<PatchEdge>& edges_;
  /// The edges that were tangent at first, ascending. Some are dropped.
  const std::vector<std::uint32_t> tangents_ = tangent_edges(edges_);
  std::vector<TangentNode> nodes_;  ///< sorted by vertex
  std::vector<double> sizes_;       ///< per object; negative where not computed
};

}  // namespace

void drop_loose_tangents(const Scene& scene, const Topology& topology, const Patches& patches,
                         const std::vector<std::uint8_t>& is_line, std::vector<PatchEdge>& edges) {
  close_unlike_borders(scene, topology, patches, edges);
  TangentChains chains(scene, topology, patches, edges);
  if (chains.empty()) return;
  chains.hold(is_line);
  chains.drop_jagged();
  chains.drop_cornered();
  chains.drop_between_curved();
  chains.drop_flecks();
  chains.drop_lone_trees();
}

}  // namespace ligne
