#include "scene/creases/fading_creases.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <map>
#include <numbers>
#include <optional>

#include "base/disjoint_sets.hpp"
#include "base/indices_where.hpp"
#include "base/no_index.hpp"
#include "scene/creases/across_edge.hpp"
#include "scene/creases/loose_creases.hpp"
#include "scene/model/bounds.hpp"
#include "scene/model/faces_and_edges.hpp"

namespace ligne {
namespace {

// Adjustable.
/// Least turn of the surface beside an edge, as a part of that of a circle that bends as at the edge.
constexpr double kLikeTurn = 0.4;
/// How far beyond its face a section is followed, in distances that the bend at the edge stands for.
constexpr double kSectionReach = 2;
/// Largest number of edges that a section passes on one side.
constexpr int kMostCrossed = 12;
/// Largest mean bend of a section, weighted by the bends themselves, radians: a turn of nine facets. Small bends between the
/// triangles of planes are no reason to take the corners of a pocket for a fillet.
constexpr double kMeanBend = 41 * std::numbers::pi / 180;
/// Least sine of the angle between a section and the normal of a face that it passes: others are nearly in its plane.
constexpr double kSteepFace = 0.2;

/// The part of a section on one side of its edge.
struct SectionSide {
  double turn = 0;                ///< radians
  double bends = 0, squares = 0;  ///< sums of the bends of its edges, and of their squares
};

class Section {
 public:
  Section(const Scene& scene, const Topology& topology, const Edge& edge)
      : scene_(scene),
        topology_(topology),
        edge_(edge),
        axis_(glm::normalize(scene.vertices[edge.v1] - scene.vertices[edge.v0])),
        middle_((scene.vertices[edge.v0] + scene.vertices[edge.v1]) * 0.5) {}

  /// The angle of turn_across().
  double turn(double longest) const {
    const std::array faces{edge_.face0, edge_.face1};
    const std::array<double, 2> widths = widths_across(scene_, edge_);
    const double apart = (widths[0] + widths[1]) / 3;  // of the centroids of both faces
    if (std::ranges::max(widths) + kSectionReach * apart > longest) return 0;
    const std::optional<double> bend = turn_over(edge_, faces[0], faces[1]);
    if (!bend) return 0;
    const double sign = *bend < 0 ? -1 : 1;
    double turn = std::abs(*bend);
    double bends = turn, squares = turn * turn;
    for (const std::size_t k : {0, 1}) {
      const SectionSide side = follow(faces[k], widths[k] + kSectionReach * apart);
      const double like = (k == 0 ? -sign : sign) * side.turn;  // the section runs the other way beyond the first face
      if (like < kLikeTurn * kSectionReach * std::abs(*bend)) return 0;
      turn += like;
      bends += side.bends;
      squares += side.squares;
    }
    return squares <= kMeanBend * bends ? turn : 0;
  }

 private:
  /// The direction of the section in a face, away from the edge by which it enters; nothing in a face that is steep to it.
  std::optional<Point3> direction(const Edge& from, std::uint32_t face) const {
    const Point3 normal = face_normal(scene_, face), way = glm::cross(normal, axis_);
    if (glm::length(way) < kSteepFace) return std::nullopt;
    const Point3 along = scene_.vertices[from.v1] - scene_.vertices[from.v0];
    Point3 inward(0);
    for (const std::uint32_t v : scene_.faces.contour(face, 0)) {
      const Point3 p = scene_.vertices[v] - scene_.vertices[from.v0];
      const Point3 across = p - along * (glm::dot(p, along) / glm::dot(along, along));
      if (glm::dot(across, across) > glm::dot(inward, inward)) inward = across;
    }
    return glm::normalize(glm::dot(way, inward) < 0 ? -way : way);
  }

  /// The angle about the axis by which the section turns over an edge, from one face to the other.
  std::optional<double> turn_over(const Edge& over, std::uint32_t from, std::uint32_t to) const {
    const std::optional<Point3> back = direction(over, from), on = direction(over, to);
    if (!back || !on) return std::nullopt;
    return std::atan2(glm::dot(glm::cross(-*back, *on), axis_), glm::dot(-*back, *on));
  }

