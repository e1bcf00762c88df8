// Tiles of the Shuttle Radar Topography Mission: a square of big-endian 16-bit heights in metres, from north to south,
// over one degree of latitude and longitude, with samples on both ends. There is no header; the name gives the
// position.

#include <cmath>
#include <limits>

#include "scene/readers/text_lines.hpp"
#include "scene/surfaces/grids/grid_formats.hpp"
#include "scene/surfaces/held_heights.hpp"

namespace ligne {
namespace {

constexpr std::int16_t kVoid = -32768;

struct Corner {
  double longitude, latitude;
};

/// The south-west corner in a name such as "N47E008.hgt".
std::optional<Corner> corner_in(std::string_view name) {
  const std::size_t slash = name.find_last_of('/');
  if (slash != std::string_view::npos) name.remove_prefix(slash + 1);
  if (name.size() < 11 || !equal_ignoring_case(name.substr(name.size() - 4), ".hgt")) return {};
  const auto degrees = [&](std::size_t at, std::size_t digits, char plus, char minus) -> std::optional<double> {
    const bool negative = equal_ignoring_case(name.substr(at, 1), std::string_view(&minus, 1));
    if (!negative && !equal_ignoring_case(name.substr(at, 1), std::string_view(&plus, 1))) return {};
    double value = 0;
    for (const char c : name.substr(at + 1, digits)) {
      if (c < '0' || c > '9') return {};
      value = 10 * value + (c - '0');
    }
    return negative ? -value : value;
  };
  const auto latitude = degrees(0, 2, 'N', 'S'), longitude = degrees(3, 3, 'E', 'W');
  if (!latitude || !longitude) return {};
  return Corner{*longitude, *latitude};
}

}  // namespace

bool is_hgt_name(std::string_view name) {
  return name.size() >= 4 && equal_ignoring_case(name.substr(name.size() - 4), ".hgt");
}

std::unique_ptr<HeightSource> read_hgt_grid(std::span<const std::byte> bytes, const std::string& name, Warnings&) {
  const auto corner = corner_in(name);
  if (!corner) throw InputError(name, "has no position: the name of an SRTM tile gives it, such as N47E008.hgt");
  const auto side = static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(bytes.size()) / 2)));
  if (side < 2 || 2 * side * side != bytes.size()) {
    throw InputError(name, "has " + std::to_string(bytes.size()) + " bytes, which is not a square of two-byte heights");
  }
  std::vector<float> heights(side * side);
  for (std::size_t k = 0; k < heights.size(); ++k) {
    const auto high = static_cast<unsigned>(bytes[2 * k]), low = static_cast<unsigned>(bytes[2 * k + 1]);
    const auto height = static_cast<std::int16_t>(static_cast<std::uint16_t>(high << 8 | low));
    heights[k] = height == kVoid ? std::numeric_limits<float>::quiet_NaN() : height;
  }
  std::vector<double> x(side), y(side);
  for (std::size_t i = 0; i < side; ++i) {
    const double part = static_cast<double>(i) / static_cast<double>(side - 1);
    x[i] = corner->longitude + part;
    y[i] = corner->latitude + part;
  }
  std::unique_ptr<HeightSource> source =
      held_heights(std::move(x), std::move(y), std::move(heights), SampleOrder::first_row_highest(side, side), name);
  source->set_unit(GroundUnit::degrees);
  return source;
}

}  // namespace ligne
