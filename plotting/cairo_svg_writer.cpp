/// SVG, through Cairo's own SVG surface.
///
/// That surface keeps coordinates as 24.8 fixed point of its unit and knows no unit finer than a millimetre by thousands. So
/// the drawing is made in a fine unit, and of the text that Cairo has written the size of the page is put right: its width
/// and height are mm, its viewBox stays in that unit. The number in the name of the picture's group counts the surfaces of
/// the process; it is taken away, so that the same drawing gives the same bytes.
///
/// Cairo 1.16 takes time with the square of the number of stroke and fill calls, unless a first one covers the page: then
/// the extents of all others lie inside the region known. So the page is painted white first, and a layer is one path.

#include <cmath>
#include <cstring>
#include <stdexcept>

#include <cairo-svg.h>

#include "plotting/cairo_path.hpp"
#include "plotting/cairo_text.hpp"
#include "plotting/gray_image.hpp"
#include "plotting/number_text.hpp"
#include "plotting/writers.hpp"
#include "plotting/xml_text.hpp"

namespace ligne {
namespace {

/// Units to a millimetre: a power of ten, since people read the file. 1/256 of the finest is 4 nm.
constexpr double kMostUnitsPerMm = 1000;

double units_per_mm(double largest_mm) {
  double units = kMostUnitsPerMm;
  while (largest_mm * units > kCairoLimit - 1) units /= 10;
  return units;
}

std::string length(double value) {
  constexpr int kDecimals = 6;
  std::string text;
  append_rounded(text, value, kDecimals);
  return text;
}

/// Puts `text` behind the first `begin`, in the place of what stands there up to the next quotation mark. Returns whether
/// there is such a place.
bool replace_behind(std::string& svg, const char* begin, const std::string& text) {
  const std::size_t from = svg.find(begin);
  const std::size_t to = from == std::string::npos ? from : svg.find('"', from + std::strlen(begin));
  if (to == std::string::npos) return false;
  svg.replace(from + std::strlen(begin), to - from - std::strlen(begin), text);
  return true;
}

}  // namespace

std::string write_cairo_svg(const Drawing& drawing, const PlotOptions& options, const GrayPicture* under) {
  const double units = units_per_mm(largest_coordinate(drawing, options.page));
  const double width = options.page.width_mm, height = options.page.height_mm;
  std::string svg;
  {
    const CairoSurface surface(cairo_svg_surface_create_for_stream(append_to_string, &svg, width * units, height * units));
    check_cairo(cairo_surface_status(surface.get()));
    const CairoContext cairo(cairo_create(surface.get()));
    cairo_set_source_rgb(cairo.get(), 1, 1, 1);
    cairo_paint(cairo.get());
    if (under) paint_gray(cairo.get(), *under, units);
    paint_fills(cairo.get(), drawing.fills, units);
    for (const Layer& layer : drawing.layers) {
      stroke_polylines(cairo.get(), layer.lines, options.style_of(layer), {units, 0, options.curves_of(layer)});
    }
    cairo_scale(cairo.get(), units, units);
    write_texts(cairo.get(), drawing.texts);
    check_cairo(cairo_status(cairo.get()));
    cairo_surface_finish(surface.get());
    check_cairo(cairo_surface_status(surface.get()));
  }
  const bool sized = replace_behind(svg, " width=\"", length(width) + "mm") &&
                     replace_behind(svg, " height=\"", length(height) + "mm") &&
                     replace_behind(svg, " viewBox=\"", "0 0 " + length(width * units) + " " + length(height * units));
  if (!sized) throw std::runtime_error("cairo: an SVG of another form than expected");
  replace_behind(svg, "<g id=\"surface", "");
  if (!options.title.empty()) {
    const std::size_t inside = svg.find('>', svg.find("<svg")) + 1;
    svg.insert(inside, "\n<title>" + xml_text(options.title) + "</title>");
  }
  return svg;
}

}  // namespace ligne
