#include "picture/parse/parse_terrain.hpp"

#include <algorithm>
#include <stdexcept>
#include <string_view>

#include "picture/parse/parse.hpp"
#include "plotting/devices/pens.hpp"

namespace ligne {
namespace {

constexpr std::string_view kLabelNames[] = {"none", "index", "all"}, kWaterFillNames[] = {"blank", "hatch"},
                           kHachureNames[] = {"none", "contour", "slope"};
constexpr unsigned kMostIndex = 1000, kMostBands = 1000, kMostContours = 10'000;
constexpr double kLowestSun = 1;  ///< degrees; horizontal light makes no shades

}  // namespace

ContourLabels parse_contour_labels(const std::string& text) {
  return text.empty() ? ContourLabels::index : static_cast<ContourLabels>(parse_choice(text, kLabelNames));
}

unsigned parse_index_contours(const std::string& text) { return parse_count(text, 0, kMostIndex); }

void parse_water(const std::string& text, TerrainRequest& terrain) {
  if (text == "nodata") {
    terrain.water_at_holes = true;
  } else {
    terrain.water = parse_number(text);
  }
}

WaterFill parse_water_fill(const std::string& text) { return static_cast<WaterFill>(parse_choice(text, kWaterFillNames)); }

HachureKind parse_hachures(const std::string& text) { return static_cast<HachureKind>(parse_choice(text, kHachureNames)); }

void parse_sun(const std::string& text, TerrainRequest& terrain) {
  const std::size_t colon = text.find(':');
  terrain.sun_azimuth = parse_number(text.substr(0, colon));
  if (colon != std::string::npos) terrain.sun_altitude = parse_within(text.substr(colon + 1), kLowestSun, 90, "degrees");
}

std::vector<std::string> parse_words(const std::string& text) {
  std::vector<std::string> names{""};
  for (const char c : text) {
    if (c == ',') {
      names.emplace_back();
    } else {
      names.back() += c;
    }
  }
  return names;
}

std::vector<std::array<double, 3>> parse_colors(const std::string& text) {
  std::vector<std::array<double, 3>> colors;
  for (const std::string& color : parse_words(text)) colors.push_back(parse_color(color));
  return colors;
}

void parse_contours(const std::string& text, CurveRequest& curves) {
  constexpr std::string_view kEven = ":even";
  curves.contour_heights.clear();
  curves.even_contours = text.ends_with(kEven);
  if (text.find(',') == std::string::npos) {
    curves.contours =
        parse_count(curves.even_contours ? text.substr(0, text.size() - kEven.size()) : text, 1, kMostContours);
    return;
  }
  for (const std::string& word : parse_words(text)) {
    if (!word.empty()) curves.contour_heights.push_back(parse_number(word));
  }
  std::vector<double>& heights = curves.contour_heights;
  std::sort(heights.begin(), heights.end());
  heights.erase(std::unique(heights.begin(), heights.end()), heights.end());
  if (heights.empty() || heights.size() > kMostContours) throw std::invalid_argument("1 to 10000 heights, Z,Z,...");
  curves.contours = static_cast<unsigned>(heights.size());
}

BandRequest parse_bands(const std::string& text) {
  const std::vector<std::string> words = parse_words(text);
  if (words.size() == 1) return {parse_count(text, 1, kMostBands), {}};
  BandRequest bands;
  for (const std::string& word : words) bands.limits.push_back(parse_number(word));
  std::sort(bands.limits.begin(), bands.limits.end());
  return bands;
}

}  // namespace ligne
