#include "scene/patches/refine/split_triangles.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>
#include <span>

#include "base/disjoint_sets.hpp"
#include "base/indices_where.hpp"
#include "base/no_index.hpp"
#include "base/parallel.hpp"
#include "base/parallel_each.hpp"
#include "scene/patches/refine/chord_corners.hpp"
#include "scene/patches/refine/shared_point.hpp"
#include "scene/patches/refine/turned_edges.hpp"

namespace ligne {
namespace {

/// Largest number of times that an edge is halved: each divides the sag by four.
constexpr int kMostLevels = 4;
/// Edges whose middle lies nearer to a surface, in their lengths, are straight: rulings, and edges of circles of more than a
/// thousand sides.
constexpr double kStraight = 1e-3;
/// A corner of a torus nearer than this to the circle along which a plane touches it lies on that circle, in radii of the
/// tube: the plane has the direction of the torus there by a thousandth.
constexpr double kTouchPart = 1e-3;

/// A side of a triangle: the key of its edge, and the part.
struct PartSide {
  std::uint64_t key;
  std::uint32_t part;
  bool operator<(const PartSide& o) const { return std::pair(key, part) < std::pair(o.key, o.part); }
};

class Splitter {
 public:
  Splitter(const Scene& scene, const Topology& topology, const Patches& patches, const PlaneRegions& planes,
           const EdgeLevels& levels)
      : scene_(scene),
        topology_(topology),
        patches_(patches),
        planes_(planes),
        sets_(patches.list.size()),
        levels_(levels.of_patch),
        rims_(levels.rims) {}

  /// Refines, and begins again without the surfaces on which triangles were turned over, and those connected with them.
  SplitTriangles run() {
    while (!try_levels()) {
    }
    return std::move(out_);
  }

 private:
  static constexpr std::uint32_t kBlocked = kNone - 1, kRim = kNone - 2, kFree = kNone - 3;  ///< values of beyond_

  /// Returns false if surfaces were left out.
  bool try_levels() {
    out_ = {};
    beyond_ = {};
    out_.is_region_split.assign(planes_.list.size(), 0);
    list_parts();
    mark_edges();
    join_surfaces();
    if (!move_corners()) return false;
    if (turns_edges_) turn_slivers(out_.parts, out_.placed.empty() ? scene_.vertices : out_.placed, scene_, patches_);
    if (leave_out_surfaces()) return false;
    for (int level = 0; level < kMostLevels && split_edges(level); ++level) split_parts();
    return !leave_out_folds();
  }

  const Point3& point(std::uint32_t v) const {
    if (v >= scene_.vertices.size()) return out_.points[v - scene_.vertices.size()];
    return out_.placed.empty() ? scene_.vertices[v] : out_.placed[v];
  }

  std::uint32_t patch_of(const PartSide& side) const { return patches_.patch_of[out_.parts[side.part].face]; }

  bool is_refined(std::uint32_t face) const {
    return face != kNone && patches_.patch_of[face] != kNone && levels_[patches_.patch_of[face]] > 0;
  }
  bool is_free(std::uint32_t face) const { return patches_.patch_of[face] == kNone && patches_.is_freeform[face]; }

  /// The triangles of refined surfaces, and those of free forms beside these, which are divided at their vertices.
  void list_parts() {
    std::vector<std::uint8_t> is_beside(scene_.faces.size(), 0);
    for (const Edge& edge : topology_.edges) {
      if (edge.face1 == kNone) continue;
      if (is_refined(edge.face0) && is_free(edge.face1)) is_beside[edge.face1] = 1;
      if (is_refined(edge.face1) && is_free(edge.face0)) is_beside[edge.face0] = 1;
    }
    for (const Triangle& t : topology_.triangles) {
      if (is_refined(t.face) || is_beside[t.face]) out_.parts.push_back({t.v, t.face});
    }
  }

  /// Marks the edges at which planes border on surfaces, and those at which no surface may be refined.
  void mark_edges() {
    for (std::uint32_t e = 0; e < topology_.edges.size(); ++e) {
      const Edge& edge = topology_.edges[e];
      const bool is_blocked = edge.face1 == kNone || (topology_.edge_flags[e] & (kEdgeManyFaces | kEdgeUnlikeWound));
      for (const auto& [face, other] : {std::pair(edge.face0, edge.face1), std::pair(edge.face1, edge.face0)}) {
        if (!is_refined(face)) continue;
        const bool is_rim = other == kNone && std::ranges::binary_search(rims_, e);
        const std::uint32_t region = is_rim           ? kRim
                                     : is_blocked     ? kBlocked
                                     : is_free(other) ? kFree
                                                      : planes_.region_of[other];
        if (region != kNone) beyond_[edge_key(edge.v0, edge.v1)] = region;
      }
    }
  }

