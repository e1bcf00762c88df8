#include "scene/creases/find_creases.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <iterator>
#include <memory>
#include <span>
#include <utility>

#include "base/disjoint_sets.hpp"
#include "base/indices_where.hpp"
#include "base/no_index.hpp"
#include "base/parallel.hpp"
#include "scene/creases/bend.hpp"
#include "scene/creases/bends_by_faces.hpp"
#include "scene/creases/face_normals.hpp"
#include "scene/creases/fading_creases.hpp"
#include "scene/creases/loose_creases.hpp"
#include "scene/creases/parallel_bends.hpp"
#include "scene/creases/plane_rims.hpp"
#include "scene/model/bounds.hpp"
#include "scene/model/faces_and_edges.hpp"

namespace ligne {
namespace {

/// Adjustable. Parts are relative to the size of the object where nothing else is named.
constexpr double kShortPart = 1.0 / 16;     ///< shorter chains are dropped
constexpr double kSpurPart = 1.0 / 64;      ///< longer edges are not spurs
constexpr std::size_t kCertainEdges = 4;    ///< of creases that are continued over longer ways than themselves
constexpr double kTurnCosine = 0.70710678;  ///< cosine of 45 degrees: largest turn of a continued crease

class Finder {
 public:
  Finder(const Scene& scene, const Topology& topology, const CreaseAngles& angles)
      : scene_(scene), topology_(topology), angles_(angles), sizes_(object_sizes(scene)) {
    find_surfaces();
  }

  Creases run() {
    classify();
    collect();
    continue_ends();
    find_anchors();
    drop_fading();
    drop_loose();
    drop_spurs();
    drop_short();
    found_.lines.assign(bends_.size(), 0);
    for (const std::uint32_t e : indices_of_marks(bends_)) {
      if (bends_[e] >= Bend::strong) found_.lines[e] = kCreaseLine;
    }
    if (!mesh_.heights.empty()) found_.shapes = std::move(mesh_);
    return std::move(found_);
  }

 private:
  void find_surfaces() {
    // The search for patches leaves threads idle at times.
    parallel_tasks(2, [&](std::size_t task) {
      if (task == 0) {
        found_.patches = find_patches(scene_, topology_, mesh_);
      } else {
        by_faces_ = bends_by_faces(scene_, topology_, mesh_, sizes_, angles_.faces);
        sheets_ = find_sheet_edges(scene_, topology_, crease_cosine(angles_.faces));
      }
    });
  }

  void classify() {
    bends_ = std::move(by_faces_.bends);
    found_.smooth_by_file = by_faces_.smooth_by_file;
    found_.sharp_by_file = by_faces_.sharp_by_file;
    const std::vector<std::uint8_t>& bent = sheets_.bent;
    found_.walls = std::move(sheets_.walls);
    found_.folds = std::move(sheets_.folds);
    for (std::size_t e = 0, i = 0; i < bent.size() && e < bends_.size(); ++e) {
      if (!(topology_.edge_flags[e] & kEdgeManyFaces)) continue;
      bends_[e] = bent[i] ? Bend::firm : Bend::none;
      found_.straight_sheets += !bent[i++];
    }
    raw_ = bends_;
    decide_by_surfaces();
    TracedCreases traced = trace_creases({scene_, topology_, mesh_, sizes_, found_.patches.is_freeform, found_.patch_edges},
                                         angles_.faces, bends_);
    found_.scans = std::move(traced.scans);
    found_.decimated = traced.decimated;
    found_.untraced = traced.left_out;
    found_.traced = traced.continued;
  }

  /// Edges inside one surface are not creases, at any angle of its facets. Edges at which surfaces meet at an angle are
  /// creases.
  void decide_by_surfaces() {
    bend_beside_slivers();
    found_.patch_edges = classify_patch_edges(scene_, topology_, mesh_, found_.patches, angles_.surfaces);
    if (!found_.patches.list.empty()) mark_bands(scene_, topology_, mesh_.normals, found_.patch_edges, found_.patches);
    for (const std::uint32_t e : indices_of_marks(found_.patch_edges)) {
      // A fillet too small to be drawn as a surface is drawn as an edge, whichever surface it belongs to.
      if ((topology_.edge_flags[e] & kEdgeSmooth) && bends_[e] >= Bend::strong) continue;
      const Bend bend = found_.patch_edges[e] == PatchEdge::sharp ? Bend::strong : Bend::none;
      found_.inside_surfaces += bend == Bend::none && bends_[e] >= Bend::strong;
      found_.between_surfaces += bend == Bend::strong && bends_[e] < Bend::strong;
      bends_[e] = bend == Bend::none ? bend : std::max(bend, bends_[e]);
    }
  }

