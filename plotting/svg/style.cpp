#include "plotting/svg/style.hpp"

#include <algorithm>
#include <stdexcept>

namespace ligne::svg {
namespace {

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t\n\r\f";
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

bool is_zero(std::string_view text) {
  Scanner scanner(text);
  return scanner.number() == 0;
}

class StyleReader {
 public:
  StyleReader(const pugi::xml_node& node, Style& style, bool& displayed, const Refuse& refuse)
      : node_(node), style_(style), displayed_(displayed), refuse_(refuse) {}

  void set(std::string_view name, std::string_view value) {
    if (value == "inherit") return;
    if (name == "stroke") set_paint(style_.stroke, value);
    else if (name == "fill") set_paint(style_.fill, value);
    else if (name == "color") style_.color = paint(value).value_or("#000000");
    else if (name == "stroke-opacity") style_.stroke_seen = !is_zero(value);
    else if (name == "fill-opacity") style_.fill_seen = !is_zero(value);
    else if (name == "opacity") displayed_ = displayed_ && !is_zero(value);
    else if (name == "display") displayed_ = displayed_ && value != "none";
    else if (name == "visibility") style_.visible = value == "visible";
    else if (name == "stroke-width") style_.stroke_width = length_px(value);
    else if (name == "stroke-dashoffset") style_.dash_offset = length_px(value);
    else if (name == "stroke-dasharray") set_dashes(value);
    else if (name == "font-size") set_font_size(value);
    else if (name == "text-anchor") style_.anchor = value;
    else if (value == "none") return;
    else if (name == "clip-path" || name == "mask" || name == "filter") refuse_(name, node_);
    else if (name.starts_with("marker")) refuse_("marker", node_);
    else if (name == "writing-mode") refuse_("text", node_);
  }

  /// "name: value; name: value".
  void set_list(std::string_view text) {
    while (!text.empty()) {
      const std::size_t end = std::min(text.find(';'), text.size());
      const std::string_view entry = text.substr(0, end);
      text.remove_prefix(std::min(end + 1, text.size()));
      const std::size_t colon = entry.find(':');
      if (colon == std::string_view::npos) continue;
      const std::string_view name = trimmed(entry.substr(0, colon));
      std::string_view value = trimmed(entry.substr(colon + 1));
      if (const std::size_t mark = value.find('!'); mark != std::string_view::npos) value = trimmed(value.substr(0, mark));
      // As an attribute it has been read where elements are placed; as a property it would come too late.
      if (name == "transform") refuse_("style", node_);
      set(name, value);
    }
  }

 private:
  void set_paint(std::optional<std::string>& target, std::string_view value) {
    if (value.starts_with("url(")) {
      refuse_("paint", node_);
      return;
    }
    target = paint(value);
    // Resolved where it is written, as CSS has it, but after `color` of the same element: see style_of.
    if (target == "currentColor") target = style_.color;
  }
  void set_dashes(std::string_view value) {
    style_.dashes.clear();
    if (value == "none") return;
    Scanner scanner(value);
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
    Scanner scanner(value);
    if (!scanner.at_number()) return refuse_("text", node_);  // "medium", "larger"
    if (value.ends_with("em")) {
      style_.font_size *= scanner.number();
    } else {
      style_.font_size = length_px(value, style_.font_size);
    }
  }

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

Style style_of(const pugi::xml_node& node, const Style& inherited, bool& displayed, const Refuse& refuse) {
  Style style = inherited;
  StyleReader reader(node, style, displayed, refuse);
  if (const pugi::xml_attribute color = node.attribute("color")) reader.set("color", trimmed(color.value()));
  for (const pugi::xml_attribute& attribute : node.attributes()) {
    const std::string_view name = attribute.name();
    if (name == "class" || name == "style" || name == "color") continue;
    try {
      reader.set(name, trimmed(attribute.value()));
    } catch (const std::invalid_argument& e) {
      throw std::invalid_argument(std::string(name) + ": " + e.what());
    }
  }
  try {
    reader.set_list(node.attribute("style").value());
  } catch (const std::invalid_argument& e) {
    throw std::invalid_argument(std::string("style: ") + e.what());
  }
  return style;
}

}  // namespace ligne::svg
