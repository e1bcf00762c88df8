#pragma once
/// Measures faces across their edges.

#include <array>
#include <cstdint>
#include <optional>

#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"

namespace ligne {

/// The vector from an edge to the farthest corner of a face, perpendicular to the edge.
Point3 across_face(const Scene& scene, const Edge& edge, std::uint32_t f);

/// Widths of the two faces of an edge, measured across the edge.
std::array<double, 2> widths_across(const Scene& scene, const Edge& edge);

/// The narrow fillet along which an edge runs: the faces between two much wider ones.
struct Fillet {
  std::array<double, 2> ways{};          ///< distances from the edge to the wide faces
  std::array<std::uint32_t, 2> sides{};  ///< the wide faces, each on the side of that face of the edge

  double width() const { return ways[0] + ways[1]; }
  /// Whether at least a third of the width lies on either side of the edge.
  bool in_middle() const;
};

/// The fillet at an edge; nothing if no wide faces lie on both sides, as on a rod and in an even mesh. `narrow`: the
/// smaller of widths_across().
std::optional<Fillet> fillet_at(const Scene& scene, const Topology& topology, const Edge& edge, double narrow);

}  // namespace ligne
