#include "plotting/devices/pens.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <stdexcept>

#include <fnmatch.h>

#include "files/message_text.hpp"
#include "plotting/page.hpp"

namespace ligne {
namespace {

/// CSS Color 4, 6.1, by name.
constexpr std::pair<std::string_view, std::uint32_t> kColors[] = {{"aliceblue", 0xf0f8ff},
                                                                  {"antiquewhite", 0xfaebd7},
                                                                  {"aqua", 0x00ffff},
                                                                  {"aquamarine", 0x7fffd4},
                                                                  {"azure", 0xf0ffff},
                                                                  {"beige", 0xf5f5dc},
                                                                  {"bisque", 0xffe4c4},
                                                                  {"black", 0x000000},
                                                                  {"blanchedalmond", 0xffebcd},
                                                                  {"blue", 0x0000ff},
                                                                  {"blueviolet", 0x8a2be2},
                                                                  {"brown", 0xa52a2a},
                                                                  {"burlywood", 0xdeb887},
                                                                  {"cadetblue", 0x5f9ea0},
                                                                  {"chartreuse", 0x7fff00},
                                                                  {"chocolate", 0xd2691e},
                                                                  {"coral", 0xff7f50},
                                                                  {"cornflowerblue", 0x6495ed},
                                                                  {"cornsilk", 0xfff8dc},
                                                                  {"crimson", 0xdc143c},
                                                                  {"cyan", 0x00ffff},
                                                                  {"darkblue", 0x00008b},
                                                                  {"darkcyan", 0x008b8b},
                                                                  {"darkgoldenrod", 0xb8860b},
                                                                  {"darkgray", 0xa9a9a9},
                                                                  {"darkgreen", 0x006400},
                                                                  {"darkgrey", 0xa9a9a9},
                                                                  {"darkkhaki", 0xbdb76b},
                                                                  {"darkmagenta", 0x8b008b},
                                                                  {"darkolivegreen", 0x556b2f},
                                                                  {"darkorange", 0xff8c00},
                                                                  {"darkorchid", 0x9932cc},
                                                                  {"darkred", 0x8b0000},
                                                                  {"darksalmon", 0xe9967a},
                                                                  {"darkseagreen", 0x8fbc8f},
                                                                  {"darkslateblue", 0x483d8b},
                                                                  {"darkslategray", 0x2f4f4f},
                                                                  {"darkslategrey", 0x2f4f4f},
                                                                  {"darkturquoise", 0x00ced1},
                                                                  {"darkviolet", 0x9400d3},
                                                                  {"deeppink", 0xff1493},
                                                                  {"deepskyblue", 0x00bfff},
                                                                  {"dimgray", 0x696969},
                                                                  {"dimgrey", 0x696969},
                                                                  {"dodgerblue", 0x1e90ff},
                                                                  {"firebrick", 0xb22222},
                                                                  {"floralwhite", 0xfffaf0},
                                                                  {"forestgreen", 0x228b22},
                                                                  {"fuchsia", 0xff00ff},
                                                                  {"gainsboro", 0xdcdcdc},
                                                                  {"ghostwhite", 0xf8f8ff},
                                                                  {"gold", 0xffd700},
                                                                  {"goldenrod", 0xdaa520},
                                                                  {"gray", 0x808080},
                                                                  {"green", 0x008000},
                                                                  {"greenyellow", 0xadff2f},
                                                                  {"grey", 0x808080},
                                                                  {"honeydew", 0xf0fff0},
                                                                  {"hotpink", 0xff69b4},
                                                                  {"indianred", 0xcd5c5c},
                                                                  {"indigo", 0x4b0082},
                                                                  {"ivory", 0xfffff0},
                                                                  {"khaki", 0xf0e68c},
                                                                  {"lavender", 0xe6e6fa},
                                                                  {"lavenderblush", 0xfff0f5},
                                                                  {"lawngreen", 0x7cfc00},
                                                                  {"lemonchiffon", 0xfffacd},
                                                                  {"lightblue", 0xadd8e6},
                                                                  {"lightcoral", 0xf08080},
                                                                  {"lightcyan", 0xe0ffff},
                                                                  {"lightgoldenrodyellow", 0xfafad2},
                                                                  {"lightgray", 0xd3d3d3},
                                                                  {"lightgreen", 0x90ee90},
                                                                  {"lightgrey", 0xd3d3d3},
                                                                  {"lightpink", 0xffb6c1},
                                                                  {"lightsalmon", 0xffa07a},
                                                                  {"lightseagreen", 0x20b2aa},
                                                                  {"lightskyblue", 0x87cefa},
                                                                  {"lightslategray", 0x778899},
                                                                  {"lightslategrey", 0x778899},
                                                                  {"lightsteelblue", 0xb0c4de},
                                                                  {"lightyellow", 0xffffe0},
                                                                  {"lime", 0x00ff00},
                                                                  {"limegreen", 0x32cd32},
                                                                  {"linen", 0xfaf0e6},
                                                                  {"magenta", 0xff00ff},
                                                                  {"maroon", 0x800000},
                                                                  {"mediumaquamarine", 0x66cdaa},
                                                                  {"mediumblue", 0x0000cd},
                                                                  {"mediumorchid", 0xba55d3},
                                                                  {"mediumpurple", 0x9370db},
                                                                  {"mediumseagreen", 0x3cb371},
                                                                  {"mediumslateblue", 0x7b68ee},
                                                                  {"mediumspringgreen", 0x00fa9a},
                                                                  {"mediumturquoise", 0x48d1cc},
                                                                  {"mediumvioletred", 0xc71585},
                                                                  {"midnightblue", 0x191970},
                                                                  {"mintcream", 0xf5fffa},
                                                                  {"mistyrose", 0xffe4e1},
                                                                  {"moccasin", 0xffe4b5},
                                                                  {"navajowhite", 0xffdead},
                                                                  {"navy", 0x000080},
                                                                  {"oldlace", 0xfdf5e6},
                                                                  {"olive", 0x808000},
                                                                  {"olivedrab", 0x6b8e23},
                                                                  {"orange", 0xffa500},
                                                                  {"orangered", 0xff4500},
                                                                  {"orchid", 0xda70d6},
                                                                  {"palegoldenrod", 0xeee8aa},
                                                                  {"palegreen", 0x98fb98},
                                                                  {"paleturquoise", 0xafeeee},
                                                                  {"palevioletred", 0xdb7093},
                                                                  {"papayawhip", 0xffefd5},
                                                                  {"peachpuff", 0xffdab9},
                                                                  {"peru", 0xcd853f},
                                                                  {"pink", 0xffc0cb},
                                                                  {"plum", 0xdda0dd},
                                                                  {"powderblue", 0xb0e0e6},
                                                                  {"purple", 0x800080},
                                                                  {"rebeccapurple", 0x663399},
                                                                  {"red", 0xff0000},
                                                                  {"rosybrown", 0xbc8f8f},
                                                                  {"royalblue", 0x4169e1},
                                                                  {"saddlebrown", 0x8b4513},
                                                                  {"salmon", 0xfa8072},
                                                                  {"sandybrown", 0xf4a460},
                                                                  {"seagreen", 0x2e8b57},
                                                                  {"seashell", 0xfff5ee},
                                                                  {"sienna", 0xa0522d},
                                                                  {"silver", 0xc0c0c0},
                                                                  {"skyblue", 0x87ceeb},
                                                                  {"slateblue", 0x6a5acd},
                                                                  {"slategray", 0x708090},
                                                                  {"slategrey", 0x708090},
                                                                  {"snow", 0xfffafa},
                                                                  {"springgreen", 0x00ff7f},
                                                                  {"steelblue", 0x4682b4},
                                                                  {"tan", 0xd2b48c},
                                                                  {"teal", 0x008080},
                                                                  {"thistle", 0xd8bfd8},
                                                                  {"tomato", 0xff6347},
                                                                  {"turquoise", 0x40e0d0},
                                                                  {"violet", 0xee82ee},
                                                                  {"wheat", 0xf5deb3},
                                                                  {"white", 0xffffff},
                                                                  {"whitesmoke", 0xf5f5f5},
                                                                  {"yellow", 0xffff00},
                                                                  {"yellowgreen", 0x9acd32}};

/// The colour of a CSS name in lower case, as 0xrrggbb; nothing if there is no such name.
std::optional<std::uint32_t> color_named(std::string_view name) {
  const auto found = std::ranges::lower_bound(kColors, name, {}, [](const auto& color) { return color.first; });
  if (found == std::end(kColors) || found->first != name) return {};
  return found->second;
}

std::array<double, 3> of_code(std::uint32_t code) {
  return {(code >> 16 & 255u) / 255.0, (code >> 8 & 255u) / 255.0, (code & 255u) / 255.0};
}

unsigned parse_pen_number(std::string_view text) {
  unsigned number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size() || number < 1 || number > kMostPens) {
    throw std::invalid_argument(shown(text, '"') + " is not the number of a pen, 1 to " + std::to_string(kMostPens));
  }
  return number;
}

unsigned parse_shade(std::string_view text) {
  if (text.size() != 1 || text[0] < '1' || text[0] > static_cast<char>('0' + kMostPenShades)) {
    throw std::invalid_argument(shown(text, '"') + " is not a shade, 1 (the darkest) to " + std::to_string(kMostPenShades));
  }
  return static_cast<unsigned>(text[0] - '0');
}

}  // namespace

