/// Draws the shapes and fills of an SVG.

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "areas/work_limit_error.hpp"
#include "files/message_text.hpp"
#include "plotting/dashes.hpp"
#include "plotting/devices/pens.hpp"
#include "plotting/hatching/hatch.hpp"
#include "plotting/svg/reader.hpp"

namespace ligne::svg {
namespace {

/// Longest chain of gradients that take their colours from others.
constexpr int kMostPaintLinks = 16;
/// Distance of the strokes that fill an area, in widths of the pen. Adjustable.
constexpr double kFillSpacing = 0.8;
/// Most crossings of contours with the lines of hatches, in all.
constexpr double kMostFillWork = 5e7;

/// Most work on contours that cross each other, in steps of about 10 ns. Contours beyond it are drawn whole.
/// Adjustable.
constexpr double kMostBorderWork = 1e8;

/// Darkness, from 0 to 1, below which an area is left white. Adjustable.
constexpr double kLightest = 0.05;

bool is_white(const std::string& color) { return color == kWhite || color == "white"; }

bool is_white_paint(const Paint& paint) { return paint.server.empty() && is_white(paint.color); }

Rect box_around(const Polylines& lines) {
  Rect box;
  for (const Point2& p : lines.points) box.extend(p);
  return box;
}

bool overlap(const Rect& a, const Rect& b) {
  return a.min.x <= b.max.x && b.min.x <= a.max.x && a.min.y <= b.max.y && b.min.y <= a.max.y;
}

/// Whether a fill of these lines would show: some line leaves its first chord.
bool has_area(const Polylines& lines) {
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const auto line = lines[i];
    Point2 u{0, 0};
    for (const Point2& p : line) {
      const Point2 v = p - line[0];
      if (u == Point2{0, 0}) u = v;
      if (u.x * v.y - u.y * v.x != 0) return true;
    }
  }
  return false;
}

/// Removes lines of no length, which are invisible without round or square ends.
Polylines without_dots(const Polylines& lines) {
  Polylines kept;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const auto line = lines[i];
    if (std::any_of(line.begin(), line.end(), [&](Point2 p) { return p != line[0]; })) kept.add(line);
  }
  return kept;
}

/// Cuts dashes. Throws WorkLimitError if a few bytes ask for too many.
Polylines cut_some(const Polylines& lines, const std::vector<double>& dashes, double offset) {
  double length = 0, period = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) length += path_length(lines[i]);
  for (const double dash : dashes) period += dash;
  const double points = 2 * length / period * static_cast<double>(dashes.size());
  if (period >= kShortestPatternMm && points > static_cast<double>(kMostPoints))
    throw WorkLimitError("has more than fifty million dashes");
  return cut_pattern(lines, dashes, offset);
}

/// Cuts lines on the page into dashes. If the transform stretches one direction more than another, the lines are cut in
/// the element's units, scaled by the largest stretch.
Polylines dashed(Polylines lines, const Style& style, const Matrix& to_mm, double mm_per_px) {
  std::vector<double> dashes = style.dashes;
  const double scale = style.non_scaling ? mm_per_px : to_mm.stretch();
  for (double& dash : dashes) dash *= scale;
  const double offset = style.dash_offset * scale;
  const bool mirrored = to_mm.b == 0 && to_mm.c == 0 && to_mm.a == -to_mm.d;
  std::optional<Matrix> back = to_mm.inverse();
  // Largest ratio of the stretches of a transform. A flatter one makes lines of areas: their dashes can not be told
  // apart.
  constexpr double kFlattest = 1000;
  if (!back || back->stretch() * scale > kFlattest || style.non_scaling || to_mm.is_similarity() || mirrored)
    return cut_some(lines, dashes, offset);
  const Matrix there = Matrix{scale, 0, 0, scale, 0, 0} * *back, here = to_mm * Matrix{1 / scale, 0, 0, 1 / scale, 0, 0};
  for (Point2& p : lines.points) p = there(p);
  lines = cut_some(lines, dashes, offset);
  for (Point2& p : lines.points) p = here(p);
  return lines;
}

}  // namespace

/// Whether a paint is visible: a gradient or pattern that the file lacks is not, unless it has a fallback colour.
bool SvgReader::has_paint(const std::optional<Paint>& paint, const pugi::xml_node& node) {
  if (!paint) return false;
  if (is_server(paint->server)) return kind_of_server(paint->server) != ServerKind::empty;
  if (!paint->color.empty()) return true;
  leave_out("gradients and patterns missing from the file", node);
  return false;
}

