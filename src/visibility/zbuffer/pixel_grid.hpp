#pragma once
/// Where the pixels of a depth buffer lie on the page.
///
/// Notation: u and v are page coordinates in pixels, rightwards and downwards; the centre of pixel (i, j), column i of row
/// j, is at u = i, v = j.

#include <cmath>
#include <cstdint>

#include "geometry/lattice.hpp"
#include "geometry/point.hpp"

namespace ligne::zbuffer {

struct PixelGrid {
  Point2 corner_mm{0, 0};  ///< upper left corner of pixel (0, 0)
  double pixel_mm = 1;
  std::uint32_t width = 1, height = 1;

  /// So many rows of square pixels over a part of the page.
  static PixelGrid over(const Rect& window, std::uint32_t rows) {
    const double size = window.height() / rows;
    return {window.min, size, static_cast<std::uint32_t>(std::ceil(std::fmax(window.width() / size, 1))), rows};
  }
};

/// From lattice points to pixels. The same point gives the same place to the last bit.
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