std::string color_code(const std::array<double, 3>& color) {
  constexpr std::string_view digits = "0123456789abcdef";
  std::string code = "#";
  for (const double level : color) {
    const auto whole = static_cast<unsigned>(std::lround(level * 255));
    code += digits[whole / 16];
    code += digits[whole % 16];
  }
  return code;
}

std::array<double, 3> parse_color(std::string_view text) {
  if (text.starts_with('#') && (text.size() == 4 || text.size() == 7)) {
    std::uint32_t code = 0;
    const auto [end, error] = std::from_chars(text.data() + 1, text.data() + text.size(), code, 16);
    if (error == std::errc() && end == text.data() + text.size()) {
      if (text.size() == 7) return of_code(code);
      return of_code((code >> 8) * 0x110000 + (code >> 4 & 15) * 0x1100 + (code & 15) * 0x11);
    }
  }
  if (const auto code = color_named(text)) return of_code(*code);
  throw std::invalid_argument(shown(text, '"') + " is not a colour: #rrggbb, or a name such as red");
}

std::string layer_label(const Pen& pen) {
  if (!pen.label.empty()) return pen.label;
  std::string label;
  if (pen.skip) label += '%';
  if (pen.pause) label += '!';
  label += std::to_string(pen.number);
  if (pen.speed) label += "+S" + std::to_string(*pen.speed);
  if (pen.height) label += "+H" + std::to_string(*pen.height);
  if (pen.delay_ms) label += "+D" + std::to_string(*pen.delay_ms);
  if (!pen.name.empty()) label += " " + pen.name;
  return label;
}