  /// Gives slivers the normals of their planes, and finds the edges that bend only then.
  void bend_beside_slivers() {
    constexpr std::uint16_t kDecided = kEdgeManyFaces | kEdgeUnlikeWound | kEdgeFileHidden | kEdgeInner | kEdgeSmooth;
    const float least = crease_cosine(angles_.faces);
    const std::vector<std::uint32_t> turned =
        turn_plane_slivers(scene_, topology_, found_.patches.plane_edges, mesh_.normals);
    const auto measure = [&](std::uint32_t e) {
      const Edge& edge = topology_.edges[e];
      mesh_.cosines[e] = glm::dot(mesh_.normals[edge.face0], mesh_.normals[edge.face1]);
    };
    std::ranges::for_each(turned, measure);
    std::ranges::for_each(found_.patches.plane_edges, measure);
    for (const std::uint32_t e : turned) {
      const bool is_bent = mesh_.cosines[e] < least;
      if (is_bent && !(topology_.edge_flags[e] & kDecided)) bends_[e] = raw_[e] = std::max(bends_[e], Bend::strong);
    }
  }

  /// A vertex at which edges that bend end; its entries in ends_ begin at `first`.
  struct Node {
    std::uint32_t vertex, first;
    std::uint32_t creases;  ///< number of its edges that are creases by themselves
  };

  bool is_crease(std::uint32_t e) const { return bends_[e] >= Bend::strong; }

  /// Collects the edges that may be creases, or would be without surfaces, by vertex.
  void collect() {
    std::vector<std::uint32_t> bent;
    std::ranges::set_union(indices_of_marks(bends_), indices_of_marks(raw_), std::back_inserter(bent));
    for (const std::uint32_t e : bent) {
      ends_.push_back({topology_.edges[e].v0, e});
      ends_.push_back({topology_.edges[e].v1, e});
    }
    if (ends_.empty()) return;
    parallel_sort(ends_.begin(), ends_.end());
    soften_fillets(scene_, topology_, {ends_, found_.patch_edges, rows_}, angles_.faces, bends_);
    node_of_vertex_.assign(scene_.vertices.size(), kNone);
    for (std::uint32_t k = 0; k < ends_.size(); ++k) {
      std::uint32_t& node = node_of_vertex_[ends_[k].vertex];
      if (node == kNone) {
        node = static_cast<std::uint32_t>(nodes_.size());
        nodes_.push_back({ends_[k].vertex, k, 0});
      }
      nodes_.back().creases += is_crease(ends_[k].edge);
    }
  }

  /// The node of a vertex, or kNone.
  std::uint32_t node_of(std::uint32_t v) const { return node_of_vertex_[v]; }

  std::span<const BendEnd> ends_of(std::uint32_t node) const {
    const std::size_t last = node + 1 == nodes_.size() ? ends_.size() : nodes_[node + 1].first;
    return std::span(ends_).subspan(nodes_[node].first, last - nodes_[node].first);
  }

  struct Chain {  ///< connected creases
    double length = 0;
    std::size_t edges = 0;
    bool firm = false, open = false, anchored = false;
  };
  struct Chains {
    DisjointSets sets;                                           ///< sets of nodes
    std::vector<Chain> list;                                     ///< by the representative node of the set
    std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;  ///< a node, and a crease that begins at it
    Chain& of(std::uint32_t node) { return list[sets.find(node)]; }
  };

  double length_of(std::uint32_t e) const { return edge_length(scene_, topology_.edges[e]); }

  Chains chains() const {
    Chains found{DisjointSets(nodes_.size()), std::vector<Chain>(nodes_.size()), {}};
    for (std::uint32_t node = 0; node < nodes_.size(); ++node) {
      for (const BendEnd& end : ends_of(node)) {
        if (!is_crease(end.edge) || topology_.edges[end.edge].v0 != nodes_[node].vertex) continue;
        found.edges.emplace_back(node, end.edge);
        found.sets.join(node, node_of(topology_.edges[end.edge].v1));
      }
    }
    for (const auto& [node, e] : found.edges) {
      Chain& chain = found.of(node);
      chain.length += length_of(e);
      ++chain.edges;
      chain.firm = chain.firm || bends_[e] == Bend::firm;
    }
    return found;
  }

