#include "plotting/cairo_path.hpp"

#include <algorithm>
#include <cmath>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

namespace ligne {

void check_cairo(cairo_status_t status) {
  if (status != CAIRO_STATUS_SUCCESS) throw std::runtime_error(std::string("cairo: ") + cairo_status_to_string(status));
}

double largest_coordinate(const Drawing& drawing, const Page& page) {
  double largest = std::max(page.width_mm, page.height_mm);
  for (const Layer& layer : drawing.layers) {
    for (const Point2 p : layer.lines.points) largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
  }
  return largest;
}

void add_polylines(cairo_t* cairo, const Polylines& lines, std::size_t first, std::size_t last) {
  for (std::size_t i = first; i < last; ++i) {
    const auto line = lines[i];
    if (line.size() < 2) continue;
    const bool closed = line.size() > 3 && line.front() == line.back();
    cairo_move_to(cairo, line[0].x, line[0].y);
    for (const Point2 p : line.subspan(1, line.size() - (closed ? 2 : 1))) cairo_line_to(cairo, p.x, p.y);
    if (closed) cairo_close_path(cairo);
  }
}

void set_line_style(cairo_t* cairo, const LineStyle& style, double units_per_mm) {
  cairo_set_source_rgb(cairo, style.color[0], style.color[1], style.color[2]);
  cairo_set_line_width(cairo, style.width_mm * units_per_mm);
  cairo_set_line_join(cairo, CAIRO_LINE_JOIN_ROUND);
  cairo_set_line_cap(cairo, style.dashes_mm.empty() ? CAIRO_LINE_CAP_ROUND : CAIRO_LINE_CAP_BUTT);
  std::vector<double> dashes = style.dashes_mm;
  for (double& d : dashes) d *= units_per_mm;
  cairo_set_dash(cairo, dashes.data(), static_cast<int>(dashes.size()), 0);
}

void stroke_polylines(cairo_t* cairo, const Polylines& lines, const LineStyle& style, double units_per_mm) {
  set_line_style(cairo, style, units_per_mm);
  cairo_save(cairo);
  cairo_scale(cairo, units_per_mm, units_per_mm);
  add_polylines(cairo, lines, 0, lines.size());
  cairo_restore(cairo);
  cairo_stroke(cairo);
  check_cairo(cairo_status(cairo));
}

cairo_status_t append_to_string(void* string, const unsigned char* bytes, unsigned int count) try {
  static_cast<std::string*>(string)->append(reinterpret_cast<const char*>(bytes), count);
  return CAIRO_STATUS_SUCCESS;
} catch (const std::bad_alloc&) {
  return CAIRO_STATUS_NO_MEMORY;
}

}  // namespace ligne
