#include "plotting/writers/cairo_path.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <new>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/parallel.hpp"
#include "plotting/readers/utf8.hpp"

namespace ligne {
namespace {

/// Paints the halo of a text that begins at the current point, and keeps that point.
void stroke_halo(cairo_t* cairo, const std::string& text, double halo_mm) {
  double x = 0, y = 0;
  cairo_get_current_point(cairo, &x, &y);
  cairo_save(cairo);
  cairo_set_source_rgb(cairo, 1, 1, 1);
  cairo_set_line_width(cairo, 2 * halo_mm);
  cairo_set_line_join(cairo, CAIRO_LINE_JOIN_ROUND);
  cairo_text_path(cairo, text.c_str());
  cairo_stroke(cairo);
  cairo_restore(cairo);
  cairo_move_to(cairo, x, y);
}

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

/// A pixel as Cairo stores it: blue in the lowest byte.
static std::uint32_t pixel_at(const FacePicture& picture, std::size_t i) {
  if (picture.rgb.empty()) return picture.gray[i] * 0x010101u;
  constexpr unsigned kRed = 16, kGreen = 8;
  const std::uint8_t* const rgb = picture.rgb.data() + 3 * i;
  return std::uint32_t{rgb[0]} << kRed | std::uint32_t{rgb[1]} << kGreen | rgb[2];
}

void put_pixels(cairo_surface_t* surface, const FacePicture& picture) {
  cairo_surface_flush(surface);
  unsigned char* const data = cairo_image_surface_get_data(surface);
  if (!data) return;  // the surface has an error, which check_cairo() reports later
  const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(surface));
  for (std::uint32_t y = 0; y < picture.height; ++y) {
    for (std::uint32_t x = 0; x < picture.width; ++x) {
      const std::uint32_t pixel = pixel_at(picture, std::size_t{y} * picture.width + x);
      std::memcpy(data + y * stride + 4 * std::size_t{x}, &pixel, sizeof pixel);
    }
  }
  cairo_surface_mark_dirty(surface);
}

/// Attaches to a surface the PNG of a gray picture that an SVG will contain: Cairo itself would write gray as three
/// colours.
static void attach_png(cairo_surface_t* surface, const FacePicture& picture) {
  const auto width = static_cast<int>(picture.width), height = static_cast<int>(picture.height);
  const CairoSurface gray(cairo_image_surface_create(CAIRO_FORMAT_A8, width, height));  // which Cairo writes as gray
  check_cairo(cairo_surface_status(gray.get()));
  const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(gray.get()));
  for (std::size_t y = 0; y < picture.height; ++y) {
    std::memcpy(cairo_image_surface_get_data(gray.get()) + y * stride, picture.gray.data() + y * picture.width,
                picture.width);
  }
  cairo_surface_mark_dirty(gray.get());
  auto png = std::make_unique<std::string>();
  check_cairo(cairo_surface_write_to_png_stream(gray.get(), append_to_string, png.get()));
  const auto* const bytes = reinterpret_cast<const unsigned char*>(png->data());
  const auto free_png = [](void* string) { delete static_cast<std::string*>(string); };
  check_cairo(cairo_surface_set_mime_data(surface, CAIRO_MIME_TYPE_PNG, bytes, png->size(), free_png, png.get()));
  static_cast<void>(png.release());
}

void paint_faces(cairo_t* cairo, const FacePicture& picture, double units_per_mm) {
  if (picture.empty()) return;
  const CairoSurface surface(
      cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(picture.width), static_cast<int>(picture.height)));
  check_cairo(cairo_surface_status(surface.get()));
  put_pixels(surface.get(), picture);
  const bool in_svg = cairo_surface_get_type(cairo_get_target(cairo)) == CAIRO_SURFACE_TYPE_SVG;
  if (in_svg && picture.rgb.empty()) attach_png(surface.get(), picture);
  cairo_save(cairo);
  cairo_translate(cairo, picture.corner_mm.x * units_per_mm, picture.corner_mm.y * units_per_mm);
  cairo_scale(cairo, picture.pixel_mm * units_per_mm, picture.pixel_mm * units_per_mm);
  cairo_set_source_surface(cairo, surface.get(), 0, 0);
  cairo_pattern_set_filter(cairo_get_source(cairo), CAIRO_FILTER_NEAREST);
  cairo_paint(cairo);
  cairo_restore(cairo);
  check_cairo(cairo_status(cairo));
}

void write_texts(cairo_t* cairo, std::span<const TextItem> texts) {
  if (texts.empty()) return;
  // Without hints letters stand exactly in their places, not on whole pixels.
  const std::unique_ptr<cairo_font_options_t, void (*)(cairo_font_options_t*)> exact(cairo_font_options_create(),
                                                                                     cairo_font_options_destroy);
  cairo_font_options_set_hint_style(exact.get(), CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_hint_metrics(exact.get(), CAIRO_HINT_METRICS_OFF);
  cairo_font_options_set_antialias(exact.get(), CAIRO_ANTIALIAS_GRAY);
  cairo_save(cairo);
  cairo_set_font_options(cairo, exact.get());
  cairo_select_font_face(cairo, kTypeface, CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_source_rgb(cairo, 0, 0, 0);
  for (const TextItem& item : texts) {
    const std::string text = clean_utf8(item.text);
    cairo_set_font_size(cairo, item.height_mm / kCapitalsOfSize);
    cairo_text_extents_t extents;
    cairo_text_extents(cairo, text.c_str(), &extents);
    const double before = item.across == TextAcross::left ? 0 : item.across == TextAcross::center ? 0.5 : 1;
    const Point2 base = base_point(item);
    cairo_save(cairo);
    cairo_translate(cairo, base.x, base.y);
    cairo_rotate(cairo, -item.rotation_degrees * std::numbers::pi / 180);
    cairo_move_to(cairo, -before * extents.x_advance, 0);
    if (item.halo_mm > 0) stroke_halo(cairo, text, item.halo_mm);
    cairo_show_text(cairo, text.c_str());
    cairo_restore(cairo);
    cairo_new_path(cairo);
  }
  cairo_restore(cairo);
  check_cairo(cairo_status(cairo));
}

}  // namespace ligne
