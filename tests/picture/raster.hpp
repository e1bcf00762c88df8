#pragma once
/// The pixels of a PNG.

#include <cairo.h>

#include "support/test.hpp"

namespace ligne::test {

struct Raster {
  int width = 0, height = 0;
  std::vector<std::array<int, 3>> pixels;
  const std::array<int, 3>& at(int x, int y) const {
    return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
  }
};

inline Raster read_raster(const std::filesystem::path& png) {
  cairo_surface_t* const surface = cairo_image_surface_create_from_png(png.c_str());
  if (cairo_surface_status(surface) != CAIRO_STATUS_SUCCESS) throw std::runtime_error("no picture: " + png.string());
  Raster result{cairo_image_surface_get_width(surface), cairo_image_surface_get_height(surface), {}};
  const unsigned char* const data = cairo_image_surface_get_data(surface);
  for (int y = 0; y < result.height; ++y) {
    for (int x = 0; x < result.width; ++x) {
      const unsigned char* const p = data + y * cairo_image_surface_get_stride(surface) + 4 * x;
      result.pixels.push_back({p[2], p[1], p[0]});
    }
  }
  cairo_surface_destroy(surface);
  return result;
}

}  // namespace ligne::test