  /// Continues every loose end of a crease along weak edges in its direction that lead to another crease, if these are no
  /// longer than either crease, or the only way on, or the border of a plane. Continuations are not continued themselves,
  /// so the order does not matter.
  void continue_ends() {
    Chains found = chains();
    PlaneRims rims(scene_, topology_, found_.patches, found_.patch_edges);
    std::vector<std::uint32_t> joined;
    for (std::uint32_t node = 0; node < nodes_.size(); ++node) {
      if (nodes_[node].creases != 1) continue;
      for (const BendEnd& end : ends_of(node)) {
        if (!is_crease(end.edge)) continue;
        std::vector<std::uint32_t> way = way_on(node, end.edge, found);
        if (!is_line(scene_, topology_, rows_, way)) way.clear();
        const auto is_at_crease = [&](std::uint32_t v) {
          const std::uint32_t other = node_of(v);
          return other != kNone && nodes_[other].creases > 0;
        };
        if (way.empty() && found.of(node).edges >= kCertainEdges)
          way = rims.way_on(end.edge, nodes_[node].vertex, found.of(node).length, is_at_crease);
        joined.insert(joined.end(), way.begin(), way.end());
      }
    }
    for (const std::uint32_t e : joined) {
      found_.continued += bends_[e] != Bend::strong;  // from both of its ends
      bends_[e] = Bend::strong;
    }
  }

  /// Unit vector along an edge to the vertex of a node.
  Point3 direction_to(std::uint32_t node, std::uint32_t e) const {
    const std::uint32_t v = nodes_[node].vertex, from = other_end(topology_.edges[e], v);
    return glm::normalize(scene_.vertices[v] - scene_.vertices[from]);
  }

  /// The weak edges by which crease e continues behind a node to another crease; empty if it reaches none.
  std::vector<std::uint32_t> way_on(std::uint32_t node, std::uint32_t e, Chains& found) const {
    // Bounds on the edges of the way and on the edges per vertex, which bound the work per end. Adjustable.
    constexpr std::size_t kLongestWay = 64, kMostEnds = 64;
    std::vector<std::uint32_t> way;
    // Edges that the file calls smooth continue those that it calls sharp: where most of a ring is sharp, all of it is.
    const std::uint16_t kept_out = topology_.edge_flags[e] & kEdgeSharp ? 0 : kEdgeSmooth;
    const double longest = found.of(node).length;
    double length = 0;
    bool is_clear = found.of(node).edges >= kCertainEdges;
    while (way.size() < kLongestWay || is_clear) {
      const Point3 direction = direction_to(node, e);
      const std::span<const BendEnd> ends = ends_of(node);
      if (ends.size() > kMostEnds) return {};
      std::uint32_t best = kNone;
      double best_cosine = kTurnCosine;
      for (const BendEnd& next : ends) {
        if (next.edge == e || bends_[next.edge] != Bend::weak || (topology_.edge_flags[next.edge] & kept_out)) continue;
        const double cosine = -glm::dot(direction_to(node, next.edge), direction);
        if (cosine > best_cosine) best = next.edge, best_cosine = cosine;
      }
      if (best == kNone) return {};
      way.push_back(best);
      // The way on is clear where it is the only one, and not one of many along a fillet.
      is_clear = is_clear && ends.size() == 2 && !is_inside_fillet(rows_, best);
      length += length_of(best);
      if (length > longest && !is_clear) return {};
      node = node_of(other_end(topology_.edges[best], nodes_[node].vertex));
      e = best;
      if (nodes_[node].creases > 0) {
        if (length > found.of(node).length && !(is_clear && found.of(node).edges >= kCertainEdges)) return {};
        return way;
      }
    }
    return {};
  }

  std::size_t creases_at(std::uint32_t node) const {
    return static_cast<std::size_t>(
        std::ranges::count_if(ends_of(node), [&](const BendEnd& end) { return is_crease(end.edge); }));
  }

  /// Marks nodes on borders: a crease that ends at one does not end in the middle of a surface.
  void find_anchors() {
    anchored_.assign(nodes_.size(), 0);
    if (nodes_.empty()) return;
    for (const std::uint32_t e : edges_with(topology_, kEdgeBorder)) {
      for (const std::uint32_t v : {topology_.edges[e].v0, topology_.edges[e].v1}) {
        const std::uint32_t node = node_of(v);
        if (node != kNone) anchored_[node] = 1;
      }
    }
  }

  /// Whether neither surfaces nor the file decide an edge, nor is it one of a scan, which were traced.
  bool is_decided_by_bend(std::uint32_t e) const {
    const auto has_edge = [&](const ScanObject& scan) { return e >= scan.edge_begin && e < scan.edge_end; };
    return found_.patch_edges[e] == PatchEdge::unknown && !(topology_.edge_flags[e] & kEdgeSharp) &&
           std::ranges::none_of(found_.scans, has_edge);
  }

