#pragma once
/// An element of the priority list, with its extents.

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
  /// Whether they have more than a border in common along the axis.
  bool overlap(const Extents& o, int axis) const { return low[axis] < o.high[axis] && o.low[axis] < high[axis]; }
};

/// A connected part of a face, or a convex body (body_elements.hpp). Its parts are convex pieces of the triangles.
struct Element {
  std::uint32_t face = 0;            ///< of a body: one of its faces
  std::vector<std::uint32_t> parts;  ///< numbers of pieces
  Extents extents;
  ModelPlane plane;                              ///< its normal points to the viewer's side; a body has none
  std::array<double, 3> page_plane{};            ///< see PagePlanes
  std::size_t corner_begin = 0, corner_end = 0;  ///< of its parts in the model, see PaintElements
  std::uint32_t body = kNone;                    ///< number of the body, or kNone
};

}  // namespace ligne::newell
