#include "scene/creases/loose_creases.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <compare>
#include <numbers>

#include "base/disjoint_sets.hpp"
#include "base/no_index.hpp"
#include "base/parallel.hpp"
#include "scene/model/bounds.hpp"

namespace ligne {
namespace {

/// Adjustable: loose creases shorter than this part of their object go. They look like scratches.
constexpr double kLoosePart = 1.0 / 8;

// Adjustable, of connected creases that are no sharper than the form around them.
/// Radians: creases that bend more on average stay.
constexpr double kBluntBend = 60 * std::numbers::pi / 180;
/// Least ratio of their mean bend to that of the edges around them; larger where they fork, as lines of a design seldom do.
/// It is 1.3 to 4.7 on the backs, cheeks and legs of coarse animals, and 9 or more at most rims of pots and statues that are
/// meshed as coarsely.
constexpr double kBluntTimes = 4, kForkedTimes = 5;
/// Number of rings of faces around an edge, and the largest number of these faces.
constexpr int kRingsAround = 2;
constexpr std::size_t kMostFacesAround = 64;
/// Rings stay that are longer than this part of their object.
constexpr double kLongRingPart = 1.0 / 2;

/// Lengths of edges, and their bends weighted by these.
struct BendSum {
  double length = 0, turn = 0;
  void add(double of_length, double bend) { length += of_length, turn += of_length * std::abs(bend); }
  double mean() const { return length > 0 ? turn / length : 0; }
};

class BluntCreases {
 public:
  BluntCreases(const Scene& scene, const Topology& topology, const BluntEdges& edges, std::vector<Bend>& bends)
      : scene_(scene), topology_(topology), edges_(edges), bends_(bends) {}

  std::size_t drop() {
    collect();
    for (std::size_t first = 0, last = 0; first < creases_.size(); first = last) {
      while (last < creases_.size() && creases_[last].group == creases_[first].group) ++last;
      const auto group = std::span(creases_).subspan(first, last - first);
      if (is_blunt(group)) blunt_.insert(blunt_.end(), group.begin(), group.end());
    }
    for (const Crease& crease : blunt_) bends_[crease.edge] = Bend::weak;
    return blunt_.size();
  }

 private:
  struct Crease {
    std::uint32_t group, edge;
    friend auto operator<=>(const Crease&, const Crease&) = default;
  };

  bool is_crease(std::uint32_t e) const { return bends_[e] >= Bend::strong; }

  /// The first end at a vertex, which stands for it.
  std::uint32_t first_end(std::uint32_t v) const {
    return static_cast<std::uint32_t>(std::lower_bound(edges_.ends.begin(), edges_.ends.end(), BendEnd{v, 0}) -
                                      edges_.ends.begin());
  }

  /// Collects the creases by the groups in which they are connected.
  void collect() {
    DisjointSets sets(edges_.ends.size());
    for (std::uint32_t k = 0, first = 0; k < edges_.ends.size(); ++k) {
      const auto [v, e] = edges_.ends[k];
      if (edges_.ends[first].vertex != v) first = k;
      if (!is_crease(e) || topology_.edges[e].v0 != v) continue;
      creases_.push_back({first, e});
      sets.join(creases_.back().group, first_end(topology_.edges[e].v1));
    }
    for (Crease& crease : creases_) crease.group = sets.find(crease.group);
    parallel_sort(creases_.begin(), creases_.end());
  }

  bool is_blunt(std::span<const Crease> group) const {
    if (!std::ranges::all_of(group, edges_.may_go, &Crease::edge)) return false;
    if (std::ranges::all_of(group, [&](const Crease& crease) { return is_across_strip(crease.edge); })) return false;
    BendSum sum;
    for (const Crease& crease : group) sum.add(length_of(crease.edge), bend(crease.edge));
    if (sum.mean() >= kBluntBend) return false;
    const std::size_t object = object_of_vertex(scene_, topology_.edges[group.front().edge].v0);
    const auto [fewest, most] = creases_at_vertices(group);
    if (sum.length >= kLongRingPart * edges_.sizes[object] && fewest == 2 && most == 2) return false;
    if (!std::ranges::all_of(group, edges_.is_in_large, &Crease::edge)) return false;
    double around = 0;
    for (const Crease& crease : group) around += length_of(crease.edge) * around_edge(crease.edge).mean();
    const double times = most > 2 ? kForkedTimes : kBluntTimes;
    return sum.turn < times * around;
  }

  bool is_across_strip(std::uint32_t e) const {
    return edges_.is_anchor(topology_.edges[e].v0) && edges_.is_anchor(topology_.edges[e].v1);
  }

