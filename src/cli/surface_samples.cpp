#include "cli/surface_samples.hpp"

#include <algorithm>
#include <utility>

#include "cli/models.hpp"

namespace ligne {
namespace {

constexpr unsigned kCurves = 40;
/// Samples between two neighbouring curves when nothing is said: smooth, but no more than a thousand along a curve for its own sake.
constexpr unsigned kSamplesBetween = 5, kSamplesAlong = 1000;

/// Positions of the samples, and every how many there is a curve.
struct Positions {
  std::vector<double> at;
  std::size_t stride = 1;
};

/// `crossed`: whether curves run along this axis and need samples between those of the other family.
Positions positions(const std::optional<CurveRange>& given, bool crossed, const std::optional<unsigned>& samples) {
  const CurveRange range = given.value_or(CurveRange{});
  const unsigned intervals = range.curves.value_or(kCurves) - 1;
  Positions result;
  if (crossed && samples) {
    result.stride = std::max(1u, (*samples - 1 + intervals - 1) / intervals);
  } else if (crossed) {
    result.stride = std::clamp(kSamplesAlong / intervals, 1u, kSamplesBetween);
  }
  const std::size_t n = result.stride * intervals;
  for (std::size_t i = 0; i <= n; ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(n);
    result.at.push_back(i == n ? range.to : range.from + t * (range.to - range.from));
  }
  return result;
}

}  // namespace

Surface surface_of(const SurfaceOptions& options) {
  const bool x_curves = options.lines != CurveFamilies::y, y_curves = options.lines != CurveFamilies::x;
  Surface surface;
  if (!options.grid.empty()) {
    Warnings warnings;
    surface.heights = read_grid(options.grid, warnings);
    for (const auto& [kind, count] : warnings.counts()) {
      if (!options.run.quiet) warn(options.grid, std::to_string(count) + " " + kind);
    }
    surface.x_stride = surface.y_stride = options.every.value_or(1);
  } else {
    Positions x = positions(options.x, y_curves, options.samples), y = positions(options.y, x_curves, options.samples);
    surface.x_stride = x.stride;
    surface.y_stride = y.stride;
    surface.heights = formula_heights(options.formula, std::move(x.at), std::move(y.at));
  }
  if (!x_curves) surface.x_stride = 0;
  if (!y_curves) surface.y_stride = 0;
  return surface;
}

}  // namespace ligne
