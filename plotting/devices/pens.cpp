#include "plotting/devices/pens.hpp"

#include <fnmatch.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>

#include "files/message_text.hpp"
#include "plotting/color_names.hpp"
#include "plotting/page.hpp"

namespace ligne {
namespace {

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
  Pen pen;
  pen.number = number;
  return pen;
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
