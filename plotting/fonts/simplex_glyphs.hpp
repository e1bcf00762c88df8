#pragma once
/// The data of the single-stroke font: Hershey's simplex letters. Made by make_simplex.py; see LICENCE. Private to plotting.

#include <span>

namespace ligne {

struct SimplexGlyph {
  char32_t code;
  short width;           ///< tenths of a Hershey unit
  short typeface_width;  ///< width in a sans serif typeface, thousandths of the height of its capitals
  /// Polylines "x y x y ...;x y ...": tenths of a Hershey unit from the left edge and the base line, y upwards.
  const char* lines;
};

/// Height of capitals, tenths of a Hershey unit.
inline constexpr double kSimplexCapital = 210;

/// The glyphs by ascending code.
std::span<const SimplexGlyph> simplex_glyphs();

}  // namespace ligne
