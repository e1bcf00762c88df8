#pragma once
/// How a mesh bends across an edge, on both sides.

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

}  // namespace ligne
