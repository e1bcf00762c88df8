#include "scene/creases/fading_creases.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <numbers>
#include <utility>

#include "base/disjoint_sets.hpp"
#include "base/indices_where.hpp"
#include "base/no_index.hpp"
#include "scene/creases/edge_sections.hpp"
#include "scene/creases/loose_creases.hpp"
#include "scene/model/face_area.hpp"
#include "scene/model/object_sizes.hpp"

namespace ligne {
namespace {

/// Adjustable: runs that end freely and are shorter than this part of their object go. Shorter lines inside a surface look
/// like scratches on it.
constexpr double kLongRunPart = 1.0 / 4;
/// Adjustable: as kLongRunPart, for runs that bend on average by a turn of six facets or more (radians), as the legs of a
/// coarse animal do.
constexpr double kFirmRunPart = 1.0 / 8, kFirmBend = 60 * std::numbers::pi / 180;
/// Adjustable: least part of the area of a free form in itself and what it borders on, where creases fade. The others are
/// parts of constructed bodies.
constexpr double kFreeformPart = 0.75;
/// Adjustable, radians: creases do not end with edges that bend by less, half of the least angle between surfaces.
constexpr double kFlatEnd = 5 * std::numbers::pi / 180;
/// Adjustable: creases may end with such edges where these are longer than this part of their object.
constexpr double kLongFlatPart = 1.0 / 32;
/// Adjustable: largest part of its object over which a section across an edge is followed.
constexpr double kReachPart = 1.0 / 6;
/// Adjustable, radians: least turn across an edge of a tube. Roundings of machine parts turn by less.
constexpr double kTubeTurn = 200 * std::numbers::pi / 180;

class Fader {
 public:
  Fader(const Scene& scene, const Topology& topology, const FadingEdges& edges, std::vector<Bend>& bends)
      : scene_(scene),
        topology_(topology),
        edges_(edges),
        ends_(edges.ends),
        bends_(bends),
        free_(topology, edges.ends, bends, edges.is_anchor),
        regions_(scene.objects.size()) {}

  std::size_t run() {
    std::size_t dropped = drop_flat_ends() + drop_inside_sections();
    std::vector<std::uint32_t> tips = free_.list();
    while (!tips.empty()) {
      std::vector<std::uint32_t> faded, left;
      for (const std::uint32_t tip : tips) {
        if (free_.is_free(tip)) fade(tip, faded, left);
      }
      for (const std::uint32_t e : faded) {
        dropped += free_.is_crease(e);
        bends_[e] = Bend::weak;
      }
      tips = std::move(left);
    }
    return dropped + drop_blunt();
  }

 private:
  /// Takes back edges at free ends that hardly bend, where they are short.
  std::size_t drop_flat_ends() {
    std::size_t dropped = 0;
    for (std::uint32_t tip : free_.list()) {
      double rest = kLongFlatPart * edges_.sizes[object_of_vertex(scene_, tip)];
      std::vector<std::uint32_t> flat;
      std::uint32_t e = free_.only_crease_at(tip, kNone);
      for (std::uint32_t vertex = tip; e != kNone && rest >= 0 && is_flat(e); e = free_.only_crease_at(vertex, e)) {
        flat.push_back(e);
        rest -= length_of(e);
        vertex = free_.other_end(e, vertex);
        if (edges_.is_anchor(vertex)) break;
      }
      if (rest < 0 || edges_.is_anchor(tip)) continue;
      for (const std::uint32_t edge : flat) bends_[edge] = Bend::weak;
      dropped += flat.size();
    }
    return dropped;
  }

  /// Takes back edges inside no rows of parallel ones at which the surface bends on alike. Narrow roundings between planes
  /// do so, too, and are edges of their part: they stay outside large regions, where tubes go.
  std::size_t drop_inside_sections() {
    std::vector<std::uint8_t> is_tube(ends_.size(), 0);  // per end: 1 if its edge turns as that of a tube
    const auto turns = [&](std::size_t k) {
      const auto [vertex, e] = ends_[k];
      if (topology_.edges[e].v0 != vertex || !free_.is_crease(e) || !is_between_freeforms(e)) return false;
      if (is_inside_rounding(edges_.rows, e)) return false;
      const double turn = turn_across(scene_, topology_, e, kReachPart * edges_.sizes[object_of_vertex(scene_, vertex)]);
      is_tube[k] = turn >= kTubeTurn;
      return turn > 0;
    };
    std::vector<std::uint32_t> inside = indices_where(ends_.size(), turns, kSearchBlock);
    std::erase_if(inside,
                  [&](std::uint32_t k) { return !is_tube[k] && !is_in_large_region(topology_.edges[ends_[k].edge]); });
    for (const std::uint32_t k : inside) bends_[ends_[k].edge] = Bend::weak;
    return inside.size();
  }

  std::size_t drop_blunt() {
    const std::function<bool(std::uint32_t)> may_go = [this](std::uint32_t e) { return is_between_freeforms(e); };
    const std::function<bool(std::uint32_t)> is_in_large = [this](std::uint32_t e) {
      return is_in_large_region(topology_.edges[e]);
    };
    return drop_blunt_creases(scene_, topology_, {edges_.rows, ends_, edges_.sizes, may_go, is_in_large, edges_.is_anchor},
                              bends_);
  }

  bool is_flat(std::uint32_t e) const {
    const bool is_marked = topology_.edge_flags[e] & (kEdgeManyFaces | kEdgeUnlikeWound | kEdgeSharp);
    const std::uint32_t face = topology_.edges[e].face0;
    return topology_.edges[e].face1 != kNone && !is_marked && std::abs(edges_.rows.bend(e, face)) < kFlatEnd;
  }

