/// Draws the text of an SVG in letters of single strokes.
///
/// Characters are collected with the properties of the elements around them. A character with a position of its own
/// begins a chunk, which the anchor shifts as a whole (SVG 1.1, 10.5).

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <vector>

#include "plotting/stroke_text.hpp"
#include "plotting/svg/reader.hpp"
#include "plotting/writers/cairo_path.hpp"

namespace ligne::svg {
namespace {

/// A path along which letters stand, in units of the text.
struct TextPath {
  std::vector<Point2> line;
  double start = 0;  ///< distance of the text along it

  /// The matrix to a place along it, with the direction of the path as x. Nothing beyond its ends.
  std::optional<Matrix> at(double along) const;
};

std::optional<Matrix> TextPath::at(double along) const {
  if (along < 0) return {};
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Point2 by = line[i] - line[i - 1];
    const double length = std::hypot(by.x, by.y);
    if (along <= length && length > 0) {
      const Point2 x = by / length, at = line[i - 1] + x * along;
      return Matrix{x.x, x.y, -x.y, x.x, at.x, at.y};
    }
    along -= length;
  }
  return {};
}

/// The path of an element; nullptr if it has none. Its curves are divided for the page.
std::shared_ptr<TextPath> text_path(const pugi::xml_node& element, const Attributes& attributes, const Matrix& to_mm) {
  const std::optional<Matrix> back = to_mm.inverse();
  if (local_name(element) != "path" || !back) return nullptr;
  Polylines lines;
  Outline outline(lines, to_mm * transform(element.attribute("transform").value()));
  outline_shape("path", element, attributes, outline);
  auto path = std::make_shared<TextPath>();
  for (const Point2& p : lines.points) path->line.push_back((*back)(p));
  return path;
}

struct Character {
  std::string utf8{};
  Style style{};
  std::optional<double> x{}, y{}, rotate{};
  double dx = 0, dy = 0;
  double advance = 0, stretch = 1;         ///< of its letter
  double inset = 0;                        ///< of a narrow letter, where all have one width
  int paragraph = 0;                       ///< its number in a flowRoot
  std::shared_ptr<const TextPath> path{};  ///< nullptr: on a straight line
  bool blank() const { return utf8 == " "; }
  bool begins_chunk(const Character* before) const { return !before || x || y || path != before->path; }
};

/// The part of its length by which a chunk is shifted back.
double shift_of(const Style& style) { return style.anchor == "middle" ? 0.5 : style.anchor == "end" ? 1 : 0; }

bool is_blank(char c) { return c == ' ' || c == '\n' || c == '\t' || c == '\r'; }

/// The lengths of a list such as "12 3em 4%".
std::vector<double> lengths(std::string_view list, const Viewport& port, double whole) {
  std::vector<double> values;
  while (!list.empty()) {
    const std::size_t begin = std::min(list.find_first_not_of(" ,\t\n\r"), list.size());
    list.remove_prefix(begin);
    const std::size_t end = std::min(list.find_first_of(" ,\t\n\r"), list.size());
    if (end > 0) values.push_back(length_px(list.substr(0, end), port, whole));
    list.remove_prefix(end);
  }
  return values;
}

class TextReader {
 public:
  using Styled = std::function<Style(const pugi::xml_node&, const Style&, bool&)>;
  using PathOf = std::function<std::shared_ptr<const TextPath>(const pugi::xml_node&)>;
  TextReader(const Viewport& port, const Diagnostics& diagnostics, Styled styled, PathOf path_of)
      : port_(port), diagnostics_(diagnostics), styled_(std::move(styled)), path_of_(std::move(path_of)) {}

  /// Collects the characters inside the element, whose style is given.
  void gather(const pugi::xml_node& node, const Style& style, int depth);
  /// Breaks the lines of a flowRoot (SVG 1.2), or of a text in a shape, at the width of a box.
  void flow(const Rect& box);
  /// Drops blanks at the end, which no viewer shows.
  void trim() {
    while (!characters.empty() && characters.back().blank() && !characters.back().style.keep_blanks) characters.pop_back();
  }

  std::vector<Character> characters;
  std::vector<pugi::xml_node> unknown;  ///< elements that a text can not have here

 private:
  void add(std::string_view text, const Style& style);
  void place(const pugi::xml_node& node, const Style& style, std::size_t first);
  void stretch(const pugi::xml_node& node, const Style& style, std::size_t first);

  /// The value of an attribute by `value_of(viewport)`. An invalid one is reported and gives an empty value.
  template <class ValueOf>
  auto read(const pugi::xml_node& node, const char* name, const Style& style, ValueOf&& value_of)
      -> decltype(value_of(std::declval<Viewport>())) {
    Viewport port = port_;
    port.em = style.font_size;
    try {
      return value_of(port);
    } catch (const std::invalid_argument& e) {
      diagnostics_.bad_value(name, node, e.what());
      return {};
    }
  }

