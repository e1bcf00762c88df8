#pragma once
/// How far a mesh lies from the smooth surface that it stands for.

#include <cstdint>
#include <vector>

#include "scene/contacts/face_neighbours.hpp"
#include "scene/model/scene.hpp"

namespace ligne {

/// Estimates for some faces of a scene, by the angles at which their neighbours join them. A face of width w (from the edge
/// to its farthest vertex) that bends by the angle t against its neighbour is the chord of an arc whose height is
/// w/2 tan(t/4). Where it is much wider than its neighbour, it is a flat side beside a narrow rounding, whose width counts
/// in place of its own. Edges that bend by more than `smooth_degrees`, and those of one face or of more than two, are no
/// part of a smooth surface.
class ChordErrors {
 public:
  /// `faces`: ascending, with their neighbours.
  ChordErrors(const Scene& scene, const FaceNeighbours& neighbours, std::vector<std::uint32_t> faces, double smooth_degrees);

  /// Model units; 0 for a face that no neighbour joins smoothly. `face` is one of those given.
  double of(std::uint32_t face) const;

 private:
  void add(const Scene& scene, std::uint32_t face, std::uint32_t neighbour, std::uint32_t v0, std::uint32_t v1,
           double smooth_degrees);

  std::vector<std::uint32_t> faces_;
  std::vector<double> errors_;
};

}  // namespace ligne
