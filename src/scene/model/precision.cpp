#include "scene/model/precision.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "base/parallel.hpp"

namespace ligne {
namespace {

/// Number of significant digits below which numbers count as written by hand: the default of printf's %g and of C++
/// streams.
constexpr int kFewestDigitsOfWriters = 6;

// Evidence that decimal numbers are float32 numbers. Adjustable.
/// Least number of significant digits, and of units of the last one in a unit in the last place of a float32: other numbers
/// are those of a float32 by accident, as one in four is here.
constexpr int kFewestDigitsOfFloat32 = 8;
constexpr double kStepsPerUlp = 8;
/// Multiples of 1/1024 are float32 numbers, however they were made.
constexpr double kStepsByHand = 1024;
/// Least number of such numbers, and the number from which on no more are compared.
constexpr int kFewestFloat32 = 32, kMostFloat32 = 4096;

// Evidence that coordinates were rounded to a decimal grid. Adjustable.
/// Least step of the grid in units in the last place of a float32 at the largest coordinate, so that few numbers lie on it
/// by accident.
constexpr double kLeastStepInUlps = 64;
/// Largest distance of a coordinate from the grid, in the same unit: files that were moved or scaled in float32 after
/// their coordinates were rounded to the grid have a few roundings more.
constexpr double kMostUlpsOffGrid = 2;
/// Most steps per unit: six decimals.
constexpr double kMostPerUnit = 1e6;
/// Least number of different coordinates, and the largest fraction of them whose last decimal is 0: 1/10 if they are spread
/// evenly.
constexpr std::size_t kFewestRounded = 64;
constexpr double kMostOnCoarserGrid = 0.25;
/// Number of positions of the sample.
constexpr std::size_t kSampled = 256;
/// Least extent of the coordinates in steps of the grid. Voxels and grids of heights have fewer steps.
constexpr double kLeastExtentInSteps = 2000;

/// Half a unit in the last of `digits` binary digits of a number.
double half_ulp(double largest, int digits, int smallest_exponent) {
  if (largest == 0 || !std::isfinite(largest)) return 0;
  const int exponent = std::max(std::ilogb(largest) + 1, smallest_exponent);
  return std::ldexp(0.5, exponent - digits);
}

/// Steps per model unit of the coarsest decimal grid that holds all coordinates.
std::optional<double> grid_of(std::span<const Point3> positions) {
  const auto larger = [](double a, double b) { return std::max(a, b); };
  const double largest = parallel_reduce(
      positions.size(), kShortWorkBlock, 0.0,
      [&](std::size_t begin, std::size_t end) {
        double most = 0;
        for (const Point3& p : positions.subspan(begin, end - begin))
          most = std::max({most, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
        return most;
      },
      larger);
  const double ulp = 2 * half_ulp_float32(largest), finest = std::min(1 / (kLeastStepInUlps * ulp), kMostPerUnit);
  const double per_unit = parallel_reduce(
      positions.size(), kShortWorkBlock, 10.0,
      [&](std::size_t begin, std::size_t end) {
        double steps = 10;
        for (const Point3& p : positions.subspan(begin, end - begin)) {
          for (int axis = 0; axis < 3; ++axis) {
            while (steps <= finest && std::abs(p[axis] - std::round(p[axis] * steps) / steps) > kMostUlpsOffGrid * ulp)
              steps *= 10;
          }
          if (!(steps <= finest)) break;
        }
        return steps;
      },
      larger);
  if (!(per_unit <= finest)) return std::nullopt;
  return per_unit;
}

/// The different steps of all coordinates, ascending. A grid that grid_of() finds has up to 2^19 of them, since the largest
/// coordinate has 2^24 units in the last place.
std::vector<std::int64_t> steps_of(std::span<const Point3> positions, double per_unit) {
  struct Range {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    Range operator+(const Range& o) const { return {std::min(low, o.low), std::max(high, o.high)}; }
  };
  const auto step = [&](double coordinate) { return std::llround(coordinate * per_unit); };
  const Range range = parallel_reduce(positions.size(), kShortWorkBlock, Range{}, [&](std::size_t begin, std::size_t end) {
    Range own;
    for (const Point3& p : positions.subspan(begin, end - begin))
      own = own + Range{std::min({p.x, p.y, p.z}), std::max({p.x, p.y, p.z})};
    return own;
  });
  std::vector<std::int64_t> steps;
  if (positions.empty()) return steps;
  const std::int64_t first = step(range.low), count = step(range.high) - first + 1;
  constexpr std::size_t kParts = 16;
  const std::size_t part = positions.size() / kParts + 1;
  std::vector<std::vector<std::uint8_t>> is_taken(block_count(positions.size(), part));  // per part and step
  parallel_blocks(positions.size(), part, [&](std::size_t begin, std::size_t end) {
    std::vector<std::uint8_t>& own = is_taken[begin / part];
    own.assign(static_cast<std::size_t>(count), 0);
    for (const Point3& p : positions.subspan(begin, end - begin)) {
      for (int axis = 0; axis < 3; ++axis) own[static_cast<std::size_t>(step(p[axis]) - first)] = 1;
    }
  });
  for (std::int64_t i = 0; i < count; ++i) {
    if (std::ranges::any_of(is_taken, [i](const auto& own) { return own[static_cast<std::size_t>(i)] != 0; }))
      steps.push_back(first + i);
  }
  return steps;
}

}  // namespace

int significant_digits(std::string_view word) {
  int digits = 0;
  bool fraction = false;
  for (const char c : word) {
    if (c >= '0' && c <= '9') {
      digits += digits > 0 || c != '0';
      continue;
    }
    fraction = fraction || c == '.' || c == 'e' || c == 'E';
    if (c == 'e' || c == 'E') break;
  }
  return fraction ? digits : 0;
}

double half_ulp_float32(double largest) {
  using Float = std::numeric_limits<float>;
  return half_ulp(largest, Float::digits, Float::min_exponent);
}

double half_ulp_double(double largest) {
  using Double = std::numeric_limits<double>;
  return half_ulp(largest, Double::digits, Double::min_exponent);
}

double decimal_grid(std::span<const Point3> positions) {
  // A sample shows for most files that there is no grid.
  std::vector<Point3> sample;
  const std::size_t stride = positions.size() / kSampled + 1;
  for (std::size_t i = 0; i < positions.size(); i += stride) sample.push_back(positions[i]);
  if (!grid_of(sample)) return 0;
  const std::optional<double> per_unit = grid_of(positions);
  if (!per_unit) return 0;
  const std::vector<std::int64_t> steps = steps_of(positions, *per_unit);
  if (steps.size() < kFewestRounded || double(steps.back() - steps.front()) < kLeastExtentInSteps) return 0;
  const auto coarser = std::ranges::count_if(steps, [](std::int64_t n) { return n % 10 == 0; });
  if (double(coarser) > kMostOnCoarserGrid * double(steps.size())) return 0;
  // Coordinates that were doubled or multiplied by five after they were rounded have a coarser step.
  const auto all_divide = [&](std::int64_t by) {
    return std::ranges::all_of(steps, [by](std::int64_t n) { return n % by == 0; });
  };
  return (all_divide(2) ? 2 : all_divide(5) ? 5 : 1) * 0.5 / *per_unit;
}

void DecimalPrecision::add(int digits, double value) {
  largest_ = std::max(largest_, std::abs(value));
  most_digits_ = std::max(most_digits_, digits);
  const bool is_open = may_be_float32_ && float32_numbers_ < kMostFloat32;
  if (is_open && digits >= kFewestDigitsOfFloat32 && largest_ < std::numeric_limits<float>::max()) {
    check_float32(digits, value);
  }
}

void DecimalPrecision::check_float32(int digits, double value) {
  const double step = std::pow(10.0, std::floor(std::log10(std::abs(value))) + 1 - digits);
  const double by_hand = value * kStepsByHand;
  if (!(kStepsPerUlp * step <= 2 * half_ulp_float32(value)) || by_hand == std::round(by_hand)) return;
  may_be_float32_ = std::abs(value - static_cast<double>(static_cast<float>(value))) <= step;
  ++float32_numbers_;
}

double DecimalPrecision::value() const {
  const double stored = half_ulp_double(largest_);
  if (largest_ == 0 || most_digits_ < kFewestDigitsOfWriters) return stored;
  if (may_be_float32_ && float32_numbers_ >= kFewestFloat32) return half_ulp_float32(largest_);
  const double exponent = std::floor(std::log10(largest_));
  return std::max(stored, 0.5 * std::pow(10.0, exponent + 1 - most_digits_));
}

}  // namespace ligne
