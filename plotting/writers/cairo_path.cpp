#include "plotting/writers/cairo_path.hpp"
#include "plotting/hatching/fill_rim.hpp"

#include <algorithm>
#include <cmath>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/parallel.hpp"

namespace ligne {
namespace {

/// Largest distance of Cairo's Bezier curves from the arcs they replace, as a fraction of the tolerance that found the
/// arcs.
constexpr double kBezierPart = 0.1;

Point2 in_parts(Point2 p, double parts_per_mm) {
  return parts_per_mm > 0
             ? Point2{std::round(p.x * parts_per_mm) / parts_per_mm, std::round(p.y * parts_per_mm) / parts_per_mm}
             : p;
}

void add_curves(cairo_t* cairo, const Polylines& lines, const PathForm& form) {
  std::vector<CurvedPath> paths(lines.size());
  parallel_for(lines.size(), [&](std::size_t i) { paths[i] = fit_curves(lines[i], *form.curves); });
  const auto at = [&](Point2 p) { return in_parts(p, form.parts_per_mm); };
  for (const CurvedPath& path : paths) {
    if (path.pieces.empty()) continue;
    const Point2 start = at(path.start);
    cairo_move_to(cairo, start.x, start.y);
    for (std::size_t i = 0; i < path.pieces.size(); ++i) {
      const PathPiece& piece = path.pieces[i];
      if (piece.arc) {
        std::vector<Point2> points = bezier_points(*piece.arc, kBezierPart * form.curves->tolerance_mm);
        points.back() = piece.to;
        for (std::size_t k = 0; k + 2 < points.size(); k += 3) {
          const Point2 a = at(points[k]), b = at(points[k + 1]), c = at(points[k + 2]);
          cairo_curve_to(cairo, a.x, a.y, b.x, b.y, c.x, c.y);
        }
      } else if (!path.closed || i + 1 < path.pieces.size()) {
        const Point2 p = at(piece.to);
        cairo_line_to(cairo, p.x, p.y);
      }
    }
    if (path.closed) cairo_close_path(cairo);
  }
}

/// A closed polyline becomes a closed path.
void add_polylines(cairo_t* cairo, const Polylines& lines, double parts_per_mm) {
  const auto at = [&](Point2 p) { return in_parts(p, parts_per_mm); };
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const auto line = lines[i];
    if (line.size() < 2) continue;
    const bool closed = line.size() > 3 && at(line.front()) == at(line.back());
    for (std::size_t k = 0; k < line.size() - (closed ? 1 : 0); ++k) {
      const Point2 p = at(line[k]);
      k == 0 ? cairo_move_to(cairo, p.x, p.y) : cairo_line_to(cairo, p.x, p.y);
    }
    if (closed) cairo_close_path(cairo);
  }
}

/// Solid lines have round ends; dashes have flat ones, so that dash and gap keep their lengths.
void set_line_style(cairo_t* cairo, const LineStyle& style, double units_per_mm) {
  cairo_set_source_rgb(cairo, style.color[0], style.color[1], style.color[2]);
  cairo_set_line_width(cairo, style.width_mm * units_per_mm);
  cairo_set_line_join(cairo, CAIRO_LINE_JOIN_ROUND);
  cairo_set_line_cap(cairo, style.dashes_mm.empty() ? CAIRO_LINE_CAP_ROUND : CAIRO_LINE_CAP_BUTT);
  std::vector<double> dashes = style.dashes_mm;
  for (double& d : dashes) d *= units_per_mm;
  cairo_set_dash(cairo, dashes.data(), static_cast<int>(dashes.size()), 0);
}

}  // namespace

void check_cairo(cairo_status_t status) {
  if (status == CAIRO_STATUS_NO_MEMORY) throw std::bad_alloc();
  if (status != CAIRO_STATUS_SUCCESS) throw std::runtime_error(std::string("cairo: ") + cairo_status_to_string(status));
}

double largest_coordinate(std::span<const Point2> points) {
  double largest = 0;
  for (const Point2 p : points) largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
  return largest;
}

double largest_coordinate(const Drawing& drawing, const Page& page) {
  double largest = std::max(page.width_mm, page.height_mm);
  for (const Layer& layer : drawing.layers) largest = std::max(largest, largest_coordinate(layer.lines.points));
  for (const Fill& fill : drawing.fills) {
    for (const auto& contour : fill.contours) largest = std::max(largest, largest_coordinate(contour));
  }
  return largest;
}

void stroke_polylines(cairo_t* cairo, const Polylines& lines, const LineStyle& style, const PathForm& form) {
  set_line_style(cairo, style, form.units_per_mm);
  cairo_save(cairo);
  cairo_scale(cairo, form.units_per_mm, form.units_per_mm);
  form.curves ? add_curves(cairo, lines, form) : add_polylines(cairo, lines, form.parts_per_mm);
  cairo_restore(cairo);
  cairo_stroke(cairo);
  check_cairo(cairo_status(cairo));
}

std::size_t end_of_area(const std::vector<Fill>& fills, std::size_t first) {
  const Fill& fill = fills[first];
  std::size_t last = first + 1;
  // Areas that may overlap are painted one by one: as one path the even-odd rule would leave their overlap white.
  if (fill.opacity < 1 || fill.overlaps) return last;
  while (last < fills.size() && fills[last].color == fill.color && fills[last].opacity == fill.opacity) ++last;
  return last;
}

void paint_fills(cairo_t* cairo, const std::vector<Fill>& fills, double units_per_mm) {
  cairo_set_fill_rule(cairo, CAIRO_FILL_RULE_EVEN_ODD);
  cairo_set_line_width(cairo, kFillRimMm * units_per_mm);
  cairo_set_line_join(cairo, CAIRO_LINE_JOIN_ROUND);
  cairo_set_dash(cairo, nullptr, 0, 0);
  for (std::size_t i = 0; i < fills.size();) {
    const Fill& first = fills[i];
    cairo_set_source_rgba(cairo, first.color[0], first.color[1], first.color[2], first.opacity);
    for (const std::size_t last = end_of_area(fills, i); i < last; ++i) {
      for (const std::vector<Point2>& contour : fills[i].contours) {
        cairo_new_sub_path(cairo);
        for (const Point2& p : contour) cairo_line_to(cairo, p.x * units_per_mm, p.y * units_per_mm);
        cairo_close_path(cairo);
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