  const Viewport& port_;
  const Diagnostics& diagnostics_;
  Styled styled_;
  PathOf path_of_;
  int paragraph_ = 0;
};

void TextReader::add(std::string_view text, const Style& style) {
  for (std::size_t i = 0; i < text.size();) {
    std::size_t n = 1;  // bytes of the character
    while (i + n < text.size() && (static_cast<unsigned char>(text[i + n]) & 0xc0) == 0x80) ++n;
    const bool blank = is_blank(text[i]);
    const bool dropped = blank && !style.keep_blanks && (characters.empty() || characters.back().blank());
    if (!dropped) {
      Character character{.utf8 = blank ? " " : std::string(text.substr(i, n)), .style = style, .paragraph = paragraph_};
      // Letters of single strokes are a quarter wider than those of most typefaces, for which a text leaves room.
      const double height = style.font_size * kCapitalsOfSize;
      const double drawn = text_extent(character.utf8, height, TextStyle::stroke).width;
      const double letter = style.typeface.of_sans * text_extent(character.utf8, height, TextStyle::font).width;
      const double fixed = style.typeface.fixed_em * style.font_size, width = fixed > 0 ? fixed : letter;
      if (drawn > 0 && letter > 0) character.stretch = std::min(letter, width) / drawn;
      character.inset = std::max(width - letter, 0.0) / 2;
      character.advance = width + style.letter_spacing + (blank ? style.word_spacing : 0);
      characters.push_back(std::move(character));
    }
    i += n;
  }
}

/// Applies x, y and rotate of an element where the elements inside it give none; dx and dy add up.
void TextReader::place(const pugi::xml_node& node, const Style& style, std::size_t first) {
  const auto each = [&](const char* name, double whole, auto&& set) {
    std::vector<double> values =
        read(node, name, style, [&](const Viewport& port) { return lengths(node.attribute(name).value(), port, whole); });
    for (std::size_t i = 0; i < values.size() && first + i < characters.size(); ++i) set(characters[first + i], values[i]);
    return values;
  };
  each("x", port_.width, [](Character& c, double v) {
    if (!c.x) c.x = v;
  });
  each("y", port_.height, [](Character& c, double v) {
    if (!c.y) c.y = v;
  });
  each("dx", port_.width, [](Character& c, double v) { c.dx += v; });
  each("dy", port_.height, [](Character& c, double v) { c.dy += v; });
  const std::vector<double> turns = each("rotate", 0, [](Character& c, double v) {
    if (!c.rotate) c.rotate = v;
  });
  if (turns.empty()) return;
  for (std::size_t i = first + turns.size(); i < characters.size(); ++i) {
    if (!characters[i].rotate) characters[i].rotate = turns.back();
  }
}

/// Applies `textLength`: blanks between the letters, or the letters themselves, take up the difference.
void TextReader::stretch(const pugi::xml_node& node, const Style& style, std::size_t first) {
  if (!node.attribute("textLength") || first >= characters.size()) return;
  const double wanted = read(node, "textLength", style, [&](const Viewport& port) {
    return length_px(node.attribute("textLength").value(), port, port.width);
  });
  double natural = 0;
  for (std::size_t i = first; i < characters.size(); ++i) natural += characters[i].advance;
  if (!(natural > 0 && wanted > 0)) return;
  const std::size_t count = characters.size() - first;
  const bool letters = std::string_view(node.attribute("lengthAdjust").value()) == "spacingAndGlyphs";
  for (std::size_t i = first; i < characters.size(); ++i) {
    if (letters) {
      characters[i].stretch *= wanted / natural;
      characters[i].advance *= wanted / natural;
      characters[i].inset *= wanted / natural;
    } else if (count > 1 && i + 1 < characters.size()) {
      characters[i].advance += (wanted - natural) / static_cast<double>(count - 1);
    }
  }
}

void TextReader::gather(const pugi::xml_node& node, const Style& style, int depth) {
  constexpr int kDeepest = 50;
  if (depth > kDeepest) throw CoordinateRangeError("is nested deeper than 50 elements");
  const std::size_t first = characters.size();
  for (const pugi::xml_node& child : node) {
    if (child.type() == pugi::node_pcdata || child.type() == pugi::node_cdata) {
      if (local_name(node) != "flowRoot") add(child.value(), style);
    } else if (child.type() == pugi::node_element) {
      const std::string_view name = local_name(child);
      const std::shared_ptr<const TextPath> path = name == "textPath" ? path_of_(child) : nullptr;
      if (name == "flowPara" || name == "flowDiv") ++paragraph_;
      if (name == "tspan" || name == "a" || path || (name.starts_with("flow") && !name.starts_with("flowRegion"))) {
        bool displayed = true;
        const Style inside = styled_(child, style, displayed);
        const std::size_t begin = characters.size();
        if (displayed) gather(child, inside, depth + 1);
        for (std::size_t i = begin; path && i < characters.size(); ++i) characters[i].path = path;
      } else if (name != "title" && name != "desc" && !name.empty() && !name.starts_with("flow")) {
        unknown.push_back(child);
      }
    }
  }
  place(node, style, first);
  stretch(node, style, first);
}

void TextReader::flow(const Rect& box) {
  constexpr double kBaseLine = 0.35;  // below the middle of a line, em
  double y = box.min.y;
  int paragraph = 1;
  for (std::size_t first = 0, end = 0; first < characters.size(); first = end) {
    Character& begin = characters[first];
    double width = 0, size = 0, height = 0;
    const auto is_left = [&](std::size_t i) { return i < characters.size() && characters[i].paragraph == begin.paragraph; };
    std::size_t last = 0;  // behind the last blank
    for (end = first; is_left(end); ++end) {
      const Character& c = characters[end];
      if (c.blank()) last = end + 1;
      if (last > 0 && !c.blank() && width + c.advance > box.width()) break;
      width += c.advance;
      size = std::max(size, c.style.font_size);
      height = std::max(height, c.style.line_em * c.style.font_size);
    }
    if (is_left(end)) end = last;
    if (y >= box.max.y) return characters.resize(first);
    y += height * std::max(begin.paragraph - paragraph, 1);
    paragraph = begin.paragraph;
    begin.y = y - height / 2 + kBaseLine * size;
    begin.x = box.min.x + shift_of(begin.style) * box.width();
  }
}

}  // namespace