  std::vector<PartSide> sorted_sides() const {
    std::vector<PartSide> sides;
    sides.reserve(3 * out_.parts.size());
    for (std::uint32_t i = 0; i < out_.parts.size(); ++i) {
      const auto& v = out_.parts[i].v;
      for (std::size_t k = 0; k < 3; ++k) sides.push_back({edge_key(v[k], v[(k + 1) % 3]), i});
    }
    std::sort(sides.begin(), sides.end());
    return sides;
  }

  /// Calls visit(sides of one edge) for each edge of refined surfaces.
  template <class Visit>
  void for_edges(const std::vector<PartSide>& sides, Visit visit) const {
    for (std::size_t i = 0; i < sides.size();) {
      std::size_t j = i + 1;
      while (j < sides.size() && sides[j].key == sides[i].key) ++j;
      const std::span edge = std::span(sides).subspan(i, j - i);
      if (patch_of(edge[0]) != kNone || patch_of(edge.back()) != kNone) visit(edge);
      i = j;
    }
  }

  /// A surface at an edge.
  std::uint32_t patch_at(std::span<const PartSide> edge) const {
    return patch_of(edge[0]) != kNone ? patch_of(edge[0]) : patch_of(edge.back());
  }
  SideSurface side_surface(std::uint32_t patch) const { return {&patches_.list[patch].surface}; }

  /// The point that splits an edge; nothing if its other side can not be split.
  std::optional<Point3> middle_of(std::span<const PartSide> edge) const {
    const std::uint32_t region = beyond_.find(edge[0].key);
    const bool is_rim = (edge.size() == 1 && region == kRim) || (edge.size() == 2 && region == kFree);
    const bool ends_at_plane = edge.size() == 1 && region < kFree;
    if (!is_rim && !ends_at_plane && (edge.size() != 2 || region != kNone)) return std::nullopt;
    const SideSurface here = side_surface(patch_at(edge));
    const SideSurface there = ends_at_plane ? SideSurface{nullptr, planes_.list[region].at, planes_.list[region].normal}
                              : is_rim      ? here
                                            : side_surface(patch_of(edge.back()));
    return shared_point(here, there, point(first_of(edge[0].key)), point(second_of(edge[0].key)));
  }

  static std::uint32_t first_of(std::uint64_t key) { return static_cast<std::uint32_t>(key >> 32); }
  static std::uint32_t second_of(std::uint64_t key) { return static_cast<std::uint32_t>(key); }

  Point3 middle_of_chord(std::uint64_t key) const { return 0.5 * (point(first_of(key)) + point(second_of(key))); }

  bool is_straight(const std::uint64_t key, const Point3& at) const {
    const double length = glm::distance(point(first_of(key)), point(second_of(key)));
    return glm::distance(at, middle_of_chord(key)) <= kStraight * length;
  }

  double cosine(std::uint32_t u, std::uint32_t v, std::uint32_t w, const Patch& patch) const {
    return cosine_to_surface(point(u), point(v), point(w), patch);
  }

  /// Leaves out the surfaces of new triangles that stand across them, as long slivers fold, if edges have been turned.
  /// Returns whether there are any.
  bool leave_out_folds() {
    std::vector<std::uint32_t> left_out;
    for (const FacePart& part : out_.parts) {
      const bool is_new = std::ranges::any_of(part.v, [&](std::uint32_t v) { return v >= scene_.vertices.size(); });
      const std::uint32_t patch = patches_.patch_of[part.face];
      if (is_new && patch != kNone && cosine(part.v[0], part.v[1], part.v[2], patches_.list[patch]) < kLeastPartCosine)
        left_out.push_back(patch);
    }
    // Other edges may do better.
    if (!left_out.empty() && turns_edges_) leave_out(left_out);
    turns_edges_ = true;
    return !left_out.empty();
  }

  /// Leaves out surfaces and all that are connected with them by curved edges.
  void leave_out(const std::vector<std::uint32_t>& patches) {
    std::vector<std::uint8_t> is_left_out(levels_.size(), 0);
    for (const std::uint32_t patch : patches) is_left_out[sets_.find(patch)] = 1;
    for (std::uint32_t patch = 0; patch < levels_.size(); ++patch) {
      if (is_left_out[sets_.find(patch)]) levels_[patch] = 0;
    }
  }

  bool is_curved(std::span<const PartSide> edge) const {
    const Point3 middle = middle_of_chord(edge[0].key);
    return std::ranges::any_of(edge, [&](const PartSide& side) {
      return patch_of(side) != kNone && !is_straight(edge[0].key, patches_.list[patch_of(side)].surface.nearest(middle));
    });
  }

