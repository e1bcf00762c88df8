#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "files/message_text.hpp"
#include "plotting/writers/cairo_path.hpp"
#include "plotting/writers/writers.hpp"

namespace ligne {
namespace {

/// Largest side of Cairo's image surfaces, and most pixels: A0 at 600 dpi, 2.2 GB.
constexpr double kLargestSide = 32767;
constexpr double kMostPixels = 560e6;

/// Memory of an edge of an outline while Cairo fills it, bytes: 28 in a polygon that grows by doubling, and up to 100
/// in its scan conversion.
constexpr double kEdgeBytes = 200;
/// Memory that does not grow with the edges, bytes: spans of rows, glyphs of texts.
constexpr double kPaintBytes = 4 << 20;
/// Largest error of Cairo's circles, in pixels.
constexpr double kTolerancePixels = 0.1;

/// Number of edges in the outline of lines drawn with a round pen.
double outline_edges(const Polylines& lines, const LineStyle& style, double pixels_per_mm) {
  const double radius = std::max(style.width_mm * pixels_per_mm / 2, kTolerancePixels);
  const double per_radian = 1 / std::acos(1 - kTolerancePixels / radius);
  double period = 0;
  for (const double length : style.dashes_mm) period += length;
  double edges = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const auto line = lines[i];
    double turns = 2 * std::numbers::pi, length = 0;  // the pen turns round at both ends
    for (std::size_t k = 1; k < line.size(); ++k) {
      const Point2 along = line[k] - line[k - 1];
      length += std::hypot(along.x, along.y);
      if (k < 2) continue;
      const Point2 before = line[k - 1] - line[k - 2];
      turns += std::abs(std::atan2(before.x * along.y - before.y * along.x, before.x * along.x + before.y * along.y));
    }
    edges += turns * per_radian + 4 * static_cast<double>(line.size());
    if (period > 0) edges += 4 * length / period * static_cast<double>(style.dashes_mm.size());
  }
  return edges;
}

/// Throws std::bad_alloc if there is too little memory to paint the drawing: Cairo 1.16 crashes if memory runs out in
/// its scan conversion.
void check_drawable_area(const Drawing& drawing, const PlotOptions& options, double pixels_per_mm) {
  double edges = 0;
  for (const Layer& layer : drawing.layers) {
    edges = std::max(edges, outline_edges(layer.lines, options.style_of(layer), pixels_per_mm));
  }
  // Consecutive fills of one colour are one path. Their narrow rims have edges on both sides, and round each corner.
  constexpr double kCornerEdges = 16;
  double corners = 0;
  for (std::size_t i = 0; i < drawing.fills.size(); ++i) {
    const Fill& fill = drawing.fills[i];
    if (i > 0 && fill.color != drawing.fills[i - 1].color) corners = 0;
    for (const auto& contour : fill.contours) corners += static_cast<double>(contour.size());
    edges = std::max(edges, kCornerEdges * corners);
  }
  // Called by name, so that the compiler does not remove the two as a pair.
  ::operator delete(::operator new(static_cast<std::size_t>(kPaintBytes + kEdgeBytes * edges)));
}

}  // namespace

PixelSize png_size(const PlotOptions& options) {
  const double scale = options.dpi / kMmPerInch;
  const double width = std::max(1.0, std::round(options.page.width_mm * scale));
  const double height = std::max(1.0, std::round(options.page.height_mm * scale));
  if (!(options.dpi > 0)) throw std::runtime_error("PNG: the resolution must be positive");
  if (!(width <= kLargestSide && height <= kLargestSide && width * height <= kMostPixels)) {
    throw std::runtime_error("a PNG of " + shortest(width) + " x " + shortest(height) + " pixels is too large");
  }
  return {static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height)};
}

std::string write_png(const Drawing& drawing, const PlotOptions& options, const FacePicture* under) {
  const double scale = options.dpi / kMmPerInch;
  const PixelSize size = png_size(options);
  const CairoSurface surface(
      cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(size.width), static_cast<int>(size.height)));
  check_cairo(cairo_surface_status(surface.get()));
  check_drawable_area(drawing, options, scale);
  const CairoContext cairo(cairo_create(surface.get()));
  cairo_set_source_rgb(cairo.get(), 1, 1, 1);
  cairo_paint(cairo.get());
  if (under) put_pixels(surface.get(), *under);
  paint_fills(cairo.get(), drawing.fills, scale);
  for (const Layer& layer : drawing.layers) {
    stroke_polylines(cairo.get(), layer.lines, options.style_of(layer), {scale, 0, options.curves_of(layer)});
  }
  cairo_scale(cairo.get(), scale, scale);
  write_texts(cairo.get(), drawing.texts);
  check_cairo(cairo_status(cairo.get()));
  std::string png;
  check_cairo(cairo_surface_write_to_png_stream(surface.get(), append_to_string, &png));
  return png;
}

}  // namespace ligne
