#pragma once
/// Grey pictures of faces, made from spans or pixels ([Boulle1980] 2.3.2.1, figure 2.29). Grey areas are made by
/// span_areas.hpp, hatching by plotting/hatching/hatch.hpp.

#include <cstdint>
#include <vector>

#include "base/parallel.hpp"
#include "drawing/drawing.hpp"
#include "drawing/result_models.hpp"
#include "geometry/point.hpp"

namespace ligne {

/// A grey picture, stored row by row from the top; 0 is black, 255 white.
struct GrayPicture {
  std::uint32_t width = 0, height = 0;
  std::vector<std::uint8_t> gray;
  Point2 corner_mm{0, 0};  ///< position of its upper left corner on the page
  double pixel_mm = 0;     ///< side of a pixel on the page; 0: the pixels are those of the page
};

/// Paints spans with one scan line per row of pixels. A pixel gets the brightness (0 to 1, per face) of the visible
/// face; at the ends of spans, brightnesses are mixed in proportion to the covered width. Pixels without a face are
/// white. `pixels_per_mm` is the resolution in both directions.
GrayPicture shade(const SpanModel& spans, const std::vector<double>& brightness, std::uint32_t width, std::uint32_t height,
                  double pixels_per_mm);

/// Paints pixels of any size: every pixel of the picture gets the mean over the pixels of the model that it covers.
GrayPicture shade(const PixelModel& pixels, const std::vector<double>& brightness, std::uint32_t width, std::uint32_t height,
                  double pixels_per_mm);

/// Brightness, 0 to 1, of a face at a point of the page that lies on it.
using ToneAt = FunctionRef<double(std::uint32_t face, Point2 page_mm)>;

/// Pictures of continuous tone: each pixel gets the tone at its middle, or at the middle of the part of it that a span
/// covers. `tone` is called by several threads at once.
GrayPicture shade(const SpanModel& spans, ToneAt tone, std::uint32_t width, std::uint32_t height, double pixels_per_mm);
GrayPicture shade(const PixelModel& pixels, ToneAt tone, std::uint32_t width, std::uint32_t height, double pixels_per_mm);
GrayPicture gray_pixels(const PixelModel& pixels, ToneAt tone);

/// Paints each pixel of the model as one pixel of the picture, at its position on the page.
GrayPicture gray_pixels(const PixelModel& pixels, const std::vector<double>& brightness);

}  // namespace ligne
