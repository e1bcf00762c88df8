#pragma once
/// An element of the priority list and its extents.

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "base/no_index.hpp"
#include "visibility/order/model_pieces.hpp"

namespace ligne::newell {

/// Extents on the page and in depth: [low, high] along x, y, z.
struct Extents {
  std::array<double, 3> low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};

  void extend(const Extents& o);
  double longest_side() const { return std::max(high[0] - low[0], high[1] - low[1]); }  ///< on the page
  /// True if they overlap along the axis by more than a border.
  bool overlap(const Extents& o, int axis) const { return low[axis] < o.high[axis] && o.low[axis] < high[axis]; }
};

/// A connected part of a face, or a convex body (convex_bodies.hpp). `parts` are convex pieces of triangles.
struct Element {
  std::uint32_t face = 0;            ///< for a body: one of its faces
  std::uint32_t body = kNone;        ///< body number, or kNone
  std::vector<std::uint32_t> parts;  ///< numbers of pieces
  Extents extents;
  ModelPlane plane;                              ///< its normal points to the viewer's side; unset for a body
  std::array<double, 3> page_plane{};            ///< see PagePlanes
  std::size_t corner_begin = 0, corner_end = 0;  ///< range of corners of its parts in the model, see PaintElements
};

}  // namespace ligne::newell
