#include "plotting/gray_image.hpp"

#include <cstddef>
#include <cstdint>
#include <cstring>

#include "plotting/cairo_path.hpp"

namespace ligne {
namespace {

/// An image surface of the size of the picture, its rows not yet set.
CairoSurface image_of(const GrayPicture& picture, cairo_format_t format) {
  CairoSurface surface(
      cairo_image_surface_create(format, static_cast<int>(picture.width), static_cast<int>(picture.height)));
  check_cairo(cairo_surface_status(surface.get()));
  cairo_surface_flush(surface.get());
  return surface;
}

unsigned char* row_of(cairo_surface_t* surface, std::uint32_t y) {
  return cairo_image_surface_get_data(surface) +
         std::size_t{y} * static_cast<std::size_t>(cairo_image_surface_get_stride(surface));
}

}  // namespace

void paint_gray(cairo_t* cairo, const GrayPicture& picture, double units_per_mm) {
  if (picture.gray.empty()) return;
  const CairoSurface surface = image_of(picture, CAIRO_FORMAT_RGB24);
  for (std::uint32_t y = 0; y < picture.height; ++y) {
    unsigned char* const to = row_of(surface.get(), y);
    const std::uint8_t* const from = picture.gray.data() + std::size_t{y} * picture.width;
    for (std::uint32_t x = 0; x < picture.width; ++x) {
      const std::uint32_t pixel = from[x] * 0x010101u;
      std::memcpy(to + 4 * std::size_t{x}, &pixel, sizeof pixel);
    }
  }
  cairo_surface_mark_dirty(surface.get());
  cairo_save(cairo);
  cairo_translate(cairo, picture.corner_mm.x * units_per_mm, picture.corner_mm.y * units_per_mm);
  cairo_scale(cairo, picture.pixel_mm * units_per_mm, picture.pixel_mm * units_per_mm);
  cairo_set_source_surface(cairo, surface.get(), 0, 0);
  cairo_pattern_set_filter(cairo_get_source(cairo), CAIRO_FILTER_NEAREST);
  cairo_rectangle(cairo, 0, 0, picture.width, picture.height);
  cairo_fill(cairo);
  cairo_restore(cairo);
  check_cairo(cairo_status(cairo));
}

std::string gray_png(const GrayPicture& picture) {
  const CairoSurface surface = image_of(picture, CAIRO_FORMAT_A8);  // which Cairo writes as gray
  for (std::uint32_t y = 0; y < picture.height; ++y) {
    std::memcpy(row_of(surface.get(), y), picture.gray.data() + std::size_t{y} * picture.width, picture.width);
  }
  cairo_surface_mark_dirty(surface.get());
  std::string png;
  check_cairo(cairo_surface_write_to_png_stream(surface.get(), append_to_string, &png));
  return png;
}

std::string base64(const std::string& bytes) {
  constexpr char kLetters[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const auto byte = [&](std::size_t k) { return k < bytes.size() ? static_cast<unsigned char>(bytes[k]) : 0u; };
    const std::uint32_t three = byte(i) << 16 | byte(i + 1) << 8 | byte(i + 2);
    text += kLetters[three >> 18];
    text += kLetters[three >> 12 & 63];
    text += i + 1 < bytes.size() ? kLetters[three >> 6 & 63] : '=';
    text += i + 2 < bytes.size() ? kLetters[three & 63] : '=';
  }
  return text;
}

}  // namespace ligne
