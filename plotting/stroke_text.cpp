#include "plotting/stroke_text.hpp"

#include <algorithm>
#include <array>
#include <charconv>

#include "plotting/fonts/simplex_glyphs.hpp"
#include "plotting/readers/utf8.hpp"

namespace ligne {
namespace {

/// Box for characters that the font lacks. Its width in a typeface is an em, as for ideographs, the widest of them.
constexpr SimplexGlyph kBox{0, 180, 1372, "30 0 30 210 150 210 150 0 30 0"};

const SimplexGlyph& glyph_of(char32_t code) {
  const auto glyphs = simplex_glyphs();
  const auto found =
      std::lower_bound(glyphs.begin(), glyphs.end(), code, [](const SimplexGlyph& g, char32_t c) { return g.code < c; });
  return found != glyphs.end() && found->code == code ? *found : kBox;
}

/// Calls point(x, y, starts a line) for all points of a glyph.
template <class Point>
void for_each_point(const SimplexGlyph& glyph, Point point) {
  const std::string_view text = glyph.lines;
  const char *p = text.data(), *const end = p + text.size();
  bool starts = true;
  while (p != end) {
    int x = 0, y = 0;
    p = std::from_chars(p, end, x).ptr + 1;
    p = std::from_chars(p, end, y).ptr;
    point(x, y, starts);
    starts = p != end && *p == ';';
    if (p != end) ++p;
  }
}

}  // namespace

TextExtent text_extent(std::string_view utf8, double height_mm, TextStyle style) {
  TextExtent extent;
  int low = 0, high = 0;
  for (const char32_t c : decode_utf8(utf8)) {
    const SimplexGlyph& glyph = glyph_of(c);
    extent.width += height_mm * (style == TextStyle::font ? glyph.typeface_width / 1000.0 : glyph.width / kSimplexCapital);
    for_each_point(glyph, [&](int, int y, bool) {
      low = std::min(low, y);
      high = std::max(high, y);
    });
  }
  extent.ascent = height_mm * high / kSimplexCapital;
  extent.descent = -height_mm * low / kSimplexCapital;
  return extent;
}

std::size_t append_stroke_text(const TextItem& item, Polylines& lines) {
  const double scale = item.height_mm / kSimplexCapital;
  const TextExtent extent = text_extent(item.text, item.height_mm, TextStyle::stroke);
  const std::array<Point2, 2> axes = TextBox{.rotation_degrees = item.rotation_degrees}.axes();
  const Point2 right = axes[0], up = axes[1];
  const double before = item.across == TextAcross::left ? 0 : item.across == TextAcross::center ? 0.5 : 1;
  Point2 pen = base_point(item) - right * (before * extent.width);
  std::size_t boxes = 0;
  for (const char32_t c : decode_utf8(item.text)) {
    const SimplexGlyph& glyph = glyph_of(c);
    if (&glyph == &kBox) ++boxes;
    for_each_point(glyph, [&](int x, int y, bool starts) {
      if (starts && lines.begin.back() != lines.points.size())
        lines.begin.push_back(static_cast<std::uint32_t>(lines.points.size()));
      lines.points.push_back(pen + right * (x * scale) + up * (y * scale));
    });
    if (lines.begin.back() != lines.points.size()) lines.begin.push_back(static_cast<std::uint32_t>(lines.points.size()));
    pen += right * (glyph.width * scale);
  }
  return boxes;
}

std::size_t draw_texts_as_strokes(Drawing& drawing) {
  std::size_t boxes = 0;
  Polylines lines;
  for (const TextItem& item : drawing.texts) boxes += append_stroke_text(item, lines);
  drawing.texts.clear();
  if (lines.size() > 0) drawing.layers.push_back({"text", std::move(lines)});
  return boxes;
}

}  // namespace ligne
