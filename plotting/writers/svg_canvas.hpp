#pragma once
/// Cairo's SVG surface as a page in millimetres, whose content is returned as paths. Private to plotting.

#include <string>

#include <cairo.h>

#include "base/parallel.hpp"
#include "drawing/drawing.hpp"

namespace ligne {

/// Coordinates are written to a tenth of a micrometre.
inline constexpr int kSvgDecimals = 4;
inline constexpr double kSvgUnitsPerMm = 10000;

/// A length as text for an attribute.
std::string svg_number(double value);

/// "#abc" for "#aabbcc".
std::string short_color(const std::string& code);

/// Every call makes a surface of its own, so that threads can share a canvas.
class SvgCanvas {
 public:
  /// `largest_mm` is the largest distance, on either axis, of anything drawn from the corner of the page.
  explicit SvgCanvas(double largest_mm);

  /// Gives `draw` a context and the number of its units to a millimetre, and returns the SVG of all that it paints: one path
  /// for each area, and one for each line of a stroke. `pen_mm` is the width of its strokes.
  std::string paths(FunctionRef<void(cairo_t*, double)> draw, double pen_mm) const;
  std::string image(const FacePicture& picture) const;

  Point2 to_mm(Point2 device) const { return device / device_per_mm_ - Point2{reach_mm_, reach_mm_}; }

 private:
  double size() const { return 2 * reach_mm_ * device_per_mm_; }
  std::string document(FunctionRef<void(cairo_t*, double)> draw, double pen_mm) const;

  /// The surface is a square about the corner of the page: Cairo omits everything outside.
  double reach_mm_;
  /// A power of ten, since Cairo writes matrices as decimal numbers. 1/256 of the finest unit is 4 nm.
  double device_per_mm_ = 1000;
};

}  // namespace ligne
