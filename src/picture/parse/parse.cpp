#include "picture/parse/parse.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "base/portable.hpp"
#include "files/closest_name.hpp"
#include "files/message_text.hpp"
#include "plotting/devices/pens.hpp"
#include "plotting/page.hpp"

namespace ligne {
namespace {

[[noreturn]] void fail(std::string_view text, const std::string& cause) {
  throw std::invalid_argument((text.empty() ? "an empty text" : shown(text, '"')) + " " + cause);
}

/// Returns the number, or nothing.
std::optional<double> number(std::string_view text) {
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::string with_unit(std::string_view unit) { return unit.empty() ? "" : " " + std::string(unit); }

}  // namespace

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  while (true) {
    const std::size_t end = text.find(separator);
    parts.push_back(text.substr(0, end));
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + 1);
  }
}

std::string list_of(std::span<const std::string_view> names) {
  std::string list;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) list += i + 1 == names.size() ? " or " : ", ";
    list += names[i];
  }
  return list;
}

double parse_number(std::string_view text) {
  const std::optional<double> value = number(text);
  if (!value) fail(text, "is not a number");
  return *value;
}

double parse_positive(std::string_view text) {
  const double value = parse_number(text);
  if (!(value > 0)) throw std::invalid_argument(printable(text) + " is not greater than 0");
  return value;
}

double parse_between(std::string_view text, double low, double high, std::string_view unit) {
  const double value = parse_number(text);
  if (!(value > low && value < high)) {
    throw std::invalid_argument(printable(text) + " is not between " + shortest(low) + " and " + shortest(high) +
                                with_unit(unit));
  }
  return value;
}

double parse_within(std::string_view text, double low, double high, std::string_view unit) {
  const double value = parse_number(text);
  if (!(value >= low && value <= high)) {
    throw std::invalid_argument(printable(text) + " is not from " + shortest(low) + " to " + shortest(high) +
                                with_unit(unit));
  }
  return value;
}

unsigned parse_count(std::string_view text, unsigned low, unsigned high) {
  unsigned value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || value < low || value > high) {
    fail(text, "is not a whole number from " + std::to_string(low) + " to " + std::to_string(high));
  }
  return value;
}

Point3 parse_point(std::string_view text) {
  const std::vector<std::string_view> parts = split(text, ',');
  if (parts.size() != 3) fail(text, "is not three numbers X,Y,Z");
  std::array<double, 3> values{};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::optional<double> value = number(parts[i]);
    if (!value) fail(text, "is not three numbers X,Y,Z");
    values[i] = *value;
  }
  return {values[0], values[1], values[2]};
}

Point3 parse_vector(std::string_view text) {
  const Point3 vector = parse_point(text);
  if (vector == Point3(0, 0, 0)) fail(text, "has no direction");
  return vector;
}

std::size_t parse_choice(std::string_view text, std::span<const std::string_view> names) {
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i] == text) return i;
  }
  fail(text, "is not one of " + list_of(names) + suggestion(text, names));
}

Axis parse_axis(std::string_view text) {
  constexpr std::string_view names[] = {"x", "y", "z"};
  return static_cast<Axis>(parse_choice(text, names));
}

LineClasses parse_edges(std::string_view text) {
  constexpr LineClass kMore[] = {LineClass::profile, LineClass::shadow, LineClass::suggestive,
                                 LineClass::ridge,   LineClass::valley, LineClass::detail};
  std::vector<std::string_view> names(kLineClassNames.begin(), kLineClassNames.begin() + kEdgeClassCount);
  for (const LineClass more : kMore) {
    names.push_back(kLineClassNames[static_cast<std::size_t>(more)]);
  }
  LineClasses classes;
  for (const std::string_view word : split(text, ',')) {
    bool known = false;
    for (const LineClass more : kMore) {
      if (word != kLineClassNames[static_cast<std::size_t>(more)]) continue;
      classes.add(more);
      known = true;
    }
    for (std::size_t i = 0; i < kEdgeClassCount; ++i) {
      const LineClass line_class = static_cast<LineClass>(i);
      const bool in_group = word == "all" || (word == "feature" && line_class != LineClass::mesh);
      if (in_group || word == names[i]) {
        classes.add(line_class);
        known = true;
      }
    }
    if (!known) {
      const std::string list = list_of(names).replace(list_of(names).rfind(" or "), 4, ", ") + ", feature or all";
      names.insert(names.end(), {"feature", "all"});
      fail(word, "is not one of " + list + suggestion(word, names));
    }
  }
  return classes;
}

