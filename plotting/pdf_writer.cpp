/// PDF, through Cairo's PDF surface.
///
/// That surface keeps coordinates as 24.8 fixed point of its unit, which is the point: 1.4 micrometres. So the drawing is made
/// on a recording surface of a finer unit, with coordinates that are whole numbers of it, and painted with a scale; Cairo
/// then writes it as a form with a content stream of whole numbers, placed by one matrix.

#include <cairo-pdf.h>

#include "plotting/cairo_path.hpp"
#include "plotting/writers.hpp"

#include <cmath>

namespace ligne {
namespace {

constexpr double kPointsPerMm = 72 / 25.4;

/// Finest unit: a thousandth of a point, 0.35 micrometres. Powers of ten, since Cairo writes matrices as decimal numbers.
constexpr double kFinestUnits = 1000;

double units_per_point(double largest_mm) {
  double units = kFinestUnits;
  while (largest_mm * kPointsPerMm * units > kCairoLimit - 1) units /= 10;
  return units;
}

/// The polylines with coordinates that are whole numbers of device units.
Polylines rounded(const Polylines& lines, double units_per_mm) {
  Polylines result = lines;
  for (Point2& p : result.points) {
    p = {std::round(p.x * units_per_mm) / units_per_mm, std::round(p.y * units_per_mm) / units_per_mm};
  }
  return result;
}

}  // namespace

std::string write_pdf(const Drawing& drawing, const PlotOptions& options) {
  const double width = options.page.width_mm * kPointsPerMm, height = options.page.height_mm * kPointsPerMm;
  const double units = units_per_point(largest_coordinate(drawing, options.page));

  const cairo_rectangle_t extents{0, 0, std::ceil(width * units), std::ceil(height * units)};
  const CairoSurface recording(cairo_recording_surface_create(CAIRO_CONTENT_COLOR_ALPHA, &extents));
  const CairoContext pen(cairo_create(recording.get()));
  for (const Layer& layer : drawing.layers) {
    stroke_polylines(pen.get(), rounded(layer.lines, units * kPointsPerMm),
                     layer_style(layer.name, options.pen_width_mm, options.hidden_solid), units * kPointsPerMm);
  }

  std::string pdf;
  const CairoSurface surface(cairo_pdf_surface_create_for_stream(append_to_string, &pdf, width, height));
  // The same input gives the same bytes: no date.
  cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATE_DATE, "");
  if (!options.title.empty()) {
    cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_TITLE, options.title.c_str());
  }
  if (!drawing.layers.empty()) {
    const CairoContext cairo(cairo_create(surface.get()));
    cairo_scale(cairo.get(), 1 / units, 1 / units);
    cairo_set_source_surface(cairo.get(), recording.get(), 0, 0);
    cairo_paint(cairo.get());
    check_cairo(cairo_status(cairo.get()));
  }
  cairo_surface_show_page(surface.get());
  cairo_surface_finish(surface.get());
  check_cairo(cairo_surface_status(surface.get()));
  return pdf;
}

}  // namespace ligne