  /// The smallest and the largest number of creases of the group that meet at a vertex.
  std::array<std::size_t, 2> creases_at_vertices(std::span<const Crease> group) const {
    std::vector<std::uint32_t> at;
    for (const Crease& crease : group)
      at.insert(at.end(), {topology_.edges[crease.edge].v0, topology_.edges[crease.edge].v1});
    std::ranges::sort(at);
    std::array found{at.size(), std::size_t{0}};
    for (auto first = at.begin(); first != at.end();) {
      const auto last = std::upper_bound(first, at.end(), *first);
      const auto count = static_cast<std::size_t>(last - first);
      found = {std::min(found[0], count), std::max(found[1], count)};
      first = last;
    }
    return found;
  }

  /// The edges around a crease that are no creases.
  BendSum around_edge(std::uint32_t e) const {
    BendSum sum;
    std::vector<std::uint32_t> faces{topology_.edges[e].face0, topology_.edges[e].face1}, seen;
    for (std::size_t ring = 0, begin = 0; ring <= kRingsAround; ++ring) {
      const std::size_t end = faces.size();
      for (std::size_t k = begin; k < end; ++k) {
        const auto contour = scene_.faces.contour(faces[k], 0);
        for (std::size_t i = 0; i < contour.size(); ++i) {
          const std::uint32_t side = edge_between(topology_, contour[i], contour[i + 1 == contour.size() ? 0 : i + 1]);
          if (side == kNone || topology_.edges[side].face1 == kNone || is_in(seen, side)) continue;
          if (topology_.edge_flags[side] & (kEdgeManyFaces | kEdgeUnlikeWound)) continue;
          seen.push_back(side);
          const std::uint32_t beyond = other_face(topology_.edges[side], faces[k]);
          if (ring < kRingsAround && faces.size() < kMostFacesAround && !is_in(faces, beyond)) faces.push_back(beyond);
          if (!is_crease(side)) sum.add(length_of(side), bend(side));
        }
      }
      begin = end;
    }
    return sum;
  }

  static bool is_in(const std::vector<std::uint32_t>& list, std::uint32_t number) {
    return std::ranges::count(list, number) > 0;
  }

  double length_of(std::uint32_t e) const { return edge_length(scene_, topology_.edges[e]); }
  double bend(std::uint32_t e) const { return edges_.rows.bend(e, topology_.edges[e].face0); }

  const Scene& scene_;
  const Topology& topology_;
  const BluntEdges& edges_;
  std::vector<Bend>& bends_;
  std::vector<Crease> creases_, blunt_;  ///< creases_ ascending
};

}  // namespace

std::vector<std::uint32_t> FreeEnds::list() const {
  std::vector<std::uint32_t> found;
  for (std::size_t first = 0, last = 0; first < ends_.size(); first = last) {
    std::size_t creases = 0;
    for (last = first; last < ends_.size() && ends_[last].vertex == ends_[first].vertex; ++last)
      creases += is_crease(ends_[last].edge);
    if (creases == 1) found.push_back(ends_[first].vertex);
  }
  return found;
}

std::uint32_t FreeEnds::only_crease_at(std::uint32_t vertex, std::uint32_t except) const {
  std::uint32_t found = kNone;
  for (auto end = std::lower_bound(ends_.begin(), ends_.end(), BendEnd{vertex, 0});
       end != ends_.end() && end->vertex == vertex; ++end) {
    if (end->edge == except || !is_crease(end->edge)) continue;
    if (found != kNone) return kNone;
    found = end->edge;
  }
  return found;
}

std::size_t drop_loose_creases(const Scene& scene, const Topology& topology, const LooseEdges& edges,
                               std::vector<Bend>& bends) {
  const FreeEnds free(topology, edges.ends, bends, edges.is_anchor);
  const auto is_smooth = [&](std::uint32_t e) {
    return bends[e] == Bend::firm && (topology.edge_flags[e] & kEdgeSmooth) != 0;
  };
  const auto is_loose = [&](std::uint32_t tip, const FreeEnds::Run& run) {
    if (run.edges.empty()) return false;
    double length = 0;
    for (const std::uint32_t e : run.edges) length += edge_length(scene, topology.edges[e]);
    if (length >= kLoosePart * edges.sizes[object_of_vertex(scene, tip)]) return false;
    if (std::ranges::all_of(run.edges, is_smooth)) return true;
    const bool is_firm = std::ranges::any_of(run.edges, [&](std::uint32_t e) { return bends[e] == Bend::firm; });
    return !is_firm && run.end != tip && free.is_free(run.end);
  };
  return drop_from_free_ends(free, bends, [&](std::uint32_t tip, auto& gone, auto& left) {
    const FreeEnds::Run run = free.run_from(tip, edges.may_go);
    if (!is_loose(tip, run)) return;
    gone.insert(gone.end(), run.edges.begin(), run.edges.end());
    left.push_back(run.end);
  });
}

std::size_t drop_blunt_creases(const Scene& scene, const Topology& topology, const BluntEdges& edges,
                               std::vector<Bend>& bends) {
  return BluntCreases(scene, topology, edges, bends).drop();
}

}  // namespace ligne
