#include "picture/parse_plot.hpp"

#include <algorithm>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "picture/parse.hpp"
#include "plotting/page.hpp"
#include "plotting/pens.hpp"

namespace ligne {
namespace {

/// "VALUE" for all fills, "NAME=VALUE" for those of a layer or a colour.
std::pair<std::string, std::string> split_name(const std::string& text) {
  const std::size_t equals = text.rfind('=');
  if (equals == std::string::npos) return {"", text};
  return {text.substr(0, equals), text.substr(equals + 1)};
}

/// A colour by its code, as the layers of a drawing without layers are named; another name as it stands.
std::string layer_or_color(const std::string& name) {
  try {
    return color_code(parse_color(name));
  } catch (const std::invalid_argument&) {
    return name;
  }
}

}  // namespace

FillReading::How parse_fill_reading(const std::string& text) {
  return static_cast<FillReading::How>(parse_choice(text, kFillReadingNames));
}

std::set<std::string> parse_skip(const std::string& text) {
  std::set<std::string> names;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string name = text.substr(begin, end - begin);
    parse_choice(name, kSkippable);
    names.insert(name);
    begin = end + 1;
  }
  return names;
}

bool parse_fill_tone(const std::string& text) {
  constexpr std::string_view kNames[] = {"plain", "shade"};
  return parse_choice(text, kNames) == 1;
}

void add_hatch_spacing(FillHatches& hatches, const std::string& text) {
  const auto [name, value] = split_name(text);
  const double spacing = parse_length_mm(value);
  if (!(spacing > 0)) throw std::invalid_argument("is not above 0");
  if (name.empty()) {
    hatches.all.spacing_mm = spacing;
  } else {
    hatches.spacing_mm_of[layer_or_color(name)] = spacing;
  }
}

void add_hatch_angle(FillHatches& hatches, const std::string& text) {
  const auto [name, value] = split_name(text);
  const double degrees = parse_number(value);
  if (name.empty()) {
    hatches.all.angle_degrees = degrees;
  } else {
    hatches.degrees_of[layer_or_color(name)] = degrees;
  }
}

void add_hatch_cross(FillHatches& hatches, const std::string& name) {
  if (name.empty()) {
    hatches.all.cross = true;
  } else {
    hatches.crossed.insert(layer_or_color(name));
  }
}

}  // namespace ligne
