#include "plotting/svg/style/style.hpp"
#include "files/message_text.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <utility>

#include "plotting/svg/style/placing.hpp"

namespace ligne::svg {
namespace {

/// An opacity from 0 to 1; 1 if the text is invalid.
double opacity_of(std::string_view text) {
  Scanner scanner(text);
  if (!scanner.at_number()) return 1;
  const double value = scanner.number();
  return std::clamp(scanner.peek() == '%' ? value / 100 : value, 0.0, 1.0);
}

/// Whether var() is resolved in values of the property: in those that affect lines. Others have texts, or do not affect
/// lines.
bool takes_variables(std::string_view name) {
  constexpr std::string_view kBeginnings[] = {"fill",    "stroke",     "stop-",     "color",     "opacity",
                                              "display", "visibility", "font-size", "transform", "letter-spacing"};
  return std::ranges::any_of(kBeginnings, [&](std::string_view beginning) { return name.starts_with(beginning); });
}

class StyleReader {
 public:
  StyleReader(const pugi::xml_node& node, Style& style, const Viewport& port, bool& displayed,
              const Diagnostics& diagnostics)
      : overflow_around_(std::exchange(style.overflow, {})),
        node_(node),
        style_(style),
        port_(port),
        displayed_(displayed),
        diagnostics_(diagnostics) {}

  /// Sets a property if it is known. An invalid value is reported and ignored.
  void set(std::string_view name, std::string_view value, bool is_attribute) {
    try {
      if (value.find("var(") == std::string_view::npos || !takes_variables(name))
        return set_known(name, value, is_attribute);
      const std::optional<std::string> own = resolved(value, style_.variables);
      if (!own) fail_value(value, "refers to nothing");
      set_known(name, trimmed(*own), is_attribute);
    } catch (const std::invalid_argument& e) {
      diagnostics_.bad_value(name, node_, e.what());
    }
  }
  /// Combines the properties that place the element, after all have been set.
  void finish() { style_.placing = together(placing_); }

 private:
  void set_known(std::string_view name, std::string_view value, bool is_attribute) {
    if (name == "overflow" && value == "inherit") {
      style_.overflow = overflow_around_.value_or(true);
      return;
    }
    constexpr std::string_view kInherited[] = {"inherit", "unset", "revert", "revert-layer"};
    if (std::ranges::find(kInherited, value) != std::end(kInherited)) return;
    if (const Setter set = setter_of(name)) return set(*this, value);
    // A text that its program has broken into lines has them as elements with places of their own.
    if ((name == "shape-inside" || name == "inline-size") && node_.child("tspan").attribute("y")) return;
    if (name == "shape-inside" && !(style_.text_box = id_in(value)).empty()) return;
    if (set_of_place(name, value, is_attribute) || value == "none" || value == "normal" || value == "auto") return;
    if (name == "clip-path")
      set_clip(value);
    else if (name == "mask")
      style_.mask = id_in(value);
    else if (name == "filter")
      diagnostics_.refuse(name, node_);
    else if (name == "writing-mode")
      need_rows(value);
    else if (changes_what_is_drawn(name, value, is_attribute))
      fail_value(value, "can not be drawn");
  }