std::optional<double> parse_scale(std::string_view text) {
  if (text == "fit") return std::nullopt;
  const std::vector<std::string_view> parts = split(text, ':');
  if (parts.size() == 2) {
    const std::optional<double> n = number(parts[0]), m = number(parts[1]);
    if (n && m && *n > 0 && *m > 0 && std::isnormal(*n / *m)) return *n / *m;
  }
  fail(text, "is neither fit nor a ratio N:M, such as 1:50");
}

double parse_unit_mm(std::string_view text) {
  constexpr std::pair<std::string_view, double> units[] = {{"mm", 1}, {"cm", 10}, {"m", 1000}, {"in", kMmPerInch}};
  for (const auto& [name, mm] : units) {
    if (name == text) return mm;
  }
  const std::optional<double> mm = number(text);
  if (!mm || !(*mm > 0)) fail(text, "is neither mm, cm, m, in nor a number of mm above 0");
  return *mm;
}

std::vector<std::string> parse_names(std::string_view text) {
  std::vector<std::string> names(1);
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == ',') {
      names.emplace_back();
      continue;
    }
    names.back() += text[i];
    if (text[i] == '\\' && i + 1 < text.size()) names.back() += text[++i];
  }
  for (const std::string& name : names) {
    if (name.empty()) fail(text, "has an empty name in it");
  }
  return names;
}

PartMove parse_move(std::string_view text) {
  const std::size_t equals = text.rfind('=');
  const auto parts = split(equals == std::string_view::npos ? text : text.substr(equals + 1), ',');
  if (equals == std::string_view::npos || equals == 0 || parts.size() != 3) fail(text, "is not NAME=X,Y,Z");
  PartMove move;
  move.pattern = text.substr(0, equals);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto k = static_cast<Point3::length_type>(i);
    if (const std::optional<double> units = number(parts[i])) {
      move.units[k] = *units;
      continue;
    }
    const bool minus = parts[i].starts_with('-');
    std::string_view size = parts[i].substr(minus ? 1 : 0);
    double factor = minus ? -1 : 1;
    if (size.ends_with('m') && !size.ends_with("mm") && !size.ends_with("cm")) {
      size.remove_suffix(1);
      factor *= 1000;
    }
    try {
      move.mm[k] = factor * parse_length_mm(size);
    } catch (const std::invalid_argument&) {
      fail(parts[i], "is neither a number of model units nor a length in mm, cm, m, in or pt");
    }
  }
  return move;
}

ObjectColor parse_object_color(std::string_view text) {
  const std::size_t equals = text.rfind('=');
  if (equals == std::string_view::npos || equals == 0) fail(text, "is not NAME=COLOUR");
  return {std::string(text.substr(0, equals)), parse_color(text.substr(equals + 1))};
}

OutputFormat parse_format(std::string_view text) {
  return static_cast<OutputFormat>(parse_choice(text, kOutputFormatNames));
}

OutputFormat format_of_suffix(const std::filesystem::path& file) {
  const std::string suffix = lower_case(file.extension().string());
  for (std::size_t i = 0; i < std::size(kOutputFormatNames); ++i) {
    if (suffix == "." + std::string(kOutputFormatNames[i])) return static_cast<OutputFormat>(i);
  }
  constexpr std::pair<std::string_view, OutputFormat> others[] = {{".plt", OutputFormat::hpgl},
                                                                  {".hpg", OutputFormat::hpgl},
                                                                  {".nc", OutputFormat::gcode},
                                                                  {".ngc", OutputFormat::gcode}};
  for (const auto& [other, format] : others) {
    if (suffix == other) return format;
  }
  fail(file.string(), "does not end in .svg, .pdf, .png, .json, .hpgl, .plt, .gcode or .nc, and there is no --format");
}

std::string parse_file_name(const std::string& text) {
  if (text.empty()) throw std::invalid_argument("the name of the file is empty");
  return text;
}

}  // namespace ligne
