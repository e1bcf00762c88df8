/// What an SVG draws: shapes, fills and text.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <glm/geometric.hpp>

#include "plotting/dashes.hpp"
#include "plotting/hatch.hpp"
#include "plotting/stroke_text.hpp"
#include "plotting/svg/reader.hpp"

namespace ligne::svg {
namespace {

/// Height of capitals by size of the font, as our own SVG writes it.
constexpr double kCapitals = 1493.0 / 2048;
constexpr std::string_view kWhite = "#ffffff";
/// Adjustable: distance of the strokes that fill an area, in widths of the pen.
constexpr double kFillSpacing = 0.8;
/// Crossings of contours with the lines of hatches, in all.
constexpr double kMostFillWork = 5e7;

/// Whether a fill of these lines would show: some line leaves its first chord.
bool has_area(const Polylines& lines) {
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const auto line = lines[i];
    for (std::size_t k = 2; k < line.size(); ++k) {
      const Point2 u = line[1] - line[0], v = line[k] - line[0];
      if (u.x * v.y - u.y * v.x != 0) return true;
    }
  }
  return false;
}

/// Without round or square ends a line of no length does not show.
Polylines without_dots(const Polylines& lines) {
  Polylines kept;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const auto line = lines[i];
    if (std::all_of(line.begin(), line.end(), [&](Point2 p) { return p == line[0]; })) continue;
    kept.points.insert(kept.points.end(), line.begin(), line.end());
    kept.begin.push_back(static_cast<std::uint32_t>(kept.points.size()));
  }
  return kept;
}

}  // namespace

/// Lines in the layer, or in that of their colour, as far as they show.
void SvgReader::add_lines(const Polylines& given, const Context& context, const std::string& color) {
  const Polylines shown = context.clip ? clipped(given, *context.clip) : Polylines{};
  const Polylines& lines = context.clip ? shown : given;
  if (lines.size() == 0) return;
  drawn_ = true;
  Polylines& target = layer_named(context.layer.empty() ? color : context.layer);
  const auto shift = static_cast<std::uint32_t>(target.points.size());
  if (target.points.size() + lines.points.size() > kMostPoints)
    throw std::invalid_argument("the drawing has more than fifty million points");
  target.points.insert(target.points.end(), lines.points.begin(), lines.points.end());
  for (std::size_t i = 1; i < lines.begin.size(); ++i) target.begin.push_back(lines.begin[i] + shift);
}

void SvgReader::draw_fill(const pugi::xml_node& node, const Polylines& lines, const Context& context, bool stroked) {
  const Style& style = context.style;
  const bool white = *style.fill == kWhite || *style.fill == "white";
  // White below everything is paper.
  if (white && !drawn_) return;
  if (white || fills_.how == FillReading::How::refuse || skip_.contains("fill")) return refuse("fill", node);
  Polylines contours = lines;
  for (std::size_t i = 0; i + 1 < contours.begin.size(); ++i) {
    const auto line = lines[i];
    if (line.front() == line.back()) continue;
    // A fill closes what is open.
    contours.points.insert(contours.points.begin() + contours.begin[i + 1], line.front());
    for (std::size_t k = i + 1; k < contours.begin.size(); ++k) ++contours.begin[k];
  }
  if (!stroked) add_lines(contours, context, *style.fill);
  if (fills_.how != FillReading::How::hatch) return;
  std::vector<std::vector<Point2>> area;
  for (std::size_t i = 0; i < contours.size(); ++i) area.emplace_back(contours[i].begin(), contours[i].end());
  HatchOptions options;
  options.pen_width_mm = fills_.pen_width_mm;
  options.spacing_mm = kFillSpacing * fills_.pen_width_mm;
  options.even_odd = style.fill_even_odd;
  // What the engine has to do grows with how often the contours cross its lines.
  const double line_mm = hatch_line_mm(options.spacing_mm, options.pen_width_mm);
  for (std::size_t i = 0; i < contours.size(); ++i) {
    for (std::size_t k = 1; k < contours[i].size(); ++k)
      fill_work_ += 1 + glm::distance(contours[i][k - 1], contours[i][k]) / line_mm;
  }
  if (fill_work_ > kMostFillWork) throw std::invalid_argument("has fills that ask for endless work");
  add_lines(hatch(area, options), context, *style.fill);
}