  /// Follows the section from the edge over a face and the next ones.
  SectionSide follow(std::uint32_t face, double reach) const {
    SectionSide side;
    const Edge* at = &edge_;
    double length = 0;
    Point3 place = middle_;
    for (int k = 0; k < kMostCrossed; ++k) {
      at = exit_of(*at, face, place);
      if (!at || at->face1 == kNone) break;
      if (topology_.edge_flags[static_cast<std::size_t>(at - topology_.edges.data())] & (kEdgeManyFaces | kEdgeUnlikeWound))
        break;
      const Point3 there = crossing(*at);
      length += glm::distance(place, there);
      if (length > reach) break;
      const std::uint32_t beyond = at->face0 == face ? at->face1 : at->face0;
      const std::optional<double> angle = turn_over(*at, face, beyond);
      if (!angle) break;
      side.turn += *angle;
      side.bends += std::abs(*angle);
      side.squares += *angle * *angle;
      place = there, face = beyond;
    }
    return side;
  }

  double height(std::uint32_t v) const { return glm::dot(scene_.vertices[v] - middle_, axis_); }

  Point3 crossing(const Edge& edge) const {
    const double a = height(edge.v0), b = height(edge.v1);
    return scene_.vertices[edge.v0] + (scene_.vertices[edge.v1] - scene_.vertices[edge.v0]) * (a / (a - b));
  }

  /// The edge by which the section leaves a face, the nearest one to where it came in.
  const Edge* exit_of(const Edge& from, std::uint32_t face, const Point3& place) const {
    const auto contour = scene_.faces.contour(face, 0);
    const Edge* best = nullptr;
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < contour.size(); ++k) {
      const std::uint32_t a = contour[k], b = contour[k + 1 == contour.size() ? 0 : k + 1];
      if ((height(a) < 0) == (height(b) < 0)) continue;
      if (std::min(a, b) == from.v0 && std::max(a, b) == from.v1) continue;
      const Edge* edge = find_edge(topology_, {a, b});
      if (!edge) continue;
      const double distance = glm::distance(crossing(*edge), place);
      if (distance < nearest) best = edge, nearest = distance;
    }
    return best;
  }

  const Scene& scene_;
  const Topology& topology_;
  const Edge& edge_;
  Point3 axis_, middle_;
};

/// The angle, in radians, by which the surface turns across an edge of two faces and on both sides of it, if it bends on
/// alike there; otherwise 0. It bends on alike where in the plane across the middle of the edge, within twice the distance
/// that the bend at the edge stands for, it turns to the same side by two fifths of what a circle does that bends as at the
/// edge, and its mean bend, weighted by the bends, is that of a turn of nine facets or less. Coarse hulls bend on
/// everywhere: nothing is followed farther than `longest`, model units.
double turn_across(const Scene& scene, const Topology& topology, std::uint32_t edge, double longest) {
  return topology.edges[edge].face1 != kNone ? Section(scene, topology, topology.edges[edge]).turn(longest) : 0;
}

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
/// Adjustable, radians: least turn across an edge of a tube. Fillets of machine parts turn by less.
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
    dropped +=
        drop_from_free_ends(free_, bends_, [&](std::uint32_t tip, auto& faded, auto& left) { fade(tip, faded, left); });
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

  /// Takes back edges inside no rows of parallel ones at which the surface bends on alike. Narrow fillets between planes
  /// do so, too, and are edges of their part: they stay outside large regions, where tubes go.
  std::size_t drop_inside_sections() {
    std::vector<std::uint8_t> is_tube(ends_.size(), 0);  // per end: 1 if its edge turns as that of a tube
    const auto turns = [&](std::size_t k) {
      const auto [vertex, e] = ends_[k];
      if (topology_.edges[e].v0 != vertex || !free_.is_crease(e) || !is_between_freeforms(e)) return false;
      if (is_inside_fillet(edges_.rows, e)) return false;
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

  double length_of(std::uint32_t e) const { return edge_length(scene_, topology_.edges[e]); }

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
