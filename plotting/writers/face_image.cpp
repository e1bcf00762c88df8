#include "plotting/writers/face_image.hpp"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string>

#include "plotting/writers/cairo_path.hpp"

namespace ligne {

/// A pixel as Cairo stores it: blue in the lowest byte.
static std::uint32_t pixel_at(const FacePicture& picture, std::size_t i) {
  if (picture.rgb.empty()) return picture.gray[i] * 0x010101u;
  constexpr unsigned kRed = 16, kGreen = 8;
  const std::uint8_t* const rgb = picture.rgb.data() + 3 * i;
  return std::uint32_t{rgb[0]} << kRed | std::uint32_t{rgb[1]} << kGreen | rgb[2];
}

void put_pixels(cairo_surface_t* surface, const FacePicture& picture) {
  cairo_surface_flush(surface);
  unsigned char* const data = cairo_image_surface_get_data(surface);
  if (!data) return;  // the surface has an error, which check_cairo() reports later
  const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(surface));
  for (std::uint32_t y = 0; y < picture.height; ++y) {
    for (std::uint32_t x = 0; x < picture.width; ++x) {
      const std::uint32_t pixel = pixel_at(picture, std::size_t{y} * picture.width + x);
      std::memcpy(data + y * stride + 4 * std::size_t{x}, &pixel, sizeof pixel);
    }
  }
  cairo_surface_mark_dirty(surface);
}

/// Attaches to a surface the PNG of a gray picture that an SVG will contain: Cairo itself would write gray as three
/// colours.
static void attach_png(cairo_surface_t* surface, const FacePicture& picture) {
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

void paint_faces(cairo_t* cairo, const FacePicture& picture, double units_per_mm) {
  if (picture.empty()) return;
  const CairoSurface surface(
      cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(picture.width), static_cast<int>(picture.height)));
  check_cairo(cairo_surface_status(surface.get()));
  put_pixels(surface.get(), picture);
  const bool in_svg = cairo_surface_get_type(cairo_get_target(cairo)) == CAIRO_SURFACE_TYPE_SVG;
  if (in_svg && picture.rgb.empty()) attach_png(surface.get(), picture);
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