  bool set_of_place(std::string_view name, std::string_view value, bool is_attribute) {
    if (name == "transform")
      placing_.transform = transform(value, is_attribute ? nullptr : &port_);
    else if (!is_attribute && (name == "translate" || name == "rotate" || name == "scale"))
      set_placing(placing_, name, value, port_);
    else if (name == "transform-box")
      style_.origin_of_box = value == "fill-box" || value == "content-box" || value == "stroke-box" || value == "border-box";
    else if (name == "marker" && !is_attribute)  // no attribute, by SVG 1.1, 11.6.2
      for (std::size_t place = 0; place < style_.markers.size(); ++place) set_marker(place, value);
    else
      return false;
    return true;
  }
  using Text = std::string_view;
  using Setter = void (*)(StyleReader& r, Text value);
  /// Sets a property, alike by an attribute and by a style sheet; null for other names.
  static Setter setter_of(std::string_view name) {
    static constexpr std::pair<std::string_view, Setter> kSetters[] = {
        {"stroke", [](StyleReader& r, Text v) { r.set_paint(r.style_.stroke, v); }},
        {"fill", [](StyleReader& r, Text v) { r.set_paint(r.style_.fill, v); }},
        {"color", [](StyleReader& r, Text v) { r.style_.color = paint(v).value_or("#000000"); }},
        {"stop-color",
         [](StyleReader& r, Text v) { r.style_.stop_color = paint(v) == "currentColor" ? r.style_.color : paint(v); }},
        {"stroke-opacity", [](StyleReader& r, Text v) { r.style_.stroke_seen = opacity_of(v) > 0; }},
        {"fill-opacity", [](StyleReader& r, Text v) { r.set_fill_opacity(opacity_of(v)); }},
        {"stop-opacity", [](StyleReader& r, Text v) { r.style_.stop_opacity = opacity_of(v); }},
        {"mix-blend-mode", [](StyleReader& r, Text v) { r.style_.blended = v != "normal"; }},
        {"paint-order", [](StyleReader& r, Text v) { r.set_paint_order(v); }},
        {"opacity", [](StyleReader& r, Text v) { r.show(r.none_, (r.style_.opacity = opacity_of(v)) == 0); }},
        {"stroke-width", [](StyleReader& r, Text v) { r.set_stroke_width(r.length(v, r.port_.diagonal())); }},
        {"stroke-dashoffset", [](StyleReader& r, Text v) { r.style_.dash_offset = r.length(v, r.port_.diagonal()); }},
        {"stroke-dasharray", [](StyleReader& r, Text v) { r.set_dashes(v); }},
        {"fill-rule", [](StyleReader& r, Text v) { r.style_.fill_even_odd = v == "evenodd"; }},
        {"stroke-linecap", [](StyleReader& r, Text v) { r.style_.round_caps = v != "butt"; }},
        {"vector-effect", [](StyleReader& r, Text v) { r.set_vector_effect(v); }},
        {"font-size", [](StyleReader& r, Text v) { r.set_font_size(v); }},
        {"font", [](StyleReader& r, Text v) { r.set_font(v); }},
        {"font-family", [](StyleReader& r, Text v) { r.set_family(v); }},
        {"line-height", [](StyleReader& r, Text v) { r.set_line_height(v); }},
        {"text-anchor", [](StyleReader& r, Text v) { r.style_.anchor = v; }},
        {"letter-spacing", [](StyleReader& r, Text v) { r.style_.letter_spacing = r.spacing(v); }},
        {"word-spacing", [](StyleReader& r, Text v) { r.style_.word_spacing = r.spacing(v); }},
        {"dominant-baseline", [](StyleReader& r, Text v) { r.set_baseline(v); }},
        {"alignment-baseline", [](StyleReader& r, Text v) { r.set_baseline(v); }},
        {"baseline-shift", [](StyleReader& r, Text v) { r.set_baseline_shift(v); }},
        {"xml:space", [](StyleReader& r, Text v) { r.style_.keep_blanks = v == "preserve"; }},
        {"white-space",
         [](StyleReader& r, Text v) { r.style_.keep_blanks = v == "pre" || v == "pre-wrap" || v == "break-spaces"; }},
        {"display", [](StyleReader& r, Text v) { r.show(v == "none", r.clear_); }},
        {"visibility", [](StyleReader& r, Text v) { r.style_.visible = v == "visible"; }},
        {"clip-rule", [](StyleReader& r, Text v) { r.style_.clip_even_odd = v == "evenodd"; }},
        {"mask-type", [](StyleReader& r, Text v) { r.style_.alpha_mask = v == "alpha"; }},
        {"overflow", [](StyleReader& r, Text v) { r.style_.overflow = v == "visible" || v == "auto"; }},
        {"transform-origin", [](StyleReader& r, Text v) { r.style_.origin = v; }},
        {"marker-start", [](StyleReader& r, Text v) { r.set_marker(0, v); }},
        {"marker-mid", [](StyleReader& r, Text v) { r.set_marker(1, v); }},
        {"marker-end", [](StyleReader& r, Text v) { r.set_marker(2, v); }},
    };
    const auto known = std::ranges::find(kSetters, name, [](const auto& setter) { return setter.first; });
    return known == std::end(kSetters) ? nullptr : known->second;
  }
  void set_marker(std::size_t place, std::string_view value) { style_.markers[place] = value == "none" ? "" : id_in(value); }
  /// Sets a colour, or "url(#id)" with a fallback colour behind it.
  void set_paint(std::optional<Paint>& target, std::string_view value) {
    if (value == "context-fill" || value == "context-stroke") {
      target = value == "context-fill" ? style_.context_fill : style_.context_stroke;
      return;
    }
    if (value == "initial") {
      target = (&target == &style_.fill ? Style{}.fill : std::nullopt);
      return;
    }
    // icc-color(), for a press, stands behind the colour for screens (SVG 1.1, 11.2).
    value = trimmed(value.substr(0, value.find("icc-color(")));
    std::string server;
    if (value.starts_with("url(")) {
      const std::size_t end = std::min(value.find(')'), value.size());
      server = id_in(value.substr(0, std::min(end + 1, value.size())));
      value = trimmed(value.substr(std::min(end + 1, value.size())));
    }
    std::optional<std::string> color;
    if (!value.empty()) color = paint(value);
    // currentColor is resolved where it is written, as in CSS, but after `color` of the same element: see style_of.
    if (color == "currentColor") color = style_.color;
    target.reset();
    if (color || !server.empty()) target = Paint{color.value_or(""), server, color_opacity(value)};
  }
  /// Parts that are not named follow in the usual order (SVG 2, 13.8).
  void set_paint_order(std::string_view value) {
    constexpr std::pair<std::string_view, PaintPart> kParts[] = {
        {"fill", PaintPart::fill}, {"stroke", PaintPart::stroke}, {"markers", PaintPart::markers}};
    style_.paint_order = Style{}.paint_order;
    auto behind = style_.paint_order.begin();
    while (!(value = trimmed(value)).empty()) {
      const std::string_view word = value.substr(0, std::min(value.find_first_of(kBlanks), value.size()));
      value.remove_prefix(word.size());
      const auto known = std::ranges::find(kParts, word, [](const auto& part) { return part.first; });
      if (known == std::end(kParts)) return;
      const auto at = std::find(behind, style_.paint_order.end(), known->second);
      if (at != style_.paint_order.end()) std::rotate(behind++, at, at + 1);
    }
  }
  void set_vector_effect(std::string_view value) {
    style_.non_scaling = value == "non-scaling-stroke";
    if (!style_.non_scaling && value != "none") fail_value(value, "can not be drawn");
  }
  void set_stroke_width(double width) {
    if (width < 0) throw std::invalid_argument("a stroke has a negative width");
    style_.stroke_width = width;
  }
  void set_fill_opacity(double opacity) {
    style_.fill_seen = opacity > 0;
    style_.fill_opacity = opacity;
  }
  /// A length in user units, where em is the size of the element's own font.
  double length(std::string_view value, double whole) const {
    Viewport port = port_;
    port.em = style_.font_size;
    return length_px(value, port, whole);
  }
  double spacing(std::string_view value) const { return value == "normal" ? 0 : length(value, style_.font_size); }
  /// Sets a baseline that CSS names, from the single-stroke letters: the heights of capitals and of lower case, and the
  /// depth of descenders, em.
  void set_baseline(std::string_view value) {
    constexpr double kCapitals = 0.73, kLowerCase = 0.52, kBelow = 0.21;
    if (value == "middle")
      style_.baseline_em = kLowerCase / 2;
    else if (value == "central" || value == "mathematical")
      style_.baseline_em = kCapitals / 2;
    else if (value == "hanging" || value.starts_with("text-before") || value == "text-top" || value == "before-edge")
      style_.baseline_em = kCapitals;
    else if (value.starts_with("text-after") || value == "ideographic" || value == "text-bottom" || value == "after-edge")
      style_.baseline_em = -kBelow;
    else
      style_.baseline_em = 0;
  }
  void set_baseline_shift(std::string_view value) {
    constexpr double kSub = -0.2, kSuper = 0.4;
    style_.baseline_shift = value == "sub"        ? kSub * style_.font_size
                            : value == "super"    ? kSuper * style_.font_size
                            : value == "baseline" ? 0
                                                  : length(value, style_.font_size);
  }
  void set_dashes(std::string_view value) {
    std::vector<double> dashes;
    double sum = 0;
    while (value != "none" && !value.empty()) {
      const std::size_t end = std::min(value.find_first_of(" ,\t\n\r\f"), value.size());
      if (end > 0) dashes.push_back(length(value.substr(0, end), port_.diagonal()));
      value.remove_prefix(std::min(end + 1, value.size()));
    }
    for (const double dash : dashes) {
      if (dash < 0) throw std::invalid_argument("a dash has a negative length");
      sum += dash;
    }
    style_.dashes = sum > 0 ? std::move(dashes) : std::vector<double>();
  }
  void set_font_size(std::string_view value) {
    // Sizes of CSS Fonts 3, px.
    constexpr std::pair<std::string_view, double> kSizes[] = {
        {"xx-small", 9}, {"x-small", 10}, {"small", 13}, {"medium", 16}, {"large", 18}, {"x-large", 24}, {"xx-large", 32}};
    constexpr double kLarger = 1.2;
    Scanner scanner(value);
    if (scanner.at_number()) {
      style_.font_size = length(value, style_.font_size);
      return;
    }
    if (value == "larger") style_.font_size *= kLarger;
    if (value == "smaller") style_.font_size /= kLarger;
    for (const auto& [name, px] : kSizes) {
      if (name == value) style_.font_size = px;
    }
  }

