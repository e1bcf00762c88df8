#include "plotting/svg/style.hpp"

#include <algorithm>
#include <initializer_list>
#include <stdexcept>

namespace ligne::svg {
namespace {

/// From 0 to 1; what has no meaning says nothing.
double opacity_of(std::string_view text) {
  Scanner scanner(text);
  if (!scanner.at_number()) return 1;
  const double value = scanner.number();
  return std::clamp(scanner.peek() == '%' ? value / 100 : value, 0.0, 1.0);
}

class StyleReader {
 public:
  StyleReader(const pugi::xml_node& node, Style& style, bool& displayed, const Refuse& refuse)
      : node_(node), style_(style), displayed_(displayed), refuse_(refuse) {}

  void set(std::string_view name, std::string_view value) {
    if (value == "inherit" || set_of_paint(name, value) || set_of_text(name, value)) return;
    if (name == "display")
      show(value == "none", clear_);
    else if (name == "visibility")
      style_.visible = value == "visible";
    else if (name == "clip-rule")
      style_.clip_even_odd = value == "evenodd";
    else if (name == "overflow")
      style_.overflow = value == "visible" || value == "auto";
    else if (name.starts_with("marker-"))
      set_markers(name, value);
    else if (value == "none" || value == "normal" || value == "auto")
      return;
    else if (name == "clip-path")
      set_clip(value);
    else if (name == "mask")
      style_.mask = id_in(value);
    else if (name == "filter")
      refuse_(name, node_);
    else if (name == "transform-origin")
      refuse_origin(value);
    else if (name == "writing-mode")
      refuse_unless(value, {"lr-tb", "lr", "horizontal-tb"});
  }

  /// A property of a style sheet or a style attribute.
  void set_property(const StyleSheet::Declaration& declaration) {
    if (declaration.name == "marker") set_markers("marker", declaration.value);  // no attribute, by SVG 1.1, 11.6.2
    // As an attribute it has been read where elements are placed; as a property it would come too late.
    if (declaration.name == "transform") refuse_("style", node_);
    set(declaration.name, declaration.value);
  }

 private:
  /// Paint and lines. False for other names; so for the next.
  bool set_of_paint(std::string_view name, std::string_view value) {
    if (name == "stroke")
      set_paint(style_.stroke, value);
    else if (name == "fill")
      set_paint(style_.fill, value);
    else if (name == "color")
      style_.color = paint(value).value_or("#000000");
    else if (name == "stop-color")
      style_.stop_color = paint(value) == "currentColor" ? style_.color : paint(value);
    else if (name == "stroke-opacity")
      style_.stroke_seen = opacity_of(value) > 0;
    else if (name == "fill-opacity")
      set_fill_opacity(opacity_of(value));
    else if (name == "opacity")
      show(none_, (style_.opacity = opacity_of(value)) == 0);
    else if (name == "stroke-width")
      style_.stroke_width = length_px(value);
    else if (name == "stroke-dashoffset")
      style_.dash_offset = length_px(value);
    else if (name == "stroke-dasharray")
      set_dashes(value);
    else if (name == "fill-rule")
      style_.fill_even_odd = value == "evenodd";
    else if (name == "stroke-linecap")
      style_.round_caps = value != "butt";
    else if (name == "vector-effect")
      style_.non_scaling = value == "non-scaling-stroke";
    else
      return false;
    return true;
  }
  bool set_of_text(std::string_view name, std::string_view value) {
    if (name == "font-size")
      set_font_size(value);
    else if (name == "font")
      set_font(value);
    else if (name == "text-anchor")
      style_.anchor = value;
    else if (name == "letter-spacing")
      style_.letter_spacing = spacing(value);
    else if (name == "word-spacing")
      style_.word_spacing = spacing(value);
    else if (name == "dominant-baseline" || name == "alignment-baseline")
      set_baseline(value);
    else if (name == "baseline-shift")
      set_baseline_shift(value);
    else if (name == "xml:space")
      style_.keep_blanks = value == "preserve";
    else if (name == "white-space")
      style_.keep_blanks = value == "pre" || value == "pre-wrap" || value == "break-spaces";
    else
      return false;
    return true;
  }
  void set_markers(std::string_view name, std::string_view value) {
    constexpr std::string_view kNames[] = {"marker-start", "marker-mid", "marker-end"};
    const std::string id = value == "none" ? "" : id_in(value);
    for (std::size_t i = 0; i < style_.markers.size(); ++i) {
      if (name == "marker" || name == kNames[i]) style_.markers[i] = id;
    }
  }
  /// A colour, or "url(#id)" with a colour behind it for those that do not find it.
  void set_paint(std::optional<Paint>& target, std::string_view value) {
    if (value == "context-fill" || value == "context-stroke") {
      target = value == "context-fill" ? style_.context_fill : style_.context_stroke;
      return;
    }
    std::string server;
    if (value.starts_with("url(")) {
      const std::size_t end = std::min(value.find(')'), value.size());
      server = id_in(value.substr(0, std::min(end + 1, value.size())));
      value = trimmed(value.substr(std::min(end + 1, value.size())));
    }
    std::optional<std::string> color;
    if (!value.empty()) color = paint(value);
    // Resolved where it is written, as CSS has it, but after `color` of the same element: see style_of.
    if (color == "currentColor") color = style_.color;
    target.reset();
    if (color || !server.empty()) target = Paint{color.value_or(""), server};
  }
  void set_fill_opacity(double opacity) {
    style_.fill_seen = opacity > 0;
    style_.fill_opacity = opacity;
  }
  double spacing(std::string_view value) const { return value == "normal" ? 0 : length_px(value, {}, style_.font_size); }
  /// What CSS calls its base lines, by those of the letters at hand: capitals, the lower case, and what hangs below.
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
                                                  : length_px(value, style_.font_size, style_.font_size);
  }
  void set_dashes(std::string_view value) {
    style_.dashes.clear();
    Scanner scanner(value);
    if (!scanner.at_number()) return;  // "none", and what has no meaning
    double sum = 0;
    while (!scanner.done()) {
      const double dash = scanner.number();
      scanner.word();
      if (dash < 0) throw std::invalid_argument("a dash is shorter than nothing");
      style_.dashes.push_back(dash);
      sum += dash;
      scanner.skip_separator();
    }
    if (sum == 0) style_.dashes.clear();
  }
  void set_font_size(std::string_view value) {
    // CSS Fonts 3, in px.
    constexpr std::pair<std::string_view, double> kSizes[] = {
        {"xx-small", 9}, {"x-small", 10}, {"small", 13}, {"medium", 16}, {"large", 18}, {"x-large", 24}, {"xx-large", 32}};
    constexpr double kLarger = 1.2;
    Scanner scanner(value);
    if (scanner.at_number()) {
      style_.font_size = length_px(value, style_.font_size, style_.font_size);
      return;
    }
    if (value == "larger") style_.font_size *= kLarger;
    if (value == "smaller") style_.font_size /= kLarger;
    for (const auto& [name, px] : kSizes) {
      if (name == value) style_.font_size = px;
    }
  }