  bool may_fade(std::uint32_t e) { return is_between_freeforms(e) && is_in_large_region(topology_.edges[e]); }

  bool is_between_freeforms(std::uint32_t e) const {
    const Edge& edge = topology_.edges[e];
    if (edge.face1 == kNone || (topology_.edge_flags[e] & (kEdgeManyFaces | kEdgeUnlikeWound))) return false;
    if (!edges_.is_freeform[edge.face0] || !edges_.is_freeform[edge.face1] || !edges_.may_fade(e)) return false;
    return glm::dot(face_normal(scene_, edge.face0), face_normal(scene_, edge.face1)) > 0;
  }

  bool is_in_large_region(const Edge& edge) {
    const std::size_t number = object_of_vertex(scene_, edge.v0);
    const Object& object = scene_.objects[number];
    if (regions_[number].empty()) regions_[number] = large_regions(object);
    return regions_[number][edge.face0 - object.face_begin] != 0;
  }

  /// Per face of an object: 1 if the object is mostly free forms, or if the face lies in a region of free forms, connected
  /// over edges, that is large for what it borders on. That has the area of a disc as long about as the border, for each
  /// connected part of the border. Open borders of the object are none.
  std::vector<std::uint8_t> large_regions(const Object& object) const {
    const std::uint32_t first = object.face_begin, first_vertex = object.vertex_begin;
    std::vector<double> areas(object.face_end - first);
    double all_free = 0, all = 0;
    for (std::uint32_t f = 0; f < areas.size(); ++f) {
      areas[f] = area_of(first + f);
      all += areas[f];
      if (edges_.is_freeform[first + f]) all_free += areas[f];
    }
    if (all_free >= kFreeformPart * all) return std::vector<std::uint8_t>(areas.size(), 1);
    DisjointSets regions(object.face_end - first), borders(object.vertex_end - first_vertex);
    const auto [begin, end] = edges_of(topology_, object);
    std::vector<std::uint32_t> border_edges;
    for (std::uint32_t e = begin; e < end; ++e) {
      const Edge& edge = topology_.edges[e];
      if (edge.face1 == kNone) continue;
      const bool is_free = edges_.is_freeform[edge.face0];
      if (is_free != static_cast<bool>(edges_.is_freeform[edge.face1])) {
        border_edges.push_back(e);
        borders.join(edge.v0 - first_vertex, edge.v1 - first_vertex);
      } else if (is_free) {
        regions.join(edge.face0 - first, edge.face1 - first);
      }
    }
    std::map<std::array<std::uint32_t, 2>, double> lengths;  // by region and connected part of its border
    for (const std::uint32_t e : border_edges) {
      const Edge& edge = topology_.edges[e];
      const std::uint32_t face = edges_.is_freeform[edge.face0] ? edge.face0 : edge.face1;
      lengths[{regions.find(face - first), borders.find(edge.v0 - first_vertex)}] += length_of(e);
    }
    std::vector<double> free(areas.size(), 0), beside(areas.size(), 0);
    for (std::uint32_t f = 0; f < areas.size(); ++f) {
      if (edges_.is_freeform[first + f]) free[regions.find(f)] += areas[f];
    }
    for (const auto& [key, length] : lengths) beside[key[0]] += length * length / (4 * std::numbers::pi);
    std::vector<std::uint8_t> is_large(free.size());
    for (std::uint32_t f = 0; f < free.size(); ++f) {
      const std::uint32_t region = regions.find(f);
      is_large[f] = free[region] > 0 && free[region] >= kFreeformPart * (free[region] + beside[region]);
    }
    return is_large;
  }

  double area_of(std::uint32_t face) const { return glm::length(double_area(scene_, face)) / 2; }

  double length_of(std::uint32_t e) const {
    return glm::distance(scene_.vertices[topology_.edges[e].v0], scene_.vertices[topology_.edges[e].v1]);
  }

  /// Adds the edges that go of the run from a free end, and the vertex where they stop.
  void fade(std::uint32_t tip, std::vector<std::uint32_t>& faded, std::vector<std::uint32_t>& left) {
    const FreeEnds::Run found = free_.run_from(tip, [&](std::uint32_t e) { return may_fade(e); });
    const std::vector<std::uint32_t>& run = found.edges;
    const auto standing = std::ranges::find_if(run, [&](std::uint32_t e) { return stands_out(edges_.rows, e); });
    double length = 0, turn = 0;
    for (auto e = standing; e != run.end(); ++e) {
      length += length_of(*e);
      turn += length_of(*e) * std::abs(edges_.rows.bend(*e, topology_.edges[*e].face0));
    }
    const double part = turn >= kFirmBend * length ? kFirmRunPart : kLongRunPart;
    const bool stays = length >= part * edges_.sizes[object_of_vertex(scene_, tip)];
    if (run.empty() || (stays && standing == run.begin())) return;
    faded.insert(faded.end(), run.begin(), stays ? standing : run.end());
    if (!stays) left.push_back(found.end);
  }

  const Scene& scene_;
  const Topology& topology_;
  const FadingEdges& edges_;
  std::span<const BendEnd> ends_;
  std::vector<Bend>& bends_;
  FreeEnds free_;
  /// Per object, where they were asked for: whether a face lies in a region of free forms that is large for its borders.
  std::vector<std::vector<std::uint8_t>> regions_;
};

}  // namespace

std::size_t drop_fading_creases(const Scene& scene, const Topology& topology, const FadingEdges& edges,
                                std::vector<Bend>& bends) {
  return Fader(scene, topology, edges, bends).run();
}

}  // namespace ligne
