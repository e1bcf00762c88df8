#pragma once
/// How a mesh bends across an edge, on both sides.

#include <cstdint>
#include <glm/geometric.hpp>
#include <optional>
#include <span>
#include <vector>

#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"

namespace ligne {

/// The section across an edge: the curvatures on both sides, of which the side that bends more is the round one.
struct SeamSection {
  bool is_first_flat = false;  ///< the side of Edge::face0 is the flat one
  bool is_convex = false;      ///< the round side bends away from its normals
  double ratio = 0;            ///< curvature of the flat side divided by that of the round one
  double turn = 0;             ///< angle by which the round side turns over its first face, radians
  double depths = 0;           ///< depth of the first face of the flat side, in that of the round one
  /// Root mean square of the distances of the vertices from the quadric, as a fraction of twice the sag of the round side's
  /// first face.
  double error = 0;
};

/// Measures sections by least squares. The height of the vertices over the tangent plane of the edge is a quadric in the
/// distance from the edge and the place along it. Two surfaces that touch along the edge have one normal there, which turns
/// along the edge alike; so all coefficients are common but the curvature across the edge. Vertices lie on the surfaces
/// exactly, so the shapes of the triangles between them do not matter.
class SeamSections {
 public:
  /// `is_inner`: per edge, 1 if faces on both sides may belong to one surface.
  SeamSections(const Scene& scene, const Topology& topology, std::span<const std::uint8_t> is_inner)
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
  std::span<const std::uint8_t> is_inner_;
};

/// Mean distance of the inner vertices of a line of more than four from the cubic through two neighbours on either side, in
/// lengths of the shorter edge beside them.
double roughness(const Scene& scene, std::span<const std::uint32_t> vertices);

}  // namespace ligne
