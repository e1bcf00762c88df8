#pragma once
/// How a mesh bends across an edge, and along a line of edges, on both sides.

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/geometric.hpp>
#include <optional>
#include <span>
#include <vector>

#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"

namespace ligne {

/// The section across an edge: on the side of Edge::face0, and on that of Edge::face1.
struct SeamSection {
  std::array<double, 2> curvatures{};  ///< negative where the side bends away from its normals
  std::array<double, 2> depths{};      ///< of the first faces, model units
  double error = 0;                    ///< root mean square of the distances of the vertices from the quadric, model units

  /// Angle by which a side turns over its first face, radians.
  double turn(std::size_t side) const { return std::abs(curvatures[side]) * depths[side]; }
  /// The side that bends more.
  std::size_t round_side() const { return std::abs(curvatures[0]) > std::abs(curvatures[1]) ? 0 : 1; }
};

/// Measures sections by least squares. The height of the vertices over the tangent plane of the edge is a quadric in the
/// distance from the edge and the place along it. Two surfaces that touch along the edge have one normal there, which turns
/// along the edge alike; so all coefficients are common but the curvature across the edge. Vertices lie on the surfaces
/// exactly, so the shapes of the triangles between them do not matter.
class SeamSections {
 public:
  /// `is_inner`: per edge, 1 if faces on both sides may belong to one surface. It is kept by the caller.
  SeamSections(const Scene& scene, const Topology& topology, const std::vector<std::uint8_t>& is_inner)
      : scene_(scene), topology_(topology), is_inner_(is_inner) {}

  /// Nothing where the faces near the edge do not determine the quadric.
  std::optional<SeamSection> at(std::uint32_t e) const;

 private:
  /// A coordinate frame at the middle of an edge.
  struct Frame {
    Point3 at, along, across, normal;
    double length = 0;

    Point3 place(const Point3& p) const {  ///< distance from the edge, place along it, and height
      const Point3 way = p - at;
      return {glm::dot(way, across), glm::dot(way, along), glm::dot(way, normal)};
    }
  };

  std::optional<Frame> frame_at(const Edge& edge) const;
  double depth(std::uint32_t face, const Frame& frame) const;
  void add_places(std::uint32_t e, std::uint32_t face, double depth, const Frame& frame, std::vector<Point3>& places) const;

  const Scene& scene_;
  const Topology& topology_;
  const std::vector<std::uint8_t>& is_inner_;
};

/// Mean distance of the inner vertices of a line of more than four from the cubic through two neighbours on either side, in
/// lengths of the shorter edge beside them.
double roughness(const Scene& scene, std::span<const std::uint32_t> vertices);

/// An edge of a line. The first side of its section lies to the left of the way along the line.
struct LineSection {
  double length = 0;
  std::optional<SeamSection> section{};  ///< nothing where the faces near the edge do not determine it
};

/// The bend along a line. Of its sides, that of the smaller median curvature is the flat one, and the other the round one.
struct LineBend {
  std::size_t edges = 0;
  double length = 0;
  double measured = 0;  ///< part of the length that has sections
  /// Part of the measured length where the flat side bends less than half as much as the round one, and that bends to its
  /// usual side: where a tube begins to bend, it is round on one side of the tube and hollow on the other.
  double agreeing = 0;
  double ratio = 0;   ///< median curvature of the flat side, divided by that of the round one
  double turn = 0;    ///< median angle by which the round side turns over its first face, radians
  double depth = 0;   ///< median depth of the faces of the round side, model units
  double depths = 0;  ///< median depth of the faces of the flat side, in those of the round one
  double error = 0;   ///< median error of the sections, as a fraction of twice the sag of the faces of the round side

  /// Whether the curvature jumps from one side to the other. One section may be wrong where faces are irregular; the medians
  /// of a line are not.
  bool may_be_seam() const;
  /// Whether one side is nearly flat and the other one clearly round.
  bool is_clear() const;
  /// Whether both sides bend alike, or hardly at all.
  bool is_even() const;
  /// Whether the sections of nearly the whole line agree.
  bool is_whole() const;
};

LineBend bend_along(std::span<const LineSection> sections);

}  // namespace ligne
