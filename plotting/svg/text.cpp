/// Draws the text of an SVG in letters of single strokes.
///
/// Characters are collected with the properties of the elements around them. A character with a position of its own
/// begins a chunk, which the anchor shifts as a whole (SVG 1.1, 10.5).

#include <cmath>
#include <optional>
#include <stdexcept>
#include <vector>

#include "plotting/stroke_text.hpp"
#include "plotting/svg/reader.hpp"
#include "plotting/writers/cairo_path.hpp"

namespace ligne::svg {
namespace {

struct Character {
  std::string utf8;
  Style style;
  std::optional<double> x, y, rotate;
  double dx = 0, dy = 0;
  double advance = 0, stretch = 1;  ///< of its letter
  bool blank() const { return utf8 == " "; }
};

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
  TextReader(const Viewport& port, const Diagnostics& diagnostics, Styled styled)
      : port_(port), diagnostics_(diagnostics), styled_(std::move(styled)) {}

  /// Collects the characters inside the element, whose style is given.
  void gather(const pugi::xml_node& node, const Style& style, int depth);
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
};

void TextReader::add(std::string_view text, const Style& style) {
  for (std::size_t i = 0; i < text.size();) {
    std::size_t n = 1;  // bytes of the character
    while (i + n < text.size() && (static_cast<unsigned char>(text[i + n]) & 0xc0) == 0x80) ++n;
    const bool blank = is_blank(text[i]);
    const bool dropped = blank && !style.keep_blanks && (characters.empty() || characters.back().blank());
    if (!dropped) {
      Character character;
      character.utf8 = blank ? " " : std::string(text.substr(i, n));
      character.style = style;
      const double height = style.font_size * kCapitalsOfSize;
      character.advance = text_extent(character.utf8, height, TextStyle::stroke).width + style.letter_spacing +
                          (blank ? style.word_spacing : 0);
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
      add(child.value(), style);
    } else if (child.type() == pugi::node_element) {
      const std::string_view name = local_name(child);
      if (name == "tspan" || name == "a") {
        bool displayed = true;
        const Style inside = styled_(child, style, displayed);
        if (displayed) gather(child, inside, depth + 1);
      } else if (name != "title" && name != "desc" && !name.empty()) {
        unknown.push_back(child);
      }
    }
  }
  place(node, style, first);
  stretch(node, style, first);
}

}  // namespace

void SvgReader::draw_text(const pugi::xml_node& node, const Context& context) {
  if (skip_.contains("text")) return refuse("text", node);
  TextReader text(context.port, diagnostics_, [&](const pugi::xml_node& child, const Style& inherited, bool& displayed) {
    Viewport port = context.port;
    port.em = inherited.font_size;
    return styled(child, inherited, port, displayed);
  });
  text.gather(node, context.style, 0);
  text.trim();
  for (const pugi::xml_node& child : text.unknown) refuse("text", child);
  std::vector<Character>& characters = text.characters;
  if (characters.empty()) return;
  ++painted_;
  Point2 pen{0, 0};
  for (std::size_t i = 0; i < characters.size(); ++i) {
    const Character& c = characters[i];
    if (i == 0 || c.x || c.y) {
      double length = 0;
      for (std::size_t k = i; k < characters.size() && (k == i || !(characters[k].x || characters[k].y)); ++k)
        length += characters[k].advance + (k > i ? characters[k].dx : 0);
      const double before = c.style.anchor == "middle" ? 0.5 : c.style.anchor == "end" ? 1 : 0;
      pen = {c.x.value_or(pen.x) - before * length, c.y.value_or(pen.y)};
    }
    pen += Point2{c.dx, c.dy};
    const Style& style = c.style;
    const std::optional<Paint>& paint = style.fill && style.fill_seen ? style.fill : style.stroke;
    if (!c.blank() && has_paint(paint, node) && style.visible && style.font_size > 0) {
      TextItem item;
      item.text = c.utf8;
      item.height_mm = style.font_size * kCapitalsOfSize;
      item.rotation_degrees = -c.rotate.value_or(0);
      Polylines lines;
      result_.boxes += append_stroke_text(item, lines);
      const Point2 at = pen + Point2{0, style.baseline_em * style.font_size - style.baseline_shift};
      for (Point2& p : lines.points) {
        p = context.to_mm(Point2{p.x * c.stretch, p.y} + at);
        if (!(std::abs(p.x) <= kFarthestMm && std::abs(p.y) <= kFarthestMm))
          throw CoordinateRangeError("is farther than a kilometre away");
      }
      const std::string color = color_of(*paint, node);
      Context inside = context;
      if (inside.layer.empty()) inside.layer = "text";
      add_lines(lines, inside, color, 0);
    }
    pen.x += c.advance;
  }
}

}  // namespace ligne::svg
