#pragma once
/// Draws lines and areas on any surface of Cairo, and owns Cairo's objects. Private to plotting.

#include <cstddef>
#include <memory>
#include <optional>
#include <span>

#include <cairo.h>

#include "drawing/drawing.hpp"
#include "drawing/text_item.hpp"
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
/// time with the square of the number of calls. Opaque areas get a rim (kFillRimMm).
void paint_fills(cairo_t* cairo, const std::vector<Fill>& fills, double units_per_mm);

/// Appends the bytes that Cairo writes to a std::string.
cairo_status_t append_to_string(void* string, const unsigned char* bytes, unsigned int count);

/// Copies the pixels of the picture to an image surface of four bytes a pixel, which must be at least as large.
void put_pixels(cairo_surface_t* surface, const FacePicture& picture);

/// Paints the picture where it lies on the page. Its pixels stay sharp.
void paint_faces(cairo_t* cairo, const FacePicture& picture, double units_per_mm);

/// The typeface of texts, and the first of the list that an SVG names. Cairo takes the nearest that the machine has.
inline constexpr const char* kTypeface = "DejaVu Sans";
/// Height of its capitals, as a fraction of the font size.
inline constexpr double kCapitalsOfSize = 1493.0 / 2048;

/// Writes the texts; the context's user space is page mm.
void write_texts(cairo_t* cairo, std::span<const TextItem> texts);

}  // namespace ligne
