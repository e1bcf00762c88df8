#include "picture/comparison.hpp"

#include <cstdio>
#include <memory>
#include <stdexcept>

#include <cairo.h>

namespace ligne::test {
namespace {

/// Two pixels are near when their centres are no farther apart than 1.5 pixels, 0.375 mm: the pixel itself and its eight
/// neighbours. Half the pen is 0.7 pixels, and a jump is told within one.
constexpr int kNear = 1;

std::size_t index(int x, int y) { return static_cast<std::size_t>(y) * kWidth + static_cast<std::size_t>(x); }

std::vector<std::uint8_t> grown(const std::vector<std::uint8_t>& mask) {
  std::vector<std::uint8_t> result(mask.size(), 0);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      if (!mask[index(x, y)]) continue;
      for (int v = std::max(0, y - kNear); v <= std::min(kHeight - 1, y + kNear); ++v) {
        for (int u = std::max(0, x - kNear); u <= std::min(kWidth - 1, x + kNear); ++u) result[index(u, v)] = 1;
      }
    }
  }
  return result;
}

}  // namespace

Ink read_ink(const std::filesystem::path& png) {
  const std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> surface(
      cairo_image_surface_create_from_png(png.c_str()), cairo_surface_destroy);
  if (cairo_surface_status(surface.get()) != CAIRO_STATUS_SUCCESS) throw std::runtime_error(png.string() + ": no PNG");
  if (cairo_image_surface_get_width(surface.get()) != kWidth || cairo_image_surface_get_height(surface.get()) != kHeight) {
    throw std::runtime_error(png.string() + ": not of the size that was asked for");
  }
  constexpr unsigned char kHalf = 128;
  Ink ink(static_cast<std::size_t>(kWidth) * kHeight, 0);
  const unsigned char* const data = cairo_image_surface_get_data(surface.get());
  const int stride = cairo_image_surface_get_stride(surface.get());
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) ink[index(x, y)] = data[y * stride + 4 * x + 1] < kHalf;
  }
  return ink;
}

std::string Disagreement::words() const {
  char buffer[256];
  const double mm = 1.0 / kPixelsPerMm;
  std::snprintf(
      buffer, sizeof buffer,
      "%zu of %zu dark pixels lie at no line, the first at page mm (%.2f, %.2f); of %zu jumps %zu have no line, the first at (%.2f, %.2f)",
      stray, ink, first_stray.x * mm, first_stray.y * mm, jumps, missing, first_missing.x * mm, first_missing.y * mm);
  return buffer;
}

Disagreement compare(const Ink& ink, const ZBuffer& picture) {
  Disagreement result;
  const std::vector<std::uint8_t> lines = grown(picture.lines_allowed()), inked = grown(ink);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      if (ink[index(x, y)]) {
        ++result.ink;
        if (!lines[index(x, y)] && result.stray++ == 0) result.first_stray = {x, y};
      }
      for (const Pixel next : {Pixel{x + 1, y}, Pixel{x, y + 1}}) {
        if (next.x >= kWidth || next.y >= kHeight || !picture.is_strong_jump({x, y}, next)) continue;
        ++result.jumps;
        if (inked[index(x, y)] || inked[index(next.x, next.y)]) continue;
        if (result.missing++ == 0) result.first_missing = {x, y};
      }
    }
  }
  return result;
}

}  // namespace ligne::test
