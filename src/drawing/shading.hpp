#pragma once
/// From spans to pictures: gray pixels, and hatching for pens that have one colour (thesis 2.3.2.1, figures 2.29 and 2.30).

#include <cstdint>
#include <vector>

#include "drawing/drawing.hpp"
#include "drawing/result_models.hpp"

namespace ligne {

/// Row by row from the top; 0 black, 255 white.
struct GrayPicture {
  std::uint32_t width = 0, height = 0;
  std::vector<std::uint8_t> gray;
};

/// Paints spans that are one line for each row of pixels: every pixel gets the brightness (0 to 1, by face) of what is seen on it,
/// mixed at the ends of spans by the share that each has; white where nothing is seen. `pixels_per_mm` both ways.
GrayPicture shade(const SpanModel& spans, const std::vector<double>& brightness, std::uint32_t width, std::uint32_t height, double pixels_per_mm);

inline constexpr unsigned kMostHatchLevels = 4;

/// Hatches visible surfaces with strokes along the scan lines, in `levels` (1 to 4) degrees of darkness: the darkest faces on every line, each brighter
/// level on every other line of the one before. With one level all faces are hatched alike. Every other drawn line runs from right to left, so
/// that a pen goes to and fro. Runs of one level on a line that touch are one stroke. Points in page mm.
Polylines hatch(const SpanModel& spans, const std::vector<double>& brightness, unsigned levels);

}  // namespace ligne
