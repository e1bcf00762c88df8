/// SVG as strokes. The tree is walked once; an element is drawn, walked into, left out because it never shows, or refused by name. Links (use) are followed inside
/// the file only, to a fixed depth, and with a fixed number of elements in all, so that a small file can not ask for endless work.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <unordered_map>

#include <glm/geometric.hpp>
#include <pugixml.hpp>

#include "plotting/dashes.hpp"
#include "plotting/drawing_reader.hpp"
#include "plotting/svg/outline.hpp"
#include "plotting/svg/style.hpp"

namespace ligne {
namespace {

using svg::Matrix;
using svg::Style;

constexpr int kDeepest = 200, kMostLinks = 16;
/// Elements that are shown by links, in all.
constexpr std::size_t kMostLinked = 1'000'000;
/// Height of capitals by size of the font, as our own SVG writes it.
constexpr double kCapitals = 1493.0 / 2048;
constexpr std::string_view kWhite = "#ffffff";
constexpr double kLargestPageMm = 100000;

class SvgReader {
 public:
  SvgReader(std::string_view text, std::string file, const std::set<std::string>& skip) : text_(text), file_(std::move(file)), skip_(skip) {}

  ReadDrawing read();

 private:
  [[noreturn]] void fail(const pugi::xml_node& node, const std::string& cause) const;
  void refuse(std::string_view name, const pugi::xml_node& node);
  void find_ids(const pugi::xml_node& root);
  Matrix place_page(const pugi::xml_node& root);
  void walk(const pugi::xml_node& node, const Style& inherited, const Matrix& to_mm, const std::string& layer, int depth, int links);
  void walk_children(const pugi::xml_node& node, const Style& style, const Matrix& to_mm, const std::string& layer, int depth, int links);
  void follow_use(const pugi::xml_node& node, const Style& style, const Matrix& to_mm, const std::string& layer, int depth, int links);
  bool draw_shape(std::string_view name, const pugi::xml_node& node, const Style& style, const Matrix& to_mm, const std::string& layer);
  bool outline_shape(std::string_view name, const pugi::xml_node& node, svg::Outline& outline) const;
  void outline_rect(const pugi::xml_node& node, svg::Outline& outline) const;
  void draw_text(const pugi::xml_node& node, const Style& style, const Matrix& to_mm, const std::string& layer);
  void draw_text_run(const pugi::xml_node& node, const std::string& text, Point2 at, const Style& style, const Matrix& to_mm);
  Polylines& layer_named(const std::string& name);
  double length(const pugi::xml_node& node, const char* attribute, double otherwise = 0, double whole = 0) const;

