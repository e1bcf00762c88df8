#pragma once
/// From spans and pixels to pictures: gray pixels ([Boulle1980] 2.3.2.1, figure 2.29). Areas are in span_areas.hpp, hatching
/// in plotting/hatching/hatch.hpp.

#include <cstdint>
#include <vector>

#include "drawing/drawing.hpp"
#include "drawing/result_models.hpp"
#include "geometry/point.hpp"

namespace ligne {

/// Row by row from the top; 0 black, 255 white.
struct GrayPicture {
  std::uint32_t width = 0, height = 0;
  std::vector<std::uint8_t> gray;
  Point2 corner_mm{0, 0};  ///< where its upper left corner lies on the page, and
  double pixel_mm = 0;     ///< how large its pixels are there; 0: they are those of the page
};

/// Paints spans that are one line for each row of pixels: every pixel gets the brightness (0 to 1, by face) of what is seen
/// on it, mixed at the ends of spans by the share that each has; white where nothing is seen. `pixels_per_mm` both ways.
GrayPicture shade(const SpanModel& spans, const std::vector<double>& brightness, std::uint32_t width, std::uint32_t height,
                  double pixels_per_mm);

/// Shades a model of pixels of any size: every pixel of the picture gets the mean over the pixels that it covers.
GrayPicture shade(const PixelModel& pixels, const std::vector<double>& brightness, std::uint32_t width, std::uint32_t height,
                  double pixels_per_mm);

/// The pixels as they are, where they lie on the page.
GrayPicture gray_pixels(const PixelModel& pixels, const std::vector<double>& brightness);

}  // namespace ligne