bool SvgReader::draw_shape(std::string_view name, const pugi::xml_node& node, const Context& context) {
  const Style& style = context.style;
  const Matrix& to_mm = context.to_mm;
  Polylines lines;
  Outline outline(lines, to_mm);
  if (!outline_shape(name, node, context.port, outline)) return false;
  if (!style.visible) return true;
  const bool stroked = style.stroke && style.stroke_seen && style.stroke_width > 0;
  if (style.fill && style.fill_seen && name != "line" && has_area(lines)) draw_fill(node, lines, context, stroked);
  if (!stroked || lines.size() == 0) return true;
  if (!style.dashes.empty()) {
    if (!to_mm.is_similarity() && !(to_mm.b == 0 && to_mm.c == 0 && to_mm.a == -to_mm.d)) {
      throw std::invalid_argument("has dashes that a transform stretches, which are not known");
    }
    std::vector<double> dashes = style.dashes;
    for (double& dash : dashes) dash *= to_mm.stretch();
    lines = cut_pattern(lines, dashes, style.dash_offset * to_mm.stretch());
  }
  add_lines(style.round_caps ? lines : without_dots(lines), context, *style.stroke);
  return true;
}

void SvgReader::draw_text(const pugi::xml_node& node, const Context& context) {
  if (skip_.contains("text")) return refuse("text", node);
  const auto at_of = [&](const pugi::xml_node& n, Point2 otherwise) {
    return Point2{length(n, "x", otherwise.x, context.port.width), length(n, "y", otherwise.y, context.port.height)};
  };
  const auto plain = [&](const pugi::xml_node& n) {
    for (const char* attribute : {"dx", "dy", "rotate", "textLength", "baseline-shift"}) {
      if (n.attribute(attribute)) refuse("text", n);
    }
  };
  plain(node);
  Point2 at = at_of(node, {0, 0});
  std::string run;
  Style run_style = context.style;
  const auto flush = [&] {
    draw_text_run(node, run, at, run_style, context);
    run.clear();
  };
  for (const pugi::xml_node& child : node) {
    if (child.type() == pugi::node_pcdata || child.type() == pugi::node_cdata) {
      run += child.value();
    } else if (local_name(child) == "tspan") {
      plain(child);
      if (child.attribute("x") || child.attribute("y")) {
        flush();
        at = at_of(child, at);
      }
      bool displayed = true;
      run_style = styled(child, context.style, displayed);
      for (const pugi::xml_node& part : child) {
        if (part.type() == pugi::node_element) refuse("text", part);
      }
      if (displayed) run += child.text().get();
    } else if (child.type() == pugi::node_element && local_name(child) != "title") {
      refuse("text", child);
    }
  }
  flush();
}

void SvgReader::draw_text_run(const pugi::xml_node& node, const std::string& text, Point2 at, const Style& style,
                              const Context& context) {
  const Matrix& to_mm = context.to_mm;
  // Runs of blanks are one, and none at the ends.
  std::string clean;
  for (const char c : text) {
    const bool blank = c == ' ' || c == '\n' || c == '\t' || c == '\r';
    if (!blank || (!clean.empty() && clean.back() != ' ')) clean += blank ? ' ' : c;
  }
  while (!clean.empty() && clean.back() == ' ') clean.pop_back();
  if (clean.empty() || !(style.font_size > 0)) return;
  if (entities_ && clean.find('&') != std::string::npos)
    fail(node, "<text> uses an entity of the document, which is not read");
  if (!to_mm.is_similarity()) return refuse("text", node);
  TextItem item;
  item.text = clean;
  item.at = to_mm(at);
  item.height_mm = style.font_size * kCapitals * to_mm.stretch();
  item.across = style.anchor == "middle" ? TextAcross::center : style.anchor == "end" ? TextAcross::right : TextAcross::left;
  item.rotation_degrees = -std::atan2(to_mm.b, to_mm.a) * 180 / std::numbers::pi;
  const bool inside =
      std::abs(item.at.x) <= kFarthestMm && std::abs(item.at.y) <= kFarthestMm && item.height_mm <= kFarthestMm;
  if (!inside) throw std::invalid_argument("is farther than a kilometre away");
  drawn_ = true;
  if (context.clip) {
    Drawing strokes;
    strokes.texts.push_back(item);
    draw_texts_as_strokes(strokes);
    for (const Layer& layer : strokes.layers) {
      const Polylines shown = clipped(layer.lines, *context.clip);
      if (shown.begin == layer.lines.begin) continue;
      Context plain = context;
      plain.clip = nullptr;
      plain.layer = layer.name;
      return add_lines(shown, plain, layer.name);
    }
  }
  result_.drawing.texts.push_back(std::move(item));
}

}  // namespace ligne::svg
