#pragma once
/// Estimates the distance of a mesh from the smooth surface that it approximates.

#include <array>
#include <compare>
#include <cstdint>
#include <tuple>
#include <vector>

#include "scene/model/scene.hpp"

namespace ligne {

/// Neighbours of a few faces, found without the topology of the whole scene.
class FaceNeighbours {
 public:
  /// Takes O(corners of the objects that own the faces). `faces`: ascending.
  FaceNeighbours(const Scene& scene, const std::vector<std::uint32_t>& faces);

  /// The neighbour of one of the faces across the edge from v to w; kNone on a border and where more than two faces
  /// meet.
  std::uint32_t across(std::uint32_t face, std::uint32_t v, std::uint32_t w) const;

  /// Calls visit(face, neighbour, v, w) for every edge of two faces, at least one of which was given.
  template <class Visit>
  void for_each_pair(Visit visit) const {
    for (std::size_t begin = 0, end = 0; begin < uses_.size(); begin = end) {
      end = end_of_edge(begin);
      if (end - begin == 2) visit(uses_[begin].face, uses_[begin + 1].face, uses_[begin].v0, uses_[begin].v1);
    }
  }

 private:
  struct EdgeUse {
    std::uint32_t v0, v1, face;
    auto edge() const { return std::tie(v0, v1); }
    friend auto operator<=>(const EdgeUse&, const EdgeUse&) = default;
  };
  std::size_t end_of_edge(std::size_t begin) const {
    std::size_t end = begin + 1;
    while (end < uses_.size() && uses_[end].edge() == uses_[begin].edge()) ++end;
    return end;
  }

  std::vector<EdgeUse> uses_;  ///< the edges between vertices of the faces, sorted by edge
};

/// Estimates for some faces of a scene, from the angles between them and their neighbours. A face of width w (from the
/// edge to its farthest vertex) that forms the angle t with its neighbour is the chord of an arc of height w/2
/// tan(t/4). A face much wider than its neighbour is a flat side beside a narrow fillet, and then the neighbour's
/// width counts. Edges with an angle above `smooth_degrees`, and edges of one face or of more than two, are not part of
/// a smooth surface.
class ChordErrors {
 public:
  /// `faces`: ascending, with their neighbours.
  ChordErrors(const Scene& scene, const FaceNeighbours& neighbours, std::vector<std::uint32_t> faces, double smooth_degrees);

  /// The estimate in model units; 0 for a face that no neighbour joins smoothly. `face` must be one of those given.
  double of(std::uint32_t face) const;
  /// Largest angle to a neighbour of which the face is the next chord, in radians; 0 as above. The normal of the shape
  /// differs from that of the face by up to half of it. `face` must be one of those given.
  double bend(std::uint32_t face) const;

 private:
  void add(const Scene& scene, std::uint32_t face, std::uint32_t neighbour, std::uint32_t v0, std::uint32_t v1,
           double smooth_degrees);

  std::size_t place_of(std::uint32_t face) const;

  std::vector<std::uint32_t> faces_;
  std::vector<double> errors_, bends_;
};

/// Recognises faces that cross in the mesh, but only touch in the shape.

/// Precision of the coordinates of the object that a face belongs to, model units.
double object_precision(const Scene& scene, std::uint32_t face);

/// Whether two faces that cross in a segment are nowhere farther apart than `distance`, where they overlap. Beside the
/// segment the distance of their planes grows with the sine of their angle.
bool within_distance(const Scene& scene, const std::array<std::uint32_t, 2>& faces, const std::array<Point3, 2>& segment,
                     double distance);

}  // namespace ligne
