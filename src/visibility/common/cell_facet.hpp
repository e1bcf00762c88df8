#pragma once
/// Squares of the screen grid, and the entries of their lists of facets.

#include <cstdint>

namespace ligne {

/// A rectangle inside a cell in 128ths of the cell's side, rounded outwards: four seven-bit numbers in one word, so that
/// two boxes are compared by one subtraction.
class CellBox {
 public:
  CellBox() = default;
  CellBox(std::uint32_t left, std::uint32_t right, std::uint32_t top, std::uint32_t bottom)
      : bits_(left | (127 - right) << 8 | top << 16 | (127 - bottom) << 24) {}

  /// Byte by byte: left <= right', 127 - right <= 127 - left', top <= bottom', 127 - bottom <= 127 - top'. Where that holds
  /// the high bit set beforehand survives the subtraction.
  bool meets(CellBox o) const {
    constexpr std::uint32_t kHigh = 0x80808080u, kLow = 0x7f7f7f7fu;
    const std::uint32_t complement = kLow - o.bits_;  // 127 - left', right', 127 - top', bottom'
    const std::uint32_t swapped = (complement & 0xff00ff00u) >> 8 | (complement & 0x00ff00ffu) << 8;
    return (((swapped | kHigh) - bits_) & kHigh) == kHigh;
  }

 private:
  std::uint32_t bits_ = 0;  ///< the whole cell
};

/// Square part of the page lattice.
struct CellSquare {
  double x = 0, y = 0, size = 0;

  /// The box of the rectangle [x0, x1] x [y0, y1] as far as it lies in the square. Rounding is monotone: boxes of
  /// rectangles that meet in the square meet.
  CellBox box(double x0, double x1, double y0, double y1) const {
    const double parts = 128 / size;
    const auto part = [](double v) { return static_cast<std::uint32_t>(v <= 0 ? 0 : v >= 127 ? 127 : v); };
    return {part((x0 - x) * parts), part((x1 - x) * parts), part((y0 - y) * parts), part((y1 - y) * parts)};
  }
};

struct CellFacet {
  std::uint32_t facet = 0;
  float z_near = 0;  ///< nearest depth in the cell
  CellBox box{};     ///< box of its projection
};

}  // namespace ligne