LayerLabel parse_layer_label(std::string_view text) {
  LayerLabel label;
  const auto skip_blanks = [&text] { text.remove_prefix(std::min(text.find_first_not_of(" \t"), text.size())); };
  const auto take_number = [&text]() -> std::optional<unsigned> {
    unsigned value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc()) return {};
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return value;
  };
  for (skip_blanks(); !text.empty() && (text[0] == '%' || text[0] == '!'); skip_blanks()) {
    (text[0] == '%' ? label.skip : label.pause) = true;
    text.remove_prefix(1);
  }
  const std::string_view unnumbered = text;
  const unsigned number = take_number().value_or(0);
  if (number <= kMostPens) {
    label.number = number;
  } else {
    text = unnumbered;
  }
  while (text.size() > 2 && text[0] == '+' && text[2] >= '0' && text[2] <= '9') {
    const char key = text[1];
    std::optional<unsigned>* const setting = key == 'S' || key == 's'   ? &label.speed
                                             : key == 'H' || key == 'h' ? &label.height
                                             : key == 'D' || key == 'd' ? &label.delay_ms
                                                                        : nullptr;
    if (!setting) break;
    text.remove_prefix(2);
    const std::optional<unsigned> value = take_number();
    if (!value) break;
    const bool known = setting == &label.speed    ? *value > 0 && *value <= kMostPercent
                       : setting == &label.height ? *value <= kMostPercent
                                                  : *value <= kMostDelayMs;
    if (known) *setting = value;
  }
  skip_blanks();
  label.name = text;
  return label;
}

