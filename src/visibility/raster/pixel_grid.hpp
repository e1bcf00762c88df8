#pragma once
/// Places of the pixels of a depth buffer on the page.
///
/// Notation: u and v are page coordinates in pixels, rightwards and downwards; the centre of pixel (i, j), column i of row
/// j, is at u = i, v = j.

#include <cmath>
#include <cstdint>
#include <optional>

#include "drawing/result_models.hpp"
#include "geometry/lattice.hpp"
#include "geometry/point.hpp"

namespace ligne::zbuffer {

struct PixelGrid {
  Point2 corner_mm{0, 0};  ///< upper left corner of pixel (0, 0)
  double pixel_mm = 1;
  std::uint32_t width = 1, height = 1;

  /// A grid of `rows` rows if given; else the pixels of the picture with these lines; else `standard` rows over the
  /// window.
  static PixelGrid of(const Rect& window, const std::optional<SpanLines>& lines, std::optional<std::uint32_t> rows,
                      std::uint32_t standard) {
    if (rows || !lines) return over(window, rows.value_or(standard));
    const auto columns = static_cast<std::uint32_t>(std::ceil(std::fmax(window.max.x / lines->spacing_mm, 1)));
    return {{0, lines->first_mm - lines->spacing_mm / 2}, lines->spacing_mm, columns, lines->count};
  }

  /// Covers the window with `rows` rows of square pixels. If that needs more than 16 columns per row, the pixels are
  /// larger and the rows fewer.
  static PixelGrid over(const Rect& window, std::uint32_t rows) {
    constexpr double kMostColumns = 16;  // columns per row
    const double by_height = window.height() / rows, by_width = window.width() / (kMostColumns * rows);
    const auto count = [](double pixels) { return static_cast<std::uint32_t>(std::ceil(std::fmax(pixels, 1))); };
    if (by_height >= by_width) return {window.min, by_height, count(window.width() / by_height), rows};
    return {window.min, by_width, count(window.width() / by_width), count(window.height() / by_width)};
  }
};

/// Converts lattice points to pixels. Equal points give equal places, to the last bit.
struct PixelPlaces {
  double by, u0, v0;

  PixelPlaces(const PixelGrid& grid, const Lattice& lattice)
      : by(lattice.step_mm / grid.pixel_mm),
        u0((lattice.origin_mm.x - grid.corner_mm.x) / grid.pixel_mm - 0.5),
        v0((lattice.origin_mm.y - grid.corner_mm.y) / grid.pixel_mm - 0.5) {}

  double u(LatticePoint p) const { return p.x * by + u0; }
  double v(LatticePoint p) const { return p.y * by + v0; }
};

}  // namespace ligne::zbuffer
