#pragma once
/// Estimates the distance of a mesh from the smooth surface that it approximates.

#include <cstdint>
#include <vector>

#include "scene/contacts/face_neighbours.hpp"
#include "scene/model/scene.hpp"

namespace ligne {

/// Estimates for some faces of a scene, from the angles between them and their neighbours. A face of width w (from the
/// edge to its farthest vertex) that forms the angle t with its neighbour is the chord of an arc of height w/2
/// tan(t/4). A face much wider than its neighbour is a flat side beside a narrow rounding, and then the neighbour's
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

}  // namespace ligne
