#pragma once
/// Triangulation of loops by cutting ears.

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/point.hpp"
#include "geometry/polygons/contour_links.hpp"

namespace ligne {

struct CutEars {
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< of positions, counter-clockwise
  bool whole = true;                                    ///< as in triangulate()
};

/// Triangulates loops, even if they cross or wind around points several times. Holes are joined to the outer loops by
/// bridges, then ears are cut (Meisters 1975; bridges after Eberly 2002). The work is bounded: a part of large loops
/// that cross may stay uncut, and `whole` is then false.
CutEars cut_ears(const std::vector<Point2>& positions, const LinkedContours& links);

}  // namespace ligne