bool SvgReader::is_server(const std::string& id) const {
  constexpr std::string_view kServers[] = {"linearGradient", "radialGradient", "pattern",    "hatch",
                                           "meshGradient",   "meshgradient",   "solidColor", "solidcolor"};
  const auto found = ids_.find(id);
  return found != ids_.end() && std::ranges::find(kServers, local_name(found->second)) != std::end(kServers);
}

SvgReader::ServerKind SvgReader::kind_of_server(const std::string& id) const {
  auto found = ids_.find(id);
  for (int links = 0; links < kMostPaintLinks && found != ids_.end(); ++links) {
    const pugi::xml_node server = found->second;
    // Patterns leave paper between their figures.
    if (!lower_case(local_name(server)).ends_with("gradient")) return ServerKind::translucent;
    bool has_stop = false, is_translucent = false;
    for (const pugi::xml_node& stop : server) {
      if (local_name(stop) != "stop" && local_name(stop) != "meshrow") continue;
      bool displayed = true;
      has_stop = true;
      is_translucent |= styled(stop, {}, {}, displayed).stop_opacity < 1;
    }
    if (has_stop) return is_translucent ? ServerKind::translucent : ServerKind::opaque;
    found = ids_.find(std::string(link_of(server)));
  }
  return ServerKind::empty;  // a gradient without colours paints nothing (SVG 1.1, 13.2.4)
}

/// Whether the fill of a shape is opaque, apart from groups that are translucent as a whole.
bool SvgReader::is_opaque_fill(const Context& context) const {
  const Style& style = context.style;
  return style.fill_opacity == 1 && style.opacity == 1 && style.fill->opacity == 1 && !style.blended &&
         (!is_server(style.fill->server) || kind_of_server(style.fill->server) == ServerKind::opaque);
}

/// The colour of a paint. A gradient gets its first colour that is visible on paper, since a pen has only one.
std::string SvgReader::color_of(const Paint& paint, const pugi::xml_node& node) {
  if (paint.server.empty() || !is_server(paint.server)) return paint.color;
  if (skip_.contains("paint")) refuse("paint", node);
  ++result_.simplified_paints;
  auto found = ids_.find(paint.server);
  for (int links = 0; links < kMostPaintLinks && found != ids_.end(); ++links) {
    const pugi::xml_node server = found->second;
    for (const pugi::xml_node& stop : server) {
      if (local_name(stop) != "stop") continue;
      bool displayed = true;
      const Style style = styled(stop, {}, {}, displayed);
      if (style.stop_color && !is_white(*style.stop_color)) return *style.stop_color;
    }
    found = ids_.find(std::string(link_of(server)));
  }
  return paint.color.empty() || is_white(paint.color) ? "#000000" : paint.color;
}

/// Adds the visible parts of lines to their layer, or to the layer of their colour.
void SvgReader::add_lines(const Polylines& given, const Context& context, const std::string& color, double width_mm) {
  const Polylines shown = context.clip ? clipped(given, *context.clip) : Polylines{};
  const Polylines& lines = context.clip ? shown : given;
  if (lines.size() == 0) return;
  drawn_ = true;
  PaintedLines& target = layer_of(context.layer.empty() ? color : context.layer, color, width_mm);
  if (target.layer.lines.points.size() + lines.points.size() > kMostPoints)
    throw WorkLimitError("the drawing has more than fifty million points");
  target.in_layer = context.layer;
  append(target.layer.lines, lines);
  target.painted.resize(target.layer.lines.size(), painted_);
}

FillRule SvgReader::fill_rule(const Context& context) {
  return context.style.fill_even_odd ? FillRule::even_odd : FillRule::nonzero;
}

/// Lets the area hide the lines painted before it. Layers that are not plotted hide nothing.
void SvgReader::hide(const Polylines& contours, const Context& context, std::optional<double> rim_width) {
  if ((!drawn_ && !fills_.occlude) || parse_layer_label(context.layer).skip) return;
  clip_points_ += contours.points.size();
  if (clip_points_ > kMostPoints) throw WorkLimitError("has areas of more than fifty million points");
  occluders_.push_back(
      {Area(contours, fill_rule(context), clip_work_), context.clip, painted_, context.since, context.layer, rim_width});
}