  void set_line_height(std::string_view value) {
    const bool of_font = Scanner(value.substr(value.empty() ? 0 : value.size() - 1)).at_number();  // without a unit
    if (value == "normal")
      style_.line_em = Style{}.line_em;
    else if (style_.font_size > 0)
      style_.line_em = length(value, style_.font_size) / (of_font ? 1 : style_.font_size);
  }
  /// Reads "italic 10px serif": the size is the first word that begins with a number, up to a slash.
  void set_font(std::string_view value) {
    while (!value.empty()) {
      value = trimmed(value);
      const std::string_view word = value.substr(0, std::min(value.find(' '), value.size()));
      value.remove_prefix(word.size());
      Scanner scanner(word);
      const bool weight = word.size() == 3 && word.find_first_not_of("0123456789") == std::string_view::npos;
      if (!scanner.at_number() || weight) continue;
      set_family(value);
      return set_font_size(word.substr(0, word.find('/')));
    }
  }
  /// Sets the widths of the first family with a known word in its name.
  void set_family(std::string_view families) {
    static constexpr std::pair<Text, TypefaceWidth> kWords[] = {
        {"mono", {1, 0.6}},      {"courier", {1, 0.6}}, {"consolas", {1, 0.55}}, {"narrow", {0.72, 0}},
        {"condensed", {0.8, 0}}, {"dejavu", {1, 0}},    {"verdana", {1, 0}},     {"sans", {}},
        {"arial", {}},           {"helvetica", {}},     {"times", {0.8, 0}},     {"serif", {0.8, 0}},
        {"roman", {0.8, 0}},     {"garamond", {0.8, 0}}};
    style_.typeface = {};
    for (std::string left = lower_case(families); !left.empty();) {
      const std::string family = left.substr(0, left.find(','));
      left.erase(0, family.size() + 1);
      for (const auto& [word, width] : kWords)
        if (family.find(word) != std::string::npos) return void(style_.typeface = width);
    }
  }
  /// "url(#id)", with or without quotes.
  void set_clip(std::string_view value) {
    style_.clip = id_in(value);
    if (style_.clip.empty()) diagnostics_.refuse("clip-path", node_);
  }
  /// "id" of "url(#id)"; empty when it is something else.
  static std::string id_in(std::string_view value) {
    if (!value.starts_with("url(") || !value.ends_with(")")) return {};
    value = trimmed(value.substr(4, value.size() - 5));
    if (value.size() >= 2 && (value.front() == '"' || value.front() == '\'') && value.back() == value.front())
      value = value.substr(1, value.size() - 2);
    return value.starts_with('#') ? std::string(value.substr(1)) : std::string();
  }
  static void need_rows(std::string_view mode) {
    constexpr std::string_view kRows[] = {"lr-tb", "lr", "horizontal-tb"};
    if (std::ranges::find(kRows, mode) == std::end(kRows)) fail_value(mode, "is not from left to right");
  }
  void show(bool none, bool clear) {
    none_ = none;
    clear_ = clear;
    style_.displayed = !none;
    displayed_ = !none && !clear;
  }

