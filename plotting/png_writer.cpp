#include <cmath>
#include <stdexcept>

#include "plotting/cairo_path.hpp"
#include "plotting/cairo_text.hpp"
#include "plotting/writers.hpp"

namespace ligne {
namespace {

constexpr double kMmPerInch = 25.4;

/// Cairo's image surfaces go up to this side; the number of pixels is that of A0 at 600 dpi, 2.2 GB.
constexpr double kLargestSide = 32767;
constexpr double kMostPixels = 560e6;

}  // namespace

std::string write_png(const Drawing& drawing, const PlotOptions& options) {
  const double scale = options.dpi / kMmPerInch;
  const double width = std::max(1.0, std::round(options.page.width_mm * scale));
  const double height = std::max(1.0, std::round(options.page.height_mm * scale));
  if (!(options.dpi > 0)) throw std::runtime_error("PNG: the resolution must be positive");
  if (!(width <= kLargestSide && height <= kLargestSide && width * height <= kMostPixels)) {
    throw std::runtime_error("PNG: the picture is too large at this resolution");
  }
  const CairoSurface surface(
      cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(width), static_cast<int>(height)));
  const CairoContext cairo(cairo_create(surface.get()));
  cairo_set_source_rgb(cairo.get(), 1, 1, 1);
  cairo_paint(cairo.get());
  paint_fills(cairo.get(), drawing.fills, scale);
  for (const Layer& layer : drawing.layers) {
    stroke_polylines(cairo.get(), layer.lines, layer_style(layer.name, options.pen_width_mm, options.hidden_solid), scale);
  }
  cairo_scale(cairo.get(), scale, scale);
  write_texts(cairo.get(), drawing.texts);
  check_cairo(cairo_status(cairo.get()));
  std::string png;
  check_cairo(cairo_surface_write_to_png_stream(surface.get(), append_to_string, &png));
  return png;
}

}  // namespace ligne