std::optional<unsigned> PenTable::named_pen_of(std::string_view layer, std::string_view material, unsigned shade,
                                               const std::string& object) const {
  if (const auto found = pen_of_shade.find(shade); shade > 0 && found != pen_of_shade.end()) return found->second;
  if (!object.empty()) {
    const auto found = std::find_if(pen_of_object.rbegin(), pen_of_object.rend(),
                                    [&](const auto& entry) { return fnmatch(entry.first.c_str(), object.c_str(), 0) == 0; });
    if (found != pen_of_object.rend()) return found->second;
  }
  if (const auto found = pen_of_material.find(material); !material.empty() && found != pen_of_material.end())
    return found->second;
  if (const auto found = pen_of_layer.find(layer); found != pen_of_layer.end()) return found->second;
  return {};
}

unsigned PenTable::pen_of(std::string_view layer, std::string_view material, unsigned shade,
                          const std::string& object) const {
  if (const auto named = named_pen_of(layer, material, shade, object)) return *named;
  const unsigned number = parse_layer_label(layer).number;
  return number > 0 && !names_rest ? number : rest;
}

Pen PenTable::pen(unsigned number) const {
  if (const auto found = pens.find(number); found != pens.end()) return found->second;
  return {.number = number};
}

void add_pen(PenTable& table, std::string_view text) {
  const std::size_t equals = text.rfind('=');
  if (equals == std::string_view::npos || equals == 0) {
    throw std::invalid_argument(shown(text, '"') + " is not CLASS=N, CLASS=N,COLOUR or CLASS=N,COLOUR,WIDTH");
  }
  const std::string_view layer = text.substr(0, equals);
  std::string_view rest = text.substr(equals + 1);
  const auto next = [&rest] {
    const std::size_t comma = rest.find(',');
    const std::string_view part = rest.substr(0, comma);
    rest = comma == std::string_view::npos ? std::string_view{} : rest.substr(comma + 1);
    return part;
  };
  const unsigned number = parse_pen_number(next());
  Pen& pen = table.pens[number];
  pen.number = number;
  if (!rest.empty()) pen.color = parse_color(next());
  if (!rest.empty()) {
    const double width = parse_length_mm(rest);
    if (!(width > 0)) throw std::invalid_argument("the width of pen " + std::to_string(number) + " is not above 0");
    pen.width_mm = width;
  }
  constexpr std::string_view kObject = "object:", kMaterial = "material:", kShade = "shade:";
  if (layer == "rest") {
    table.rest = number;
    table.names_rest = true;
  } else if (layer.starts_with(kShade)) {
    table.pen_of_shade[parse_shade(layer.substr(kShade.size()))] = number;
  } else if (layer.starts_with(kObject)) {
    table.pen_of_object.emplace_back(layer.substr(kObject.size()), number);
  } else if (layer.starts_with(kMaterial)) {
    table.pen_of_material[std::string(layer.substr(kMaterial.size()))] = number;
  } else {
    table.pen_of_layer[std::string(layer)] = number;
    if (pen.name.empty()) pen.name = layer;
  }
}

}  // namespace ligne