  bool none_ = false, clear_ = false;
  Placing placing_;
  std::optional<bool> overflow_around_;  ///< overflow of the parent
  const pugi::xml_node& node_;
  Style& style_;
  const Viewport& port_;
  bool& displayed_;
  const Diagnostics& diagnostics_;
};

/// A property of an element with its value; lists of them go from the weakest to the strongest.
struct DeclaredProperty {
  std::string_view name, value;
  bool is_attribute = false;
};

std::vector<DeclaredProperty> declared_properties(const pugi::xml_node& node, const std::vector<const Declaration*>& rules,
                                                  const std::vector<Declaration>& own) {
  std::vector<DeclaredProperty> all;
  for (const pugi::xml_attribute attribute : node.attributes()) {
    const std::string_view name = attribute.name();
    if (name != "class" && name != "style" && name != "font") all.push_back({name, trimmed(attribute.value()), true});
  }
  for (const bool important : {false, true}) {
    for (const Declaration* rule : rules) {
      if (rule->important == important) all.push_back({rule->name, rule->value});
    }
    for (const Declaration& declaration : own) {
      if (declaration.important == important) all.push_back({declaration.name, declaration.value});
    }
  }
  return all;
}

}  // namespace

Style style_of(const pugi::xml_node& node, const Style& inherited, const StyleSheet& sheet, const Viewport& port,
               bool& displayed, const Diagnostics& diagnostics) {
  Style style = inherited;
  style.origin.clear();
  style.origin_of_box = false;
  style.clip.clear();
  style.mask.clear();
  style.text_box.clear();
  style.non_scaling = style.blended = false;
  style.displayed = true;
  style.opacity = 1;
  style.stop_color.reset();
  style.stop_opacity = 1;
  style.baseline_shift = 0;
  StyleReader reader(node, style, port, displayed, diagnostics);
  std::vector<Declaration> own;
  if (const pugi::xml_attribute attribute = node.attribute("style")) own = declarations(attribute.value());
  const std::vector<const Declaration*> rules = sheet.empty() ? std::vector<const Declaration*>() : sheet.of(node);
  const std::vector<DeclaredProperty> all = declared_properties(node, rules, own);
  std::map<std::string, std::string, std::less<>> variables;
  for (const DeclaredProperty& property : all) {
    if (property.name.starts_with("--") && !property.is_attribute)
      variables.insert_or_assign(std::string(property.name), property.value);
  }
  if (!variables.empty()) style.variables = with_variables(style.variables, std::move(variables));
  // The colour and the size of the font are set first, since currentColor and em refer to them.
  const auto is_first = [](const DeclaredProperty& property) {
    return property.name == "color" || property.name.starts_with("font");
  };
  for (const DeclaredProperty& property : all) {
    if (is_first(property)) reader.set(property.name, property.value, property.is_attribute);
  }
  for (const DeclaredProperty& property : all) {
    if (!is_first(property)) reader.set(property.name, property.value, property.is_attribute);
  }
  reader.finish();
  return style;
}

}  // namespace ligne::svg