  /// Connects the surfaces on both sides of curved edges.
  void join_surfaces() {
    for_edges(sorted_sides(), [&](std::span<const PartSide> edge) {
      if (!is_curved(edge)) return;
      for (const PartSide& side : edge) {
        if (patch_of(side) != kNone) sets_.join(patch_of(side), patch_at(edge));
      }
    });
  }

  /// Moves vertices on chords onto their surfaces. Returns false if surfaces are left out because that is not possible.
  bool move_corners() {
    const ChordCorners chords = chord_corners(scene_, topology_, patches_, planes_, levels_);
    if (!chords.patches.empty()) {
      leave_out(chords.patches);
      return false;
    }
    if (chords.moved.empty()) return true;
    out_.placed = scene_.vertices;
    for (std::size_t i = 0; i < chords.moved.size(); ++i) out_.placed[chords.moved[i]] = chords.places[i];
    for (const std::uint32_t region : chords.regions) out_.is_region_split[region] = 1;
    turns_edges_ = true;
    return true;
  }

  /// Leaves out the surfaces with a curved edge that can not be split, and those connected with them by curved edges.
  /// Returns whether there are any.
  bool leave_out_surfaces() {
    std::vector<std::uint32_t> left_out;
    for_edges(sorted_sides(), [&](std::span<const PartSide> edge) {
      if (is_curved(edge) && !middle_of(edge)) left_out.push_back(patch_at(edge));
    });
    leave_out(left_out);
    return !left_out.empty();
  }

  /// Halves the curved edges of the surfaces of a higher level. Returns whether there are any.
  bool split_edges(int level) {
    bool any = false;
    for_edges(sorted_sides(), [&](std::span<const PartSide> edge) {
      const std::uint64_t key = edge[0].key;
      if (levels_[patch_at(edge)] <= level) return;
      const std::optional<Point3> at = middle_of(edge);
      if (!at || is_straight(key, *at)) return;
      any = true;
      const auto vertex = static_cast<std::uint32_t>(scene_.vertices.size() + out_.points.size());
      const std::uint32_t a = first_of(key), b = second_of(key);
      out_.middles[key] = vertex;
      out_.points.push_back(*at);
      out_.beside.push_back(a < scene_.vertices.size() ? a : out_.beside[a - scene_.vertices.size()]);
      if (const std::uint32_t region = beyond_.find(key); region != kNone) {
        if (region < kFree) out_.is_region_split[region] = 1;
        beyond_[edge_key(a, vertex)] = region;
        beyond_[edge_key(vertex, b)] = region;
      }
    });
    return any;
  }

  void split_parts() {
    std::vector<FacePart> parts;
    for (const FacePart& part : out_.parts) split(part, parts);
    out_.parts = std::move(parts);
  }

  /// Divides a part at the new vertices on its sides.
  void split(const FacePart& part, std::vector<FacePart>& parts) const {
    std::array<std::uint32_t, 3> m;
    std::size_t count = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      m[k] = out_.middles.find(edge_key(part.v[k], part.v[(k + 1) % 3]));
      count += m[k] != kNone;
    }
    // The first side of one, the first two of two.
    std::size_t first = 0;
    if (count == 1)
      while (m[first] == kNone) ++first;
    if (count == 2)
      while (m[(first + 2) % 3] != kNone) ++first;
    const auto [a, b, c] = std::array{part.v[first], part.v[(first + 1) % 3], part.v[(first + 2) % 3]};
    const auto [ab, bc, ca] = std::array{m[first], m[(first + 1) % 3], m[(first + 2) % 3]};
    const auto add = [&](std::uint32_t u, std::uint32_t v, std::uint32_t w) { parts.push_back({{u, v, w}, part.face}); };
    if (count == 0) {
      parts.push_back(part);
    } else if (count == 1) {
      add(a, ab, c);
      add(ab, b, c);
    } else if (count == 2) {
      add(ab, b, bc);
      const bool through_a = is_better_through_a(part.face, {a, ab, bc, c});
      add(a, ab, through_a ? bc : c);
      add(through_a ? a : ab, bc, c);
    } else {
      add(a, ab, ca);
      add(ab, b, bc);
      add(ca, bc, c);
      add(ab, bc, ca);
    }
  }

  /// Whether the quadrilateral a, ab, bc, c is better divided through a than through c: along its surface, or through the
  /// shorter diagonal of a free form.
  bool is_better_through_a(std::uint32_t face, const std::array<std::uint32_t, 4>& v) const {
    const auto [a, ab, bc, c] = v;
    if (patches_.patch_of[face] == kNone) return glm::distance(point(a), point(bc)) < glm::distance(point(ab), point(c));
    const Patch& patch = patches_.list[patches_.patch_of[face]];
    return std::min(cosine(a, ab, bc, patch), cosine(a, bc, c, patch)) >
           std::min(cosine(a, ab, c, patch), cosine(ab, bc, c, patch));
  }

