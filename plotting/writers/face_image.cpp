#include "plotting/writers/gray_image.hpp"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string>

#include "plotting/writers/cairo_path.hpp"

namespace ligne {

void put_pixels(cairo_surface_t* surface, const GrayPicture& picture) {
  cairo_surface_flush(surface);
  unsigned char* const data = cairo_image_surface_get_data(surface);
  if (!data) return;  // the surface has an error, which check_cairo() reports later
  const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(surface));
  for (std::uint32_t y = 0; y < picture.height; ++y) {
    const std::uint8_t* const row = picture.gray.data() + std::size_t{y} * picture.width;
    for (std::uint32_t x = 0; x < picture.width; ++x) {
      const std::uint32_t pixel = row[x] * 0x010101u;
      std::memcpy(data + y * stride + 4 * std::size_t{x}, &pixel, sizeof pixel);
    }
  }
  cairo_surface_mark_dirty(surface);
}

/// Attaches to a surface the PNG that the SVG will contain: Cairo itself would write gray as three colours.
static void attach_png(cairo_surface_t* surface, const GrayPicture& picture) {
  const auto width = static_cast<int>(picture.width), height = static_cast<int>(picture.height);
  const CairoSurface gray(cairo_image_surface_create(CAIRO_FORMAT_A8, width, height));  // which Cairo writes as gray
  check_cairo(cairo_surface_status(gray.get()));
  const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(gray.get()));
  for (std::size_t y = 0; y < picture.height; ++y) {
    std::memcpy(cairo_image_surface_get_data(gray.get()) + y * stride, picture.gray.data() + y * picture.width,
                picture.width);
  }
  cairo_surface_mark_dirty(gray.get());
  auto png = std::make_unique<std::string>();
  check_cairo(cairo_surface_write_to_png_stream(gray.get(), append_to_string, png.get()));
  const auto* const bytes = reinterpret_cast<const unsigned char*>(png->data());
  const auto free_png = [](void* string) { delete static_cast<std::string*>(string); };
  check_cairo(cairo_surface_set_mime_data(surface, CAIRO_MIME_TYPE_PNG, bytes, png->size(), free_png, png.get()));
  static_cast<void>(png.release());
}

void paint_gray(cairo_t* cairo, const GrayPicture& picture, double units_per_mm) {
  if (picture.gray.empty()) return;
  const CairoSurface surface(
      cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(picture.width), static_cast<int>(picture.height)));
  check_cairo(cairo_surface_status(surface.get()));
  put_pixels(surface.get(), picture);
  if (cairo_surface_get_type(cairo_get_target(cairo)) == CAIRO_SURFACE_TYPE_SVG) attach_png(surface.get(), picture);
  cairo_save(cairo);
  cairo_translate(cairo, picture.corner_mm.x * units_per_mm, picture.corner_mm.y * units_per_mm);
  cairo_scale(cairo, picture.pixel_mm * units_per_mm, picture.pixel_mm * units_per_mm);
  cairo_set_source_surface(cairo, surface.get(), 0, 0);
  cairo_pattern_set_filter(cairo_get_source(cairo), CAIRO_FILTER_NEAREST);
  cairo_paint(cairo);
  cairo_restore(cairo);
  check_cairo(cairo_status(cairo));
}

}  // namespace ligne
