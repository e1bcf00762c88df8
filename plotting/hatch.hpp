#pragma once
/// Regions filled with strokes.

#include <span>
#include <vector>

#include "drawing/drawing.hpp"

namespace ligne {

struct HatchOptions {
  double spacing_mm = 1;      ///< between the middles of neighbouring strokes
  double angle_degrees = 45;  ///< of the strokes, counter-clockwise as seen
  double pen_width_mm = 0.35; ///< strokes and their round ends stay inside the region: half of this is kept free at the borders
  bool cross = false;         ///< a second family at right angles
  Point2 origin{0, 0};        ///< a stroke would run through this point: regions with one origin have hatches that continue each other
};

/// Fills a region, its outer contour and its holes in any order (even-odd), with parallel strokes in boustrophedon order: neighbouring rows run opposite ways, and
/// the end of a row is tied to the beginning of the next one where the way between them lies inside the region, so that the pen hardly lifts. Page mm. A region that is narrower
/// than the pen gets nothing. Throws std::invalid_argument for a spacing or a pen width that is not above zero, and for more than `kMostHatchRows` rows.
Polylines hatch(std::span<const std::vector<Point2>> contours, const HatchOptions& options);

inline constexpr double kMostHatchRows = 1e6;

}  // namespace ligne