  const Scene& scene_;
  const Topology& topology_;
  const Patches& patches_;
  const PlaneRegions& planes_;
  DisjointSets sets_;                 ///< of patches that are connected by curved edges
  std::vector<std::uint8_t> levels_;  ///< per patch: how often its edges are halved
  std::span<const std::uint32_t> rims_;
  KeyTable beyond_;           ///< by the key of an edge: the plane region beyond it, kRim, or kBlocked
  bool turns_edges_ = false;  ///< edges of slivers are turned before any is split
  SplitTriangles out_;
};

}  // namespace

void SplitTriangles::append_pieces(std::uint32_t a, std::uint32_t b, std::vector<std::uint32_t>& to) const {
  const std::uint32_t middle = middles.find(edge_key(a, b));
  if (middle == kNone) {
    to.push_back(a);
    return;
  }
  append_pieces(a, middle, to);
  append_pieces(middle, b, to);
}

/// Distance of the middle of an edge from a surface on which its ends lie. Of an edge along which a plane touches a torus:
/// from the circle of that line, since the plane leaves the torus only slowly.
double off_border(const PatchSurface& surface, const Point3& p, const Point3& q) {
  const Point3 middle = 0.5 * (p + q);
  const double off = std::abs(surface.distance(middle));
  if (surface.kind != SurfaceKind::torus) return off;
  const auto is_on_line = [&](const Point3& end) {
    return std::abs(axis_place(surface, end).radius - surface.radius) <= kTouchPart * surface.tube;
  };
  return is_on_line(p) && is_on_line(q) ? std::max(off, surface.radius - axis_place(surface, middle).radius) : off;
}

EdgeLevels edge_levels(const Scene& scene, const Topology& topology, const Patches& patches, const RefineLimits& limits) {
  constexpr std::uint8_t kCurved = 1;
  const auto patch_of = [&](std::uint32_t face) { return face == kNone ? kNone : patches.patch_of[face]; };
  std::vector<std::uint8_t> level(topology.edges.size(), 0);  // kCurved plus the halvings that an edge needs; 0: straight
  parallel_each(level.size(), [&](std::size_t e) {
    const Edge& edge = topology.edges[e];
    const Point3 &p = scene.vertices[edge.v0], &q = scene.vertices[edge.v1], middle = 0.5 * (p + q);
    for (const std::uint32_t patch : {patch_of(edge.face0), patch_of(edge.face1)}) {
      if (patch == kNone || patches.list[patch].is_band) continue;
      const double off = off_border(patches.list[patch].surface, p, q);
      if (off <= kStraight * glm::distance(p, q)) continue;
      double mm = off * limits.unit_mm(middle);
      std::uint8_t needed = kCurved;
      for (; mm > limits.most_mm && needed < kCurved + kMostLevels; mm /= 4) ++needed;
      level[e] = std::max(level[e], needed);
    }
  });
  EdgeLevels found;
  if (*std::ranges::max_element(level) <= kCurved) return found;
  found.curved = indices_where(level.size(), [&](std::size_t e) { return level[e] > 0; });
  DisjointSets sets(patches.list.size());
  std::vector<std::uint8_t> of_set(patches.list.size(), 0);
  for (const std::uint32_t e : found.curved) {
    const std::uint32_t a = patch_of(topology.edges[e].face0), b = patch_of(topology.edges[e].face1);
    if (a != kNone && b != kNone) sets.join(a, b);
  }
  for (const std::uint32_t e : found.curved) {
    for (const std::uint32_t patch : {patch_of(topology.edges[e].face0), patch_of(topology.edges[e].face1)}) {
      if (patch == kNone) continue;
      std::uint8_t& highest = of_set[sets.find(patch)];
      highest = std::max<std::uint8_t>(highest, level[e] - kCurved);
    }
  }
  found.of_patch.assign(patches.list.size(), 0);
  for (std::uint32_t p = 0; p < found.of_patch.size(); ++p) {
    found.set_of.push_back(sets.find(p));
    if (!patches.list[p].is_band) found.of_patch[p] = of_set[sets.find(p)];
  }
  return found;
}

SplitTriangles split_triangles(const Scene& scene, const Topology& topology, const Patches& patches,
                               const PlaneRegions& planes, const EdgeLevels& levels) {
  return Splitter(scene, topology, patches, planes, levels).run();
}

}  // namespace ligne
