#pragma once
/// Pictures of faces in gray or colour, made from spans or pixels ([Boulle1980] 2.3.2.1, figure 2.29). Areas are made by
/// span_areas.hpp, hatching by plotting/hatching/hatch.hpp.

#include <array>
#include <cstddef>
#include <cstdint>

#include "base/parallel.hpp"
#include "drawing/drawing.hpp"
#include "drawing/result_models.hpp"
#include "geometry/point.hpp"

namespace ligne {

/// Brightness (N = 1) or colour (N = 3), components 0 to 1, of a visible face at a point of the page that lies on it. Called
/// by several threads at once.
template <std::size_t N>
using ColorAt = FunctionRef<std::array<double, N>(SeenFace seen, Point2 page_mm)>;

/// Paints spans with one scan line per row of pixels. A pixel gets the colour at the middle of the part of it that a span
/// covers; at the ends of spans, colours are mixed in proportion to the covered width. Pixels without a face are white.
/// `pixels_per_mm` is the resolution in both directions.
template <std::size_t N>
FacePicture paint(const SpanModel& spans, ColorAt<N> at, std::uint32_t width, std::uint32_t height, double pixels_per_mm);

/// Paints pixels of any size: every pixel of the picture gets the mean over the pixels of the model that it covers, each
/// with the colour at its middle.
template <std::size_t N>
FacePicture paint(const PixelModel& pixels, ColorAt<N> at, std::uint32_t width, std::uint32_t height, double pixels_per_mm);

/// Paints each pixel of the model as one pixel of the picture, at its position on the page.
template <std::size_t N>
FacePicture paint_each(const PixelModel& pixels, ColorAt<N> at);

}  // namespace ligne