  void drop_fading() {
    const auto may_fade = [&](std::uint32_t e) { return is_decided_by_bend(e); };
    const auto is_anchor = [&](std::uint32_t vertex) { return anchored_[node_of(vertex)] != 0; };
    found_.fading = drop_fading_creases(scene_, topology_,
                                        {rows_, ends_, sizes_, found_.patches.is_freeform, may_fade, is_anchor}, bends_);
  }

  void drop_loose() {
    if (nodes_.empty()) return;
    std::vector<std::uint8_t> is_tangent(scene_.vertices.size(), 0);  // per vertex: 1 on a tangent line
    for (const std::uint32_t e : indices_of_marks(found_.patch_edges)) {
      if (found_.patch_edges[e] != PatchEdge::tangent) continue;
      for (const std::uint32_t v : {topology_.edges[e].v0, topology_.edges[e].v1}) is_tangent[v] = 1;
    }
    const auto may_go = [&](std::uint32_t e) {
      return is_decided_by_bend(e) && topology_.edges[e].face1 != kNone && !(topology_.edge_flags[e] & kEdgeManyFaces);
    };
    const auto is_anchor = [&](std::uint32_t v) { return anchored_[node_of(v)] != 0 || is_tangent[v] != 0; };
    found_.loose = drop_loose_creases(scene_, topology_, {ends_, sizes_, may_go, is_anchor}, bends_);
  }

  bool is_open(std::uint32_t node) const { return !anchored_[node] && creases_at(node) == 1; }

  /// Drops single short edges that branch off a crease.
  void drop_spurs() {
    std::vector<std::uint32_t> spurs;
    for (std::uint32_t node = 0; node < nodes_.size(); ++node) {
      if (!is_open(node)) continue;
      for (const BendEnd& end : ends_of(node)) {
        if (bends_[end.edge] != Bend::strong) continue;
        const Edge& edge = topology_.edges[end.edge];
        if (length_of(end.edge) >= kSpurPart * size_at(edge.v0)) continue;
        if (creases_at(node_of(other_end(edge, nodes_[node].vertex))) >= 3) spurs.push_back(end.edge);
      }
    }
    for (const std::uint32_t e : spurs) bends_[e] = Bend::none;
    found_.spurs = spurs.size();
  }

  void drop_short() {
    Chains found = chains();
    for (std::uint32_t node = 0; node < nodes_.size(); ++node) {
      if (is_open(node)) found.of(node).open = true;
      if (anchored_[node] && creases_at(node) > 0) found.of(node).anchored = true;
    }
    const auto stays = [&](std::uint32_t root) {
      const Chain& chain = found.list[root];
      const bool ends_nowhere = !chain.open && (chain.anchored || chain.edges > 3);  // three: the rim of a triangle
      return chain.firm || ends_nowhere || chain.length >= kShortPart * size_at(nodes_[root].vertex);
    };
    for (const auto& [node, e] : found.edges) {
      if (!stays(found.sets.find(node))) bends_[e] = Bend::none;
    }
    for (std::uint32_t root = 0; root < nodes_.size(); ++root) {
      if (found.list[root].edges == 0 || stays(root)) continue;
      found_.short_chains += found.list[root].edges;
      found_.short_length += found.list[root].length;
    }
  }

  double size_at(std::uint32_t vertex) const { return sizes_[object_of_vertex(scene_, vertex)]; }

  const Scene& scene_;
  const Topology& topology_;
  CreaseAngles angles_;
  std::vector<double> sizes_;  ///< per object
  MeshAngles mesh_ = mesh_angles(scene_, topology_, sizes_);
  EdgeRows rows_{scene_, topology_, mesh_.normals};
  FaceBends by_faces_;
  SheetEdges sheets_;
  std::vector<Bend> bends_, raw_;  ///< per edge; raw: by its faces alone
  std::vector<BendEnd> ends_;      ///< ends of the edges that bend, sorted
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> node_of_vertex_;  ///< per vertex: index into nodes_, or kNone
  std::vector<std::uint8_t> anchored_;         ///< per node: 1 on a border
  Creases found_;
};

}  // namespace

std::function<Creases()> search_creases(const Scene& scene, const Topology& topology, const CreaseAngles& angles) {
  return [finder = std::make_shared<Finder>(scene, topology, angles)] { return finder->run(); };
}

Creases find_creases(const Scene& scene, const Topology& topology, const CreaseAngles& angles) {
  return Finder(scene, topology, angles).run();
}

}  // namespace ligne