  std::string_view text_;
  std::string file_;
  const std::set<std::string>& skip_;
  ReadDrawing result_;
  std::unordered_map<std::string, pugi::xml_node> ids_;
  double width_px_ = 0, height_px_ = 0;  ///< of the viewport, user units
  std::size_t linked_ = 0;
  bool drawn_ = false, entities_ = false;
};

void SvgReader::fail(const pugi::xml_node& node, const std::string& cause) const {
  const std::ptrdiff_t offset = node.offset_debug();
  std::string place = file_;
  if (offset > 0 && static_cast<std::size_t>(offset) <= text_.size()) {
    place += ":" + std::to_string(1 + std::count(text_.begin(), text_.begin() + offset, '\n'));
  }
  throw std::runtime_error(place + ": " + cause);
}

void SvgReader::refuse(std::string_view name, const pugi::xml_node& node) {
  if (skip_.contains(std::string(name))) {
    ++result_.left_out[std::string(name)];
    return;
  }
  fail(node, "<" + std::string(svg::local_name(node)) + "> has " + std::string(name) + ", which can not be drawn as strokes; --skip " + std::string(name) +
                 " leaves it out");
}

double SvgReader::length(const pugi::xml_node& node, const char* attribute, double otherwise, double whole) const {
  const pugi::xml_attribute found = node.attribute(attribute);
  if (!found) return otherwise;
  try {
    return svg::length_px(found.value(), whole > 0 ? std::optional(whole) : std::nullopt);
  } catch (const std::invalid_argument& e) {
    throw std::invalid_argument(std::string(attribute) + ": " + e.what());
  }
}

void SvgReader::find_ids(const pugi::xml_node& root) {
  // Without recursion: the file may be nested as deep as it likes.
  for (pugi::xml_node node = root; node;) {
    if (const pugi::xml_attribute id = node.attribute("id")) ids_.emplace(id.value(), node);
    if (node.first_child()) {
      node = node.first_child();
      continue;
    }
    while (node && node != root && !node.next_sibling()) node = node.parent();
    node = node == root ? pugi::xml_node() : node.next_sibling();
  }
}

/// Size of the page and where its units lie on it.
Matrix SvgReader::place_page(const pugi::xml_node& root) {
  std::vector<double> box;
  if (const pugi::xml_attribute view_box = root.attribute("viewBox")) {
    box = svg::numbers(view_box.value());
    if (box.size() != 4 || !(box[2] > 0 && box[3] > 0)) throw std::invalid_argument("viewBox is not x y width height");
  }
  const auto side = [&](const char* name, std::size_t of_box) {
    const std::string_view value = root.attribute(name).value();
    if (!value.empty() && !value.ends_with('%')) return length(root, name);
    if (box.empty()) throw std::invalid_argument(std::string("there is neither a ") + name + " nor a viewBox");
    return box[of_box];
  };
  const double width = side("width", 2), height = side("height", 3);
  Page& page = result_.page;
  page = {width * svg::kMmPerPx, height * svg::kMmPerPx, 0};
  if (!(page.width_mm > 0 && page.height_mm > 0 && page.width_mm <= kLargestPageMm && page.height_mm <= kLargestPageMm)) {
    throw std::invalid_argument("the page is empty or larger than 100 m");
  }
  const Matrix mm{svg::kMmPerPx, 0, 0, svg::kMmPerPx, 0, 0};
  width_px_ = box.empty() ? width : box[2];
  height_px_ = box.empty() ? height : box[3];
  if (box.empty()) return mm;
  double sx = width / box[2], sy = height / box[3];
  const std::string aspect = root.attribute("preserveAspectRatio").value();
  double dx = 0, dy = 0;
  if (!aspect.starts_with("none")) {
    sx = sy = aspect.find("slice") != std::string::npos ? std::max(sx, sy) : std::min(sx, sy);
    const auto share = [&](const char* low, const char* high) { return aspect.find(low) != std::string::npos ? 0.0 : aspect.find(high) != std::string::npos ? 1.0 : 0.5; };
    dx = (width - sx * box[2]) * share("xMin", "xMax");
    dy = (height - sy * box[3]) * share("YMin", "YMax");
  }
  return mm * Matrix{sx, 0, 0, sy, dx - sx * box[0], dy - sy * box[1]};
}

ReadDrawing SvgReader::read() {
  pugi::xml_document document;
  const pugi::xml_parse_result parsed =
      document.load_buffer(text_.data(), text_.size(), pugi::parse_default | pugi::parse_doctype | pugi::parse_ws_pcdata_single);
  if (!parsed) {
    const auto end = text_.begin() + std::clamp<std::ptrdiff_t>(parsed.offset, 0, static_cast<std::ptrdiff_t>(text_.size()));
    throw std::runtime_error(file_ + ":" + std::to_string(1 + std::count(text_.begin(), end, '\n')) + ": is not XML: " + parsed.description());
  }
  pugi::xml_node root;
  for (const pugi::xml_node& node : document) {
    if (node.type() == pugi::node_doctype) entities_ = std::string_view(node.value()).find("<!ENTITY") != std::string_view::npos;
    if (node.type() == pugi::node_element) root = node;
  }
  if (svg::local_name(root) != "svg") throw std::runtime_error(file_ + ": is not an SVG");
  find_ids(root);
  try {
    const Matrix to_mm = place_page(root);
    bool displayed = true;
    const Style style = svg::style_of(root, {}, displayed, [this](std::string_view name, const pugi::xml_node& node) { refuse(name, node); });
    const Matrix placed = root.attribute("transform") ? to_mm * svg::transform(root.attribute("transform").value()) : to_mm;
    if (displayed) walk_children(root, style, placed, "", 0, 0);
  } catch (const std::invalid_argument& e) {
    fail(root, e.what());
  }
  result_.dashes_cut = true;
  return std::move(result_);
}

Polylines& SvgReader::layer_named(const std::string& name) {
  for (Layer& layer : result_.drawing.layers) {
    if (layer.name == name) return layer.lines;
  }
  result_.drawing.layers.push_back({name, {}});
  return result_.drawing.layers.back().lines;
}

void SvgReader::walk_children(const pugi::xml_node& node, const Style& style, const Matrix& to_mm, const std::string& layer, int depth, int links) {
  if (depth > kDeepest) fail(node, "is nested deeper than " + std::to_string(kDeepest) + " elements");
  for (const pugi::xml_node& child : node) {
    if (child.type() == pugi::node_element) walk(child, style, to_mm, layer, depth + 1, links);
  }
}

void SvgReader::walk(const pugi::xml_node& node, const Style& inherited, const Matrix& to_mm, const std::string& layer, int depth, int links) {
  if (links > 0 && ++linked_ > kMostLinked) fail(node, "<use> shows more than a million elements");
  const std::string_view full = node.name(), name = svg::local_name(node);
  // Elements of editors and metadata have prefixes of their own.
  if (full != name && !full.starts_with("svg:")) return;
  for (const std::string_view unseen : {"defs", "title", "desc", "metadata", "script", "linearGradient", "radialGradient", "pattern", "clipPath", "mask", "filter", "marker"}) {
    if (name == unseen) return;
  }
  for (const std::string_view known : {"image", "foreignObject", "switch", "symbol", "svg"}) {
    if (name != known) continue;
    if (name == "symbol" && links == 0) return;  // shown only where it is used
    return refuse(known, node);
  }
  if (name == "style") {
    if (std::string_view(node.text().get()).find_first_not_of(" \t\r\n") != std::string_view::npos) refuse("style", node);
    return;
  }
  if (name == "animate" || name == "animateTransform" || name == "animateMotion" || name == "set") return refuse("animation", node);
  try {
    bool displayed = true;
    const Style style = svg::style_of(node, inherited, displayed, [this](std::string_view what, const pugi::xml_node& where) { refuse(what, where); });
    if (!displayed) return;
    const pugi::xml_attribute transform = node.attribute("transform");
    const Matrix placed = transform ? to_mm * svg::transform(transform.value()) : to_mm;
    if (name == "g" || name == "a") {
      const bool is_layer = std::string_view(node.attribute("inkscape:groupmode").value()) == "layer";
      const std::string label = node.attribute("inkscape:label").value();
      return walk_children(node, style, placed, is_layer && !label.empty() ? label : layer, depth, links);
    }
    if (name == "use") return follow_use(node, style, placed, layer, depth, links);
    if (name == "text") return style.visible ? draw_text(node, style, placed, layer) : void();
    if (!draw_shape(name, node, style, placed, layer)) fail(node, "<" + std::string(name.substr(0, 40)) + "> is not known, and could be something that shows");
  } catch (const std::invalid_argument& e) {
    fail(node, "<" + std::string(name.substr(0, 40)) + "> " + e.what());
  }
}

void SvgReader::follow_use(const pugi::xml_node& node, const Style& style, const Matrix& to_mm, const std::string& layer, int depth, int links) {
  if (links >= kMostLinks) fail(node, "<use> leads on more than " + std::to_string(kMostLinks) + " times");
  std::string_view target = node.attribute("href").value();
  if (target.empty()) target = node.attribute("xlink:href").value();
  if (!target.starts_with('#')) fail(node, "<use> leads out of the file");
  const auto found = ids_.find(std::string(target.substr(1)));
  if (found == ids_.end()) return;  // as viewers do
  const Matrix placed = to_mm * Matrix{1, 0, 0, 1, length(node, "x", 0, width_px_), length(node, "y", 0, height_px_)};
  if (depth > kDeepest) fail(node, "is nested deeper than " + std::to_string(kDeepest) + " elements");
  walk(found->second, style, placed, layer, depth + 1, links + 1);
}

void SvgReader::outline_rect(const pugi::xml_node& node, svg::Outline& outline) const {
  const double x = length(node, "x", 0, width_px_), y = length(node, "y", 0, height_px_);
  const double w = length(node, "width", 0, width_px_), h = length(node, "height", 0, height_px_);
  if (!(w > 0 && h > 0)) return;
  const bool has_rx = node.attribute("rx"), has_ry = node.attribute("ry");
  double rx = length(node, "rx"), ry = length(node, "ry");
  if (!has_rx) rx = ry;
  if (!has_ry) ry = rx;
  rx = std::clamp(rx, 0.0, w / 2);
  ry = std::clamp(ry, 0.0, h / 2);
  if (rx == 0 || ry == 0) {
    outline.move_to({x, y});
    for (const Point2 p : {Point2{x + w, y}, {x + w, y + h}, {x, y + h}}) outline.line_to(p);
  } else {
    outline.move_to({x + rx, y});
    const auto corner = [&](Point2 from, Point2 to) {
      if (outline.at() != from) outline.line_to(from);
      outline.arc_to(rx, ry, 0, false, true, to);
    };
    corner({x + w - rx, y}, {x + w, y + ry});
    corner({x + w, y + h - ry}, {x + w - rx, y + h});
    corner({x + rx, y + h}, {x, y + h - ry});
    corner({x, y + ry}, {x + rx, y});
  }
  outline.close();
}

/// False when it is no shape.
bool SvgReader::outline_shape(std::string_view name, const pugi::xml_node& node, svg::Outline& outline) const {
  if (name == "path") {
    svg::add_path(outline, node.attribute("d").value());
  } else if (name == "line") {
    outline.move_to({length(node, "x1", 0, width_px_), length(node, "y1", 0, height_px_)});
    outline.line_to({length(node, "x2", 0, width_px_), length(node, "y2", 0, height_px_)});
  } else if (name == "polyline" || name == "polygon") {
    const std::vector<double> v = svg::numbers(node.attribute("points").value());
    if (v.size() % 2 == 1) throw std::invalid_argument("points: an odd number of numbers");
    for (std::size_t i = 0; i + 1 < v.size(); i += 2) i == 0 ? outline.move_to({v[0], v[1]}) : outline.line_to({v[i], v[i + 1]});
    if (name == "polygon") outline.close();
  } else if (name == "rect") {
    outline_rect(node, outline);
  } else if (name == "circle" || name == "ellipse") {
    const Point2 center{length(node, "cx", 0, width_px_), length(node, "cy", 0, height_px_)};
    const double diagonal = std::hypot(width_px_, height_px_) / std::sqrt(2.0);
    const double rx = name == "circle" ? length(node, "r", 0, diagonal) : length(node, "rx", 0, width_px_);
    const double ry = name == "circle" ? rx : length(node, "ry", 0, height_px_);
    if (rx > 0 && ry > 0) {
      outline.move_to({center.x + rx, center.y});
      outline.arc(center, rx, ry, 0, 0, 2 * std::numbers::pi);
      outline.close();
    }
  } else {
    return false;
  }
  outline.end();
  return true;
}

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

bool SvgReader::draw_shape(std::string_view name, const pugi::xml_node& node, const Style& style, const Matrix& to_mm, const std::string& layer) {
  Polylines lines;
  svg::Outline outline(lines, to_mm);
  if (!outline_shape(name, node, outline)) return false;
  if (!style.visible) return true;
  const bool stroked = style.stroke && style.stroke_seen && style.stroke_width > 0;
  if (style.fill && style.fill_seen && name != "line" && has_area(lines)) {
    // White below everything is paper.
    const bool paper = !drawn_ && !stroked && (*style.fill == kWhite || *style.fill == "white");
    if (!paper) refuse("fill", node);
  }
  if (!stroked || lines.size() == 0) return true;
  drawn_ = true;
  if (!style.dashes.empty()) {
    if (!to_mm.is_similarity() && !(to_mm.b == 0 && to_mm.c == 0 && to_mm.a == -to_mm.d)) {
      throw std::invalid_argument("has dashes that a transform stretches, which are not known");
    }
    std::vector<double> dashes = style.dashes;
    for (double& dash : dashes) dash *= to_mm.stretch();
    lines = cut_pattern(lines, dashes, style.dash_offset * to_mm.stretch());
  }
  Polylines& target = layer_named(layer.empty() ? *style.stroke : layer);
  const auto shift = static_cast<std::uint32_t>(target.points.size());
  if (target.points.size() + lines.points.size() > svg::kMostPoints) throw std::invalid_argument("the drawing has more than fifty million points");
  target.points.insert(target.points.end(), lines.points.begin(), lines.points.end());
  for (std::size_t i = 1; i < lines.begin.size(); ++i) target.begin.push_back(lines.begin[i] + shift);
  return true;
}

void SvgReader::draw_text(const pugi::xml_node& node, const Style& style, const Matrix& to_mm, const std::string&) {
  if (skip_.contains("text")) return refuse("text", node);
  const auto at_of = [&](const pugi::xml_node& n, Point2 otherwise) {
    return Point2{length(n, "x", otherwise.x, width_px_), length(n, "y", otherwise.y, height_px_)};
  };
  const auto plain = [&](const pugi::xml_node& n) {
    for (const char* attribute : {"dx", "dy", "rotate", "textLength", "baseline-shift"}) {
      if (n.attribute(attribute)) refuse("text", n);
    }
  };
  plain(node);
  Point2 at = at_of(node, {0, 0});
  std::string run;
  Style run_style = style;
  const auto flush = [&] {
    draw_text_run(node, run, at, run_style, to_mm);
    run.clear();
  };
  for (const pugi::xml_node& child : node) {
    if (child.type() == pugi::node_pcdata || child.type() == pugi::node_cdata) {
      run += child.value();
    } else if (svg::local_name(child) == "tspan") {
      plain(child);
      if (child.attribute("x") || child.attribute("y")) {
        flush();
        at = at_of(child, at);
      }
      bool displayed = true;
      run_style = svg::style_of(child, style, displayed, [this](std::string_view what, const pugi::xml_node& where) { refuse(what, where); });
      for (const pugi::xml_node& part : child) {
        if (part.type() == pugi::node_element) refuse("text", part);
      }
      if (displayed) run += child.text().get();
    } else if (child.type() == pugi::node_element && svg::local_name(child) != "title") {
      refuse("text", child);
    }
  }
  flush();
}

void SvgReader::draw_text_run(const pugi::xml_node& node, const std::string& text, Point2 at, const Style& style, const Matrix& to_mm) {
  // Runs of blanks are one, and none at the ends.
  std::string clean;
  for (const char c : text) {
    const bool blank = c == ' ' || c == '\n' || c == '\t' || c == '\r';
    if (!blank || (!clean.empty() && clean.back() != ' ')) clean += blank ? ' ' : c;
  }
  while (!clean.empty() && clean.back() == ' ') clean.pop_back();
  if (clean.empty() || !(style.font_size > 0)) return;
  if (entities_ && clean.find('&') != std::string::npos) fail(node, "<text> uses an entity of the document, which is not read");
  if (!to_mm.is_similarity()) return refuse("text", node);
  TextItem item;
  item.text = clean;
  item.at = to_mm(at);
  item.height_mm = style.font_size * kCapitals * to_mm.stretch();
  item.across = style.anchor == "middle" ? TextAcross::center : style.anchor == "end" ? TextAcross::right : TextAcross::left;
  item.rotation_degrees = -std::atan2(to_mm.b, to_mm.a) * 180 / std::numbers::pi;
  const bool inside = std::abs(item.at.x) <= kFarthestMm && std::abs(item.at.y) <= kFarthestMm && item.height_mm <= kFarthestMm;
  if (!inside) throw std::invalid_argument("is farther than a kilometre away");
  drawn_ = true;
  result_.drawing.texts.push_back(std::move(item));
}

}  // namespace

ReadDrawing read_svg_drawing(std::string_view svg, const std::string& file, const std::set<std::string>& skip) { return SvgReader(svg, file, skip).read(); }

}  // namespace ligne
