#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "files/message_text.hpp"
#include "plotting/devices/pens.hpp"
#include "plotting/svg/style/css_text.hpp"
#include "plotting/svg/values.hpp"

namespace ligne::svg {
namespace {

/// "hsl(210, 50%, 40%)", with "deg", slashes and an opacity or without.
std::optional<std::string> hsl(std::string_view text) {
  const std::size_t open = text.find('(');
  if (!text.ends_with(')')) fail_value(text, "is not a known colour");
  Scanner scanner(text.substr(open + 1, text.size() - open - 2));
  std::array<double, 4> values{0, 0, 0, 1};
  for (std::size_t i = 0; i < values.size() && !scanner.done(); ++i) {
    if (scanner.peek() == '/') scanner.take();
    scanner.skip_blanks();
    values[i] = scanner.number();
    const bool percent = scanner.peek() == '%';
    if (percent) scanner.take();
    const std::string_view unit = scanner.word();
    if (!unit.empty() && unit != "deg") fail_value(text, "is not a known colour");
    if (i == 3 && percent) values[i] /= 100;
    scanner.skip_separator();
  }
  if (values[3] == 0) return std::nullopt;
  const double hue = values[0] - 360 * std::floor(values[0] / 360), full = std::clamp(values[1], 0.0, 100.0) / 100,
               light = std::clamp(values[2], 0.0, 100.0) / 100;
  // CSS Color 3, 4.2.4.
  const auto level = [&](double n) {
    const double k = std::fmod(n + hue / 30, 12), a = full * std::min(light, 1 - light);
    return light - a * std::max(-1.0, std::min({k - 3, 9 - k, 1.0}));
  };
  return color_code({level(0), level(8), level(4)});
}

/// "rgb(1, 2, 3)", "rgba(10%, 20%, 30%, 0.5)", "rgb(1 2 3 / 50%)".
std::optional<std::string> rgb(std::string_view text) {
  const std::size_t open = text.find('(');
  Scanner scanner(text.substr(open + 1, text.size() - open - 2));
  const auto level = [&](double full) {
    scanner.skip_separator();
    if (scanner.peek() == '/') scanner.take();
    scanner.skip_blanks();
    const double value = scanner.number();
    const bool percent = scanner.peek() == '%';
    if (percent) scanner.take();
    return std::clamp(value / (percent ? 100 : full), 0.0, 1.0);
  };
  std::array<double, 3> levels{};
  for (double& one : levels) one = level(255);
  if (!scanner.done() && level(1) == 0) return std::nullopt;
  return color_code(levels);
}

}  // namespace

std::optional<std::string> paint(std::string_view text) {
  const std::string_view clean = trimmed(text);
  if (clean == "none" || clean == "transparent") return std::nullopt;
  if (clean == "currentColor" || clean == "currentcolor") return "currentColor";
  // Paper is light, so the first of the two colours holds.
  constexpr std::string_view kLightDark = "light-dark(";
  if (clean.starts_with(kLightDark)) {
    const std::string_view inside = clean.substr(kLightDark.size());
    return paint(inside.substr(0, find_outside(inside, ",)")));
  }
  // A code with an opacity behind the colour.
  if (clean.starts_with('#') && (clean.size() == 5 || clean.size() == 9)) {
    const std::size_t digits = clean.size() == 5 ? 1 : 2;
    const bool clear = clean.substr(clean.size() - digits).find_first_not_of('0') == std::string_view::npos;
    return clear ? std::nullopt : paint(clean.substr(0, clean.size() - digits));
  }
  if (clean.starts_with("hsl(") || clean.starts_with("hsla(")) return hsl(clean);
  if ((clean.starts_with("rgb(") || clean.starts_with("rgba(")) && clean.ends_with(")")) return rgb(clean);
  try {
    return color_code(parse_color(lower_case(clean)));  // names of colours in SVG do not depend on case
  } catch (const std::invalid_argument&) {
    // Other names of colours stay: they name layers.
    if (!clean.empty() &&
        std::all_of(clean.begin(), clean.end(), [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }))
      return std::string(clean);
    fail_value(clean, "is not a known colour");
  }
}

double color_opacity(std::string_view text) {
  const std::string_view clean = trimmed(text);
  if (clean.starts_with('#') && (clean.size() == 5 || clean.size() == 9)) {
    const std::string digits(clean.substr(clean.size() == 5 ? 4 : 7));
    const double full = clean.size() == 5 ? 15 : 255;
    return digits.find_first_not_of("0123456789abcdefABCDEF") == std::string::npos
               ? static_cast<double>(std::stoul(digits, nullptr, 16)) / full
               : 1;
  }
  const std::size_t open = clean.find('(');
  if (open == std::string_view::npos || !clean.ends_with(')')) return 1;
  const std::string_view list = clean.substr(open + 1, clean.size() - open - 2);
  const std::size_t slash = list.find('/'), last = slash == std::string_view::npos ? list.rfind(',') : slash;
  if (slash == std::string_view::npos && std::ranges::count(list, ',') != 3) return 1;
  Scanner scanner(trimmed(list.substr(last + 1)));
  if (!scanner.at_number()) return 1;
  const double value = scanner.number();
  return std::clamp(scanner.peek() == '%' ? value / 100 : value, 0.0, 1.0);
}

double brightness(const std::string& color) {
  try {
    const std::array<double, 3> rgb = parse_color(color);
    return 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2];  // ITU-R BT.709
  } catch (const std::invalid_argument&) {
    return 0;
  }
}

}  // namespace ligne::svg
