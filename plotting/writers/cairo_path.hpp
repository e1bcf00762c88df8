#pragma once
/// Draws lines and areas on any surface of Cairo, and owns Cairo's objects. Private to plotting.

#include <cstddef>
#include <memory>
#include <optional>
#include <span>

#include <cairo.h>

#include "drawing/drawing.hpp"
#include "plotting/curves/fit_curves.hpp"
#include "plotting/page.hpp"

namespace ligne {

struct CairoFree {
  void operator()(cairo_t* c) const { cairo_destroy(c); }
  void operator()(cairo_surface_t* s) const { cairo_surface_destroy(s); }
};
using CairoContext = std::unique_ptr<cairo_t, CairoFree>;
using CairoSurface = std::unique_ptr<cairo_surface_t, CairoFree>;

/// Throws std::runtime_error with Cairo's own words if `status` is an error, std::bad_alloc if memory ran out.
void check_cairo(cairo_status_t status);

/// Largest path coordinate in Cairo, device units: it keeps them as 24.8 fixed point, to 1/256 of a unit.
inline constexpr double kCairoLimit = 1 << 23;

/// Largest distance from zero of any coordinate of the points, or of the drawing and its page, in mm.
double largest_coordinate(std::span<const Point2> points);
double largest_coordinate(const Drawing& drawing, const Page& page);

/// How coordinates and curves are written to a path.
struct PathForm {
  double units_per_mm = 1;              ///< device units
  double parts_per_mm = 0;              ///< coordinates are rounded to whole parts; 0: they are not rounded
  std::optional<CurveLimits> curves{};  ///< nothing: polylines
};

/// Strokes the polylines (mm) with that style as one path: Cairo's vector surfaces take time with the square of the number
/// of strokes.
void stroke_polylines(cairo_t* cairo, const Polylines& lines, const LineStyle& style, const PathForm& form);

/// End of the areas from `first` on that are painted as one path: opaque areas of one colour. Between two paths the
/// paper would shine through.
std::size_t end_of_area(const std::vector<Fill>& fills, std::size_t first);

/// Fills the areas in their order. Consecutive areas of one colour become one path, since Cairo's vector surfaces take
/// time with the square of the number of calls. Opaque areas get a rim (fill_rim.hpp).
void paint_fills(cairo_t* cairo, const std::vector<Fill>& fills, double units_per_mm);

/// Appends the bytes that Cairo writes to a std::string.
cairo_status_t append_to_string(void* string, const unsigned char* bytes, unsigned int count);

}  // namespace ligne
