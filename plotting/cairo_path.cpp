#include "plotting/cairo_path.hpp"

#include <algorithm>
#include <cmath>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

namespace ligne {

void check_cairo(cairo_status_t status) {
  if (status == CAIRO_STATUS_NO_MEMORY) throw std::bad_alloc();
  if (status != CAIRO_STATUS_SUCCESS) throw std::runtime_error(std::string("cairo: ") + cairo_status_to_string(status));
}

double largest_coordinate(const Drawing& drawing, const Page& page) {
  double largest = std::max(page.width_mm, page.height_mm);
  for (const Layer& layer : drawing.layers) {
    for (const Point2 p : layer.lines.points) largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
  }
  for (const Fill& fill : drawing.fills) {
    for (const auto& contour : fill.contours) {
      for (const Point2 p : contour) largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
    }
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

void paint_fills(cairo_t* cairo, const std::vector<Fill>& fills, double units_per_mm) {
  cairo_set_fill_rule(cairo, CAIRO_FILL_RULE_EVEN_ODD);
  cairo_set_line_width(cairo, kFillRimMm * units_per_mm);
  cairo_set_line_join(cairo, CAIRO_LINE_JOIN_ROUND);
  cairo_set_dash(cairo, nullptr, 0, 0);
  for (std::size_t i = 0; i < fills.size();) {
    const Fill& first = fills[i];
    cairo_set_source_rgba(cairo, first.color[0], first.color[1], first.color[2], first.opacity);
    for (; i < fills.size() && fills[i].color == first.color && fills[i].opacity == first.opacity; ++i) {
      for (const std::vector<Point2>& contour : fills[i].contours) {
        cairo_new_sub_path(cairo);
        for (const Point2& p : contour) cairo_line_to(cairo, p.x * units_per_mm, p.y * units_per_mm);
        cairo_close_path(cairo);
      }
      // Transparent areas one by one: two that lie on each other would be an even number.
      if (first.opacity < 1) {
        ++i;
        break;
      }
    }
    if (first.opacity < 1) {
      cairo_fill(cairo);
    } else {
      cairo_fill_preserve(cairo);
      cairo_stroke(cairo);
    }
  }
  check_cairo(cairo_status(cairo));
}

cairo_status_t append_to_string(void* string, const unsigned char* bytes, unsigned int count) try {
  static_cast<std::string*>(string)->append(reinterpret_cast<const char*>(bytes), count);
  return CAIRO_STATUS_SUCCESS;
} catch (const std::bad_alloc&) {
  return CAIRO_STATUS_NO_MEMORY;
}

}  // namespace ligne
