/// PDF, through Cairo's PDF surface.
///
/// The PDF surface keeps coordinates as 24.8 fixed point of its unit, the point: steps of 1.4 micrometres. So lines are
/// drawn on a recording surface with a finer unit, which is painted with a scale. Cairo writes it as a form with a
/// content stream in that unit, placed by one matrix. Areas are painted directly on the PDF surface, whose rounding
/// moves them by at most 0.7 micrometres: Cairo 1.16 turns a recording with hundreds of overlapping areas into a
/// bitmap, of another size, and takes a minute. White paper is painted under the areas, since Cairo would otherwise
/// join the extents of each to a region of all before it.

#include <cmath>

#include <cairo-pdf.h>

#include "plotting/writers/cairo_path.hpp"
#include "plotting/writers/writers.hpp"

namespace ligne {
namespace {

constexpr double kPointsPerMm = 72 / kMmPerInch;

/// Most units per point: a power of ten, since Cairo writes matrices as decimal numbers. Cairo 1.16 aborts on recording
/// surfaces that are painted smaller than about 1:500, so the unit is no finer.
constexpr double kMostUnitsPerPoint = 100;

/// Parts of a unit to which coordinates are rounded: 0.44 micrometres. Cairo's own 256ths would only make longer
/// numbers.
constexpr double kPartsOfUnit = 8;

double units_per_point(double largest_mm) {
  double units = kMostUnitsPerPoint;
  while (largest_mm * kPointsPerMm * units > kCairoLimit - 1) units /= 10;
  return units;
}

}  // namespace

struct PdfDocument::Surface {
  Surface(double width, double height)
      : cairo(cairo_pdf_surface_create_for_stream(append_to_string, &bytes, width, height)) {}

  std::string bytes;
  CairoSurface cairo;
};

PdfDocument::PdfDocument() = default;
PdfDocument::~PdfDocument() = default;

void PdfDocument::add_page(const Drawing& drawing, const PlotOptions& options, const FacePicture* under) {
  const double width = options.page.width_mm * kPointsPerMm, height = options.page.height_mm * kPointsPerMm;
  const double units = units_per_point(largest_coordinate(drawing, options.page));

  const cairo_rectangle_t extents{0, 0, std::ceil(width * units), std::ceil(height * units)};
  const CairoSurface recording(cairo_recording_surface_create(CAIRO_CONTENT_COLOR_ALPHA, &extents));
  const CairoContext pen(cairo_create(recording.get()));
  for (const Layer& layer : drawing.layers) {
    stroke_polylines(pen.get(), layer.lines, options.style_of(layer),
                     {units * kPointsPerMm, kPartsOfUnit * units * kPointsPerMm, options.curves_of(layer)});
  }

  if (surface_) {
    cairo_pdf_surface_set_size(surface_->cairo.get(), width, height);
  } else {
    surface_ = std::make_unique<Surface>(width, height);
    // Equal input gives equal bytes: no date.
    cairo_pdf_surface_set_metadata(surface_->cairo.get(), CAIRO_PDF_METADATA_CREATE_DATE, "");
    if (!options.title.empty()) {
      cairo_pdf_surface_set_metadata(surface_->cairo.get(), CAIRO_PDF_METADATA_TITLE, options.title.c_str());
    }
  }
  cairo_surface_t* const surface = surface_->cairo.get();
  if (under || !drawing.fills.empty()) {
    const CairoContext cairo(cairo_create(surface));
    cairo_set_source_rgb(cairo.get(), 1, 1, 1);
    cairo_paint(cairo.get());
    if (under) paint_faces(cairo.get(), *under, kPointsPerMm);
    paint_fills(cairo.get(), drawing.fills, kPointsPerMm);
  }
  if (!drawing.layers.empty()) {
    const CairoContext cairo(cairo_create(surface));
    cairo_scale(cairo.get(), 1 / units, 1 / units);
    cairo_set_source_surface(cairo.get(), recording.get(), 0, 0);
    cairo_paint(cairo.get());
    check_cairo(cairo_status(cairo.get()));
  }
  if (!drawing.texts.empty()) {
    const CairoContext cairo(cairo_create(surface));
    cairo_scale(cairo.get(), kPointsPerMm, kPointsPerMm);
    write_texts(cairo.get(), drawing.texts);
  }
  cairo_surface_show_page(surface);
  check_cairo(cairo_surface_status(surface));
}

std::string PdfDocument::finish() {
  if (!surface_) return {};
  cairo_surface_finish(surface_->cairo.get());
  check_cairo(cairo_surface_status(surface_->cairo.get()));
  return std::move(surface_->bytes);
}

std::string write_pdf(const Drawing& drawing, const PlotOptions& options, const FacePicture* under) {
  PdfDocument document;
  document.add_page(drawing, options, under);
  return document.finish();
}

}  // namespace ligne
