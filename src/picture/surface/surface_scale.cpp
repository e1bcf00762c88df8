#include "picture/surface/surface_scale.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <glm/geometric.hpp>

#include "geometry/degrees.hpp"

namespace ligne {
namespace {

constexpr std::size_t kFewestCurves = 8;

/// Largest latitude. Nearer to a pole, a degree of longitude is too short to draw.
constexpr double kHighestLatitude = 89;

double or_one(double factor) { return std::isfinite(factor) && factor > 0 ? factor : 1; }

/// The default aspect of x and y depends on the ratio of their ranges.
AspectRequest aspect_of(const SurfaceRequest& request, const Point3& range, GroundUnit unit, bool parametric,
                        RunReport& run) {
  const auto choose = [&](AspectRequest::Kind kind, const std::string& why) {
    run.choices.emplace_back("aspect", std::string(kind == AspectRequest::box ? "box" : "equal") + ": " + why);
    return AspectRequest{kind};
  };
  if (request.aspect) return *request.aspect;
  if (parametric) return choose(AspectRequest::equal, "the surface is parametric");
  if (request.exaggeration) return choose(AspectRequest::equal, "--exaggeration is true to scale");
  if (unit == GroundUnit::degrees) return choose(AspectRequest::equal, "degrees by the cosine of the latitude");
  if (unit == GroundUnit::same) return choose(AspectRequest::equal, "the ground has one unit");
  const double unlike = std::max(range.x, range.y) / std::min(range.x, range.y);
  const std::string by = "the ranges of x and y differ by a factor of " + short_number(unlike);
  return choose(unlike > kMostUnlike ? AspectRequest::box : AspectRequest::equal, by);
}

}  // namespace

Point3 plot_factor(const SurfaceRequest& request, const AxesBox& box, GroundUnit unit, bool parametric, RunReport& run) {
  const Point3 range = box.high - box.low;
  const AspectRequest aspect = aspect_of(request, range, unit, parametric, run);
  Point3 factor{1, 1, 1};
  if (aspect.kind == AspectRequest::ratio) {
    factor.y = or_one(aspect.sides.y / aspect.sides.x * (range.x / range.y));
    factor.z = or_one(aspect.sides.z / aspect.sides.x * (range.x / range.z));
    return factor;
  }
  if (aspect.kind == AspectRequest::box) {
    const int shorter = range.x < range.y ? 0 : 1;
    factor[shorter] = or_one(range[1 - shorter] / range[shorter]);
  } else if (unit == GroundUnit::degrees) {
    const double latitude = std::clamp((box.low.y + box.high.y) / 2, -kHighestLatitude, kHighestLatitude);
    factor.x = sine_cosine_degrees(latitude).cosine;
  }
  const double side = std::max(range.x * factor.x, range.y * factor.y);
  if (request.z_scale) {
    factor.z = *request.z_scale;
  } else if (request.exaggeration) {
    factor.z = *request.exaggeration / (unit == GroundUnit::degrees ? kMetresPerDegree : 1);
  } else if (!parametric) {
    factor.z = range.z > 0 ? or_one(side / (2 * range.z)) : 1;
  } else if (aspect.kind == AspectRequest::box) {
    factor.z = range.z > 0 ? or_one(side / range.z) : 1;
  }
  return factor;
}

std::string short_number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

std::vector<double> levels_in_heights(const CurveRequest& request, double low, double high, bool decades, RunReport& run) {
  std::vector<double> levels = contour_levels(request, low, high, decades);
  if (levels.empty() && (request.contour_step || !request.contour_heights.empty())) {
    const auto height = [&](double z) { return short_number(decades ? std::pow(10.0, z) : z); };
    run.warn("no contour line lies within the heights, " + height(low) + ":" + height(high));
  }
  return levels;
}

std::array<TickScale, 3> tick_scales(const SurfaceRequest& request) {
  std::array<TickScale, 3> scales{};
  for (std::size_t k = 0; k < 3; ++k) {
    if (request.log_axes[k]) scales[k] = TickScale::decades;
  }
  return scales;
}

Strides strides_apart(const GridOnPage& grid, const View& view, double pen_width_mm) {
  const Point3 middle = (grid.box.low + grid.box.high) / 2., extent = grid.box.high - grid.box.low;
  const Point3 step_x{extent.x / static_cast<double>(grid.columns - 1), 0, 0};
  const Point3 step_y{0, extent.y / static_cast<double>(grid.rows - 1), 0};
  const Point2 at = page_point(view, middle);
  const Point2 a = page_point(view, middle + step_x) - at, b = page_point(view, middle + step_y) - at;
  const double cell = std::abs(cross(a, b));
  const double across_x = cell / glm::length(b), across_y = cell / glm::length(a);
  double least = INFINITY;
  if (grid.x_curves) least = std::min(least, across_x);
  if (grid.y_curves) least = std::min(least, across_y);
  const double stride = std::ceil(kCurveDistance * pen_width_mm / least);
  const auto of = [&](std::size_t samples) {
    const std::size_t most = std::max<std::size_t>(1, (samples - 1) / (kFewestCurves - 1));
    return stride >= 1 && stride < static_cast<double>(most) ? static_cast<std::size_t>(stride) : stride >= 1 ? most : 1;
  };
  return {of(grid.columns), of(grid.rows)};
}

}  // namespace ligne
