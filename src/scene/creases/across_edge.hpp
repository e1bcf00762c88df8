#pragma once
/// A face as it lies beside one of its edges.

#include <array>
#include <cstdint>
#include <optional>

#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"

namespace ligne {

/// From an edge to the corner of a face that is farthest from it, at a right angle to the edge.
Point3 across_face(const Scene& scene, const Edge& edge, std::uint32_t f);

/// How wide the two faces of an edge are beside it.
std::array<double, 2> widths_across(const Scene& scene, const Edge& edge);

/// The narrow rounding along which an edge runs: the faces between two that are much wider.
struct Rounding {
  std::array<double, 2> ways{};          ///< from the edge to where the wide faces begin
  std::array<std::uint32_t, 2> sides{};  ///< the wide faces, each beyond that face of the edge

  double width() const { return ways[0] + ways[1]; }
  /// The edge has at least a third of the width on either side.
  bool in_middle() const;
};

/// None, as at the edge of a rod and of an even mesh, when no wide faces lie on both sides. `narrow`: the lesser of the
/// widths_across().
std::optional<Rounding> rounding_at(const Scene& scene, const Topology& topology, const Edge& edge, double narrow);

}  // namespace ligne
