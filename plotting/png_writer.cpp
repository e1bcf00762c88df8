#include <cmath>
#include <cstring>
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

void put_pixels(cairo_surface_t* surface, const GrayPicture& picture) {
  cairo_surface_flush(surface);
  unsigned char* const data = cairo_image_surface_get_data(surface);
  if (!data) return;  // the surface is in error, which is told later
  const int stride = cairo_image_surface_get_stride(surface);
  for (std::uint32_t y = 0; y < picture.height; ++y) {
    const std::uint8_t* const row = picture.gray.data() + std::size_t{y} * picture.width;
    for (std::uint32_t x = 0; x < picture.width; ++x) {
      const std::uint32_t pixel = row[x] * 0x010101u;
      std::memcpy(data + std::size_t{y} * static_cast<std::size_t>(stride) + 4 * std::size_t{x}, &pixel, sizeof pixel);
    }
  }
  cairo_surface_mark_dirty(surface);
}

}  // namespace

PixelSize png_size(const PlotOptions& options) {
  const double scale = options.dpi / kMmPerInch;
  const double width = std::max(1.0, std::round(options.page.width_mm * scale));
  const double height = std::max(1.0, std::round(options.page.height_mm * scale));
  if (!(options.dpi > 0)) throw std::runtime_error("PNG: the resolution must be positive");
  if (!(width <= kLargestSide && height <= kLargestSide && width * height <= kMostPixels)) {
    throw std::runtime_error("PNG: the picture is too large at this resolution");
  }
  return {static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height)};
}

std::string write_png(const Drawing& drawing, const PlotOptions& options, const GrayPicture* under) {
  const double scale = options.dpi / kMmPerInch;
  const PixelSize size = png_size(options);
  const CairoSurface surface(
      cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(size.width), static_cast<int>(size.height)));
  const CairoContext cairo(cairo_create(surface.get()));
  cairo_set_source_rgb(cairo.get(), 1, 1, 1);
  cairo_paint(cairo.get());
  if (under) put_pixels(surface.get(), *under);
  paint_fills(cairo.get(), drawing.fills, scale);
  for (const Layer& layer : drawing.layers) {
    stroke_polylines(cairo.get(), layer.lines, options.style_of(layer.name), scale);
  }
  cairo_scale(cairo.get(), scale, scale);
  write_texts(cairo.get(), drawing.texts);
  check_cairo(cairo_status(cairo.get()));
  std::string png;
  check_cairo(cairo_surface_write_to_png_stream(surface.get(), append_to_string, &png));
  return png;
}

}  // namespace ligne
