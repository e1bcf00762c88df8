#include "plotting/writers/cairo_text.hpp"

#include <memory>
#include <numbers>

#include "plotting/readers/utf8.hpp"
#include "plotting/writers/cairo_path.hpp"

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

}  // namespace

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