void SvgReader::draw_letter(const pugi::xml_node& node, const std::string& letter, const Style& style, const Matrix& place,
                            const Context& context) {
  const std::optional<Paint>& paint = style.fill && style.fill_seen ? style.fill : style.stroke;
  if (!has_paint(paint, node) || !style.visible || !(style.font_size > 0)) return;
  TextItem item{.text = letter, .height_mm = style.font_size * kCapitalsOfSize};
  Polylines lines;
  result_.boxes += append_stroke_text(item, lines);
  for (Point2& p : lines.points) {
    p = context.to_mm(place(p));
    if (!(std::abs(p.x) <= kFarthestMm && std::abs(p.y) <= kFarthestMm))
      throw CoordinateRangeError("is farther than a kilometre away");
  }
  const std::string color = color_of(*paint, node);
  Context inside = context;
  if (inside.layer.empty()) inside.layer = "text";
  // On strokes that fill an area white shows.
  if (color == kWhite && fills_.how == FillReading::How::outline) lines = draw_on_colors(std::move(lines), nullptr, inside);
  add_lines(lines, inside, color, 0);
}

void SvgReader::draw_text(const pugi::xml_node& node, const Context& context) {
  if (skip_.contains("text")) return refuse("text", node);
  const auto styled_inside = [&](const pugi::xml_node& child, const Style& inherited, bool& displayed) {
    Viewport port = context.port;
    port.em = inherited.font_size;
    return styled(child, inherited, port, displayed);
  };
  const auto path_of = [&](const pugi::xml_node& child) {
    const auto found = ids_.find(std::string(link_of(child)));
    auto path = found == ids_.end() ? nullptr : text_path(found->second, attributes(context), context.to_mm);
    if (path) try {
        for (const double v : lengths(child.attribute("startOffset").value(), context.port, path_length(path->line)))
          path->start = v;
      } catch (const std::invalid_argument& e) {
        diagnostics_.bad_value("startOffset", child, e.what());
      }
    return path;
  };
  TextReader text(context.port, diagnostics_, styled_inside, path_of);
  text.gather(node, context.style, 0);
  text.trim();
  const auto shape = ids_.find(context.style.text_box);
  if (local_name(node) == "flowRoot" || shape != ids_.end()) {
    const std::optional<Matrix> box = box_of(shape != ids_.end() ? shape->second : node.child("flowRegion"), context);
    if (!box) return;
    text.flow({{box->e, box->f}, {box->e + box->a, box->f + box->d}});
  }
  for (const pugi::xml_node& child : text.unknown) refuse("text", child);
  const std::vector<Character>& characters = text.characters;
  if (characters.empty()) return;
  ++painted_;
  Point2 pen{0, 0};
  for (std::size_t i = 0; i < characters.size(); ++i) {
    const Character& c = characters[i];
    if (c.begins_chunk(i > 0 ? &characters[i - 1] : nullptr)) {
      double length = c.advance;
      for (std::size_t k = i + 1; k < characters.size() && !characters[k].begins_chunk(&characters[k - 1]); ++k)
        length += characters[k].advance + characters[k].dx;
      const Point2 begin = c.path ? Point2{c.path->start, 0} : pen;
      pen = {c.x.value_or(begin.x) - shift_of(c.style) * length, c.path ? 0 : c.y.value_or(begin.y)};
    }
    pen += Point2{c.dx, c.dy};
    const double up = c.style.baseline_shift - c.style.baseline_em * c.style.font_size, middle = pen.x + c.advance / 2;
    const std::optional<Matrix> on = c.path ? c.path->at(middle) : Matrix{1, 0, 0, 1, middle, 0};
    if (on && !c.blank()) {
      const Matrix place{1, 0, 0, 1, c.inset - c.advance / 2, pen.y - up}, stretch{c.stretch, 0, 0, 1, 0, 0};
      draw_letter(node, c.utf8, c.style, *on * place * turn(c.rotate.value_or(0)) * stretch, context);
    }
    pen.x += c.advance;
  }
}

}  // namespace ligne::svg
