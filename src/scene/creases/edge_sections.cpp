#include "scene/creases/edge_sections.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>
#include <optional>

#include "base/no_index.hpp"
#include "scene/creases/across_edge.hpp"

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
/// triangles of planes are no reason to take the corners of a pocket for a rounding.
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

}  // namespace

double turn_across(const Scene& scene, const Topology& topology, std::uint32_t edge, double longest) {
  return topology.edges[edge].face1 != kNone ? Section(scene, topology, topology.edges[edge]).turn(longest) : 0;
}

}  // namespace ligne
