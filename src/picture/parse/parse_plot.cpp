#include "picture/parse/parse_plot.hpp"

#include <algorithm>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#include "files/message_text.hpp"
#include "picture/parse/parse.hpp"
#include "plotting/devices/pens.hpp"
#include "plotting/page.hpp"

namespace ligne {
namespace {

/// Splits "NAME=VALUE", which is for the fills of a layer or a colour. "VALUE" alone is for all fills.
std::pair<std::string, std::string> split_name(const std::string& text) {
  const std::size_t equals = text.rfind('=');
  if (equals == std::string::npos) return {"", text};
  return {text.substr(0, equals), text.substr(equals + 1)};
}

/// The code of a colour, which names its layer in a drawing without layers. Other names stay.
std::string layer_or_color(const std::string& name) {
  try {
    return color_code(parse_color(name));
  } catch (const std::invalid_argument&) {
    return name;
  }
}

}  // namespace

void parse_plot_fill(const std::string& text, std::optional<FillReading::How>& reading, StoredPaint& paint) {
  std::vector<std::string_view> words(std::begin(kFillReadingNames), std::end(kFillReadingNames));
  const std::size_t readings = words.size();
  words.insert(words.end(), std::begin(kFillNames) + 1, std::end(kFillNames));  // not none, which is the default
  const std::size_t choice = parse_choice(text, words);
  if (choice < readings) {
    reading = static_cast<FillReading::How>(choice);
  } else {
    paint.kind = static_cast<FillKind>(choice - readings + 1);
  }
}

void parse_material(const std::string& text, StoredPaint& paint) {
  const std::size_t equals = text.rfind('=');
  if (equals == std::string::npos || equals == 0) throw std::invalid_argument(shown(text, '"') + " is not NAME=COLOUR");
  paint.colors[text.substr(0, equals)] = parse_color(text.substr(equals + 1));
}

std::set<std::string> parse_skip(const std::string& text) {
  std::set<std::string> names;
  for (const std::string_view name : split(text, ',')) {
    parse_choice(name, kSkippable);
    names.emplace(name);
  }
  return names;
}

bool parse_own_layer(const std::string& text) {
  constexpr std::string_view kNames[] = {"all", "layer"};
  return parse_choice(text, kNames) == 1;
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

double parse_drawn_length_mm(const std::string& text) {
  constexpr double kMmPerMetre = 1000;
  const bool metres = text.size() > 1 && text.back() == 'm' && text[text.size() - 2] != 'm' && text[text.size() - 2] != 'c';
  const double way =
      metres ? kMmPerMetre * parse_number(std::string_view(text).substr(0, text.size() - 1)) : parse_length_mm(text);
  if (!(way > 0)) throw std::invalid_argument("is not above 0");
  return way;
}

double parse_duration_s(const std::string& text) {
  constexpr double kSixty = 60, kLongestS = 1e9;
  double seconds = 0;
  const std::size_t letter = text.find_first_not_of("0123456789.:");
  const std::string suffix = letter == std::string::npos ? "" : text.substr(letter);
  const std::string numbers = text.substr(0, letter);
  const bool clock = numbers.find(':') != std::string::npos;
  if (clock != suffix.empty() || (!clock && suffix != "s" && suffix != "min" && suffix != "h"))
    throw std::invalid_argument("\"" + text + "\" is not a time such as 90s, 30min, 2h or 12:30");
  for (std::size_t begin = 0; begin <= numbers.size();) {
    const std::size_t end = std::min(numbers.find(':', begin), numbers.size());
    seconds = seconds * kSixty + parse_number(numbers.substr(begin, end - begin));
    begin = end + 1;
  }
  if (suffix == "min") seconds *= kSixty;
  if (suffix == "h") seconds *= kSixty * kSixty;
  if (!(seconds > 0 && seconds <= kLongestS)) throw std::invalid_argument("is not above 0");
  return seconds;
}

PlotSplit parse_split(const std::string& text) {
  constexpr unsigned kMostLifts = 1'000'000'000;
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos) throw std::invalid_argument("is not time=N, distance=N or lifts=N");
  const auto by = static_cast<SplitBy>(parse_choice(text.substr(0, equals), kSplitNames));
  const std::string value = text.substr(equals + 1);
  return {by, by == SplitBy::time       ? parse_duration_s(value)
              : by == SplitBy::distance ? parse_drawn_length_mm(value)
                                        : parse_count(value, 1, kMostLifts)};
}

std::size_t parse_stroke_number(const std::string& text) {
  constexpr unsigned kMostStrokes = 4'000'000'000;
  return parse_count(text, 1, kMostStrokes);
}

std::array<unsigned, 2> parse_grid(const std::string& text) {
  constexpr unsigned kMost = 100;
  const std::size_t x = text.find('x');
  if (x == std::string::npos) throw std::invalid_argument("is not CxR, columns and rows, such as 2x3");
  return {parse_count(text.substr(0, x), 1, kMost), parse_count(text.substr(x + 1), 1, kMost)};
}

}  // namespace ligne