  /// "italic 10px serif": the size is the first word that begins with a number, up to a slash.
  void set_font(std::string_view value) {
    while (!value.empty()) {
      value = trimmed(value);
      const std::string_view word = value.substr(0, std::min(value.find(' '), value.size()));
      value.remove_prefix(word.size());
      Scanner scanner(word);
      const bool weight = word.size() == 3 && word.find_first_not_of("0123456789") == std::string_view::npos;
      if (scanner.at_number() && !weight) return set_font_size(word.substr(0, word.find('/')));
    }
  }
  /// "url(#id)", with or without quotes.
  void set_clip(std::string_view value) {
    style_.clip = id_in(value);
    if (style_.clip.empty()) refuse_("clip-path", node_);
  }
  /// "id" of "url(#id)"; empty when it is something else.
  static std::string id_in(std::string_view value) {
    if (!value.starts_with("url(") || !value.ends_with(")")) return {};
    value = trimmed(value.substr(4, value.size() - 5));
    if (value.size() >= 2 && (value.front() == '"' || value.front() == '\'') && value.back() == value.front())
      value = value.substr(1, value.size() - 2);
    return value.starts_with('#') ? std::string(value.substr(1)) : std::string();
  }
  /// Transforms are taken about the origin of the units.
  void refuse_origin(std::string_view value) {
    constexpr std::string_view kOrigins[] = {"0", "0 0", "0px 0px", "0px", "0% 0%", "left top", "top left"};
    if (node_.attribute("transform") && std::ranges::find(kOrigins, value) == std::end(kOrigins)) refuse_("style", node_);
  }
  void refuse_unless(std::string_view value, std::initializer_list<std::string_view> plain) {
    if (std::find(plain.begin(), plain.end(), value) == plain.end()) refuse_("text", node_);
  }
  void show(bool none, bool clear) {
    none_ = none;
    clear_ = clear;
    displayed_ = !none && !clear;
  }

  bool none_ = false, clear_ = false;
  const pugi::xml_node& node_;
  Style& style_;
  bool& displayed_;
  const Refuse& refuse_;
};

}  // namespace

std::string_view local_name(const pugi::xml_node& node) {
  const std::string_view name = node.name();
  const std::size_t colon = name.find(':');
  return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

Style style_of(const pugi::xml_node& node, const Style& inherited, const StyleSheet& sheet, bool& displayed,
               const Refuse& refuse) {
  Style style = inherited;
  style.clip.clear();
  style.mask.clear();
  style.overflow = style.non_scaling = false;
  style.opacity = 1;
  style.stop_color.reset();
  style.baseline_shift = 0;
  StyleReader reader(node, style, displayed, refuse);
  const std::vector<const StyleSheet::Declaration*> rules =
      sheet.empty() ? std::vector<const StyleSheet::Declaration*>() : sheet.of(node);
  std::vector<StyleSheet::Declaration> own;
  if (const pugi::xml_attribute attribute = node.attribute("style")) own = declarations(attribute.value());
  // What currentColor means is settled first: by the strongest that says so.
  if (const pugi::xml_attribute color = node.attribute("color")) reader.set("color", trimmed(color.value()));
  const auto each_property = [&](auto&& what) {
    for (const bool important : {false, true}) {
      for (const StyleSheet::Declaration* rule : rules) {
        if (rule->important == important) what(*rule);
      }
      for (const StyleSheet::Declaration& declaration : own) {
        if (declaration.important == important) what(declaration);
      }
    }
  };
  each_property([&](const StyleSheet::Declaration& d) {
    if (d.name == "color") reader.set(d.name, d.value);
  });
  for (const pugi::xml_attribute attribute : node.attributes()) {
    const std::string_view name = attribute.name();
    if (name == "class" || name == "style" || name == "color" || name == "font") continue;
    try {
      reader.set(name, trimmed(attribute.value()));
    } catch (const std::invalid_argument& e) {
      throw std::invalid_argument(std::string(name) + ": " + e.what());
    }
  }
  try {
    each_property([&](const StyleSheet::Declaration& d) { reader.set_property(d); });
  } catch (const std::invalid_argument& e) {
    throw std::invalid_argument(std::string("style: ") + e.what());
  }
  return style;
}

}  // namespace ligne::svg