void SvgReader::remove_hidden() {
  if (occluders_.empty()) return;
  std::map<std::string, std::vector<Occluder>> by_layer;  // a single entry if areas hide across layers
  for (Occluder& occluder : occluders_) by_layer[fills_.own_layer ? occluder.layer : ""].push_back(std::move(occluder));
  for (const auto& [layer, areas] : by_layer) {
    Occluders occluders(areas, filled_, clip_work_);
    for (std::vector<PaintedLines>& parts : layers_) {
      for (PaintedLines& part : parts) {
        if (!fills_.own_layer || part.in_layer == layer)
          occluders.remove_hidden(part.layer.lines, part.painted, part.layer.width_mm.value_or(0));
      }
    }
  }
}

Polylines SvgReader::draw_on_colors(Polylines lines, const Area* white, const Context& context) {
  Polylines rest;
  Rect box = box_around(lines);
  for (auto below = fills_below_.rbegin(); below != fills_below_.rend() && lines.size() > 0; ++below) {
    if (++white_work_ > kMostBorderWork) break;
    if (!overlap(box, below->box)) continue;
    const FilledArea& filled = below->filled;
    if (!below->area) below->area.emplace(filled.contours, filled.rule, clip_work_);
    white_work_ += static_cast<double>(lines.points.size()) * std::sqrt(static_cast<double>(filled.contours.points.size()));
    DividedLines parts = divided(lines, *below->area, filled.clip.get(), white, context.clip.get());
    lines = std::move(parts.off);
    box = box_around(lines);
    if (is_white(below->color))
      append(rest, parts.on);
    else
      add_lines(parts.on, context, below->color, 0);
  }
  append(rest, lines);
  return rest;
}

/// Draws the lines that represent an area without a stroke: its contours, and its borders where clip paths cut it. Those
/// of white areas are drawn on the colours below them.
void SvgReader::draw_rim(const Polylines& contours, const Context& context, const std::string& color) {
  const bool white = is_white(color);
  if (!white) filled_.try_emplace(painted_, FilledArea{contours, fill_rule(context), context.clip});
  // Cutting n edges takes n searches, each over the boxes of about sqrt(n) edges.
  const double edges = static_cast<double>(contours.points.size()), work = edges * std::sqrt(edges);
  if (!context.clip && border_work_ + work > kMostBorderWork) {
    if (!white) add_lines(contours, context, color, 0);
    return;
  }
  const Area area(contours, fill_rule(context), clip_work_);
  Context cut = context;
  cut.clip = nullptr;
  Polylines rim;
  if (!context.clip) {
    border_work_ += work;
    rim = area_borders(drawn_once(contours), area);
  } else {
    rim = clipped(contours, *context.clip, &area);
    append(rim, clip_borders(area, *context.clip));
    rim = drawn_once(rim);
  }
  if (white)
    draw_on_colors(rim, &area, context);
  else
    add_lines(rim, cut, color, 0);
}

void SvgReader::draw_fill(const pugi::xml_node& node, const Polylines& lines, const Context& context, bool stroked,
                          bool stroke_follows) {
  const Style& style = context.style;
  const std::string color = color_of(*style.fill, node);
  const bool white = is_white(color);
  if (skip_.contains("fill")) return refuse("fill", node);
  if ((white || fills_.occlude) && is_opaque_fill(context)) {
    const std::optional<double> as_stroked =
        style.dashes.empty() && stroke_follows ? std::optional(stroke_width_mm(context)) : std::nullopt;
    hide(lines, context, stroked ? as_stroked : white ? std::nullopt : std::optional(0.0));
  }
  if (white && (fills_below_.empty() || !is_opaque_fill(context))) return;
  if (!white && fills_.how == FillReading::How::refuse) return refuse("fill", node);
  Polylines contours = lines;
  for (std::size_t i = 0; i + 1 < contours.begin.size(); ++i) {
    const auto line = lines[i];
    if (line.front() == line.back()) continue;
    // A fill closes open contours.
    contours.points.insert(contours.points.begin() + contours.begin[i + 1], line.front());
    for (std::size_t k = i + 1; k < contours.begin.size(); ++k) ++contours.begin[k];
  }
  if (!stroked) {
    draw_rim(contours, context, color);
  } else if (context.clip && !white) {
    Context cut = context;
    cut.clip = nullptr;
    const Area area(contours, fill_rule(context), clip_work_);
    add_lines(drawn_once(clip_borders(area, *context.clip)), cut, color, 0);
  }
  fills_below_.push_back({FilledArea{contours, fill_rule(context), context.clip}, color, box_around(contours)});
  if (white) return;
  if (fills_.how == FillReading::How::outline) ++result_.outlined;
  if (fills_.how == FillReading::How::hatch) hatch_fill(contours, context, color);
}

void SvgReader::hatch_fill(const Polylines& contours, const Context& context, const std::string& color) {
  const Style& style = context.style;
  std::vector<std::vector<Point2>> area;
  for (std::size_t i = 0; i < contours.size(); ++i) area.emplace_back(contours[i].begin(), contours[i].end());
  const FillHatch how = fills_.hatches.of(context.layer, color);
  HatchOptions options{.spacing_mm = how.spacing_mm.value_or(kFillSpacing * fills_.pen_width_mm),
                       .angle_degrees = how.angle_degrees,
                       .pen_width_mm = fills_.pen_width_mm,
                       .cross = how.cross};
  if (how.tone) {
    const double dark = (1 - brightness(color)) * style.fill_opacity * context.opacity;
    if (dark < kLightest) return;
    // The strokes cover the fraction `dark` of the paper; each of two families covers half of it.
    const double families = how.cross ? 2 : 1;
    options.spacing_mm = std::max(options.spacing_mm, families * options.pen_width_mm / dark);
  }
  options.even_odd = style.fill_even_odd;
  // Rows leave white in corners, and along a rim that is parallel to them.
  options.rim = options.spacing_mm <= options.pen_width_mm;
  // The work grows with the number of crossings of contours and lines.
  const double line_mm = hatch_line_mm(options);
  for (std::size_t i = 0; i < contours.size(); ++i) {
    for (std::size_t k = 1; k < contours[i].size(); ++k)
      fill_work_ += 1 + glm::distance(contours[i][k - 1], contours[i][k]) / line_mm;
  }
  if (fill_work_ > kMostFillWork) throw WorkLimitError("has fills that take too much work");
  add_lines(hatch(area, options), context, color, 0);
}

bool SvgReader::draw_shape(std::string_view name, const pugi::xml_node& node, const Context& context) {
  const Style& style = context.style;
  const Matrix& to_mm = context.to_mm;
  Polylines lines;
  const bool marked = std::ranges::any_of(style.markers, [](const std::string& id) { return !id.empty(); });
  std::vector<PathVertex> vertices;
  Outline outline(lines, to_mm, marked ? &vertices : nullptr);
  if (!outline_shape(name, node, attributes(context), outline)) return false;
  if (!style.visible) return true;
  const bool filled = style.fill_seen && name != "line" && has_area(lines) && has_paint(style.fill, node);
  // A white stroke is paper beside a coloured area, and would leave nothing of its outline.
  const bool outlined_by_paper =
      filled && !skip_.contains("fill") && style.stroke && is_white_paint(*style.stroke) && !is_white_paint(*style.fill);
  const bool stroked = style.stroke_seen && style.stroke_width > 0 && !outlined_by_paper && has_paint(style.stroke, node);
  bool stroke_follows = stroked;
  for (const PaintPart part : style.paint_order) {
    ++painted_;
    if (part == PaintPart::markers) {
      if (marked) draw_markers(node, vertices, context);
    } else if (part == PaintPart::stroke) {
      if (stroked && lines.size() > 0) draw_stroke(node, lines, context);
      stroke_follows = false;
    } else if (filled) {
      draw_fill(node, lines, context, stroked, stroke_follows);
    }
  }
  return true;
}

/// Length of one unit of `pathLength`, the element's own measure, in units of the element (SVG 2, 9.6.1).
double SvgReader::units_of_path_length(const pugi::xml_node& node, Polylines lines, const Context& context) {
  const double told = Attributes::has(node, "pathLength") ? attributes(context).along(node, "pathLength") : 0;
  const std::optional<Matrix> back = context.to_mm.inverse();
  if (!(told > 0) || !back) return 1;
  for (Point2& p : lines.points) p = (*back)(p);
  double length = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) length += path_length(lines[i]);
  return length > 0 ? length / told : 1;
}

double SvgReader::stroke_width_mm(const Context& context) const {
  return context.style.stroke_width * (context.style.non_scaling ? mm_per_px() : context.to_mm.mean_stretch());
}

void SvgReader::draw_stroke(const pugi::xml_node& node, Polylines lines, const Context& context) {
  const Style& style = context.style;
  const Matrix& to_mm = context.to_mm;
  if (!style.dashes.empty()) {
    Style cut = style;
    const double per_unit = units_of_path_length(node, lines, context);
    for (double& dash : cut.dashes) dash *= per_unit;
    cut.dash_offset *= per_unit;
    lines = dashed(lines, cut, to_mm, mm_per_px());
  }
  add_lines(style.round_caps ? lines : without_dots(lines), context, color_of(*style.stroke, node),
            stroke_width_mm(context));
}

}  // namespace ligne::svg
