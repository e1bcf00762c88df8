#include "picture/surface_request.hpp"

#include <cmath>

#include "geometry/degrees.hpp"
#include "picture/errors.hpp"

namespace ligne {
namespace {

constexpr double kAzimuth = -60, kElevation = 30;
constexpr unsigned kMostContours = 10'000, kContours = 10;
/// How far below the lowest height the contours of the base lie, as a part of the range of heights.
constexpr double kBaseDepth = 0.3;

}  // namespace

std::string needs_mesh(const SurfaceRequest& request) {
  if (!request.parametric.empty()) return "--parametric";
  if (request.formulas.size() + request.grids.size() > 1) return "several surfaces";
  if (request.z_range) return "--z-range";
  if (request.skirt) return "--skirt";
  if (request.picture.lines.hidden != HiddenLines::none) return "--hidden";
  if (request.picture.hatch.asked()) return "--hatch";
  if (request.picture.output.format == OutputFormat::json) return "json";
  return "";
}

std::string needs_horizon(const SurfaceRequest& request) {
  if (request.pixel_columns) return "--horizon pixels";
  if (request.curves.ridgeline) return "--ridgeline";
  if (request.curves.contours_base) return "--contours-base";
  if (request.curves.underside != Underside::same) return "--underside";
  if (request.curves.hidden_by != HiddenBy::surface) return "--hidden-by curves";
  return "";
}

bool drawn_by_horizon(const SurfaceRequest& request) { return !request.picture.lines.method && needs_mesh(request).empty(); }

ViewRequest view_of(const SurfaceRequest& request) {
  ViewRequest view = request.picture.view;
  view.up_axis = view.up_axis.value_or(Axis::z);
  if (view.named_view || view.direction || view.eye) return view;
  const auto [sin_azimuth, cos_azimuth] = sine_cosine_degrees(request.azimuth_degrees.value_or(kAzimuth));
  const auto [sin_elevation, cos_elevation] = sine_cosine_degrees(request.elevation_degrees.value_or(kElevation));
  view.direction = Point3{-cos_azimuth * cos_elevation, -sin_azimuth * cos_elevation, -sin_elevation};
  // Straight from above and below the azimuth says which way is up on the page.
  if (!view.up && cos_elevation == 0) view.up = Point3{-cos_azimuth * sin_elevation, -sin_azimuth * sin_elevation, 0};
  return view;
}

std::string place_of_warnings(const SurfaceRequest& request) {
  const bool one_grid = request.grids.size() == 1 && request.formulas.empty() && request.parametric.empty();
  return one_grid ? request.grids.front() : "surface";
}

std::vector<double> contour_levels(const CurveRequest& request, double low, double high) {
  std::vector<double> levels;
  if (request.contour_step) {
    const double step = *request.contour_step, first = std::ceil(low / step);
    if (!((high - low) / step < kMostContours)) {
      throw RequestError("contour-step", "gives more than " + std::to_string(kMostContours) + " contour lines");
    }
    for (double k = first; k * step <= high; ++k) levels.push_back(k * step);
  } else if (request.contours || request.contours_base) {
    const unsigned n = request.contours.value_or(kContours);
    for (unsigned k = 1; k <= n; ++k) levels.push_back(low + (high - low) * k / (n + 1));
  }
  return levels;
}

double contour_base_of(const CurveRequest& request, double low, double high) {
  return request.contour_base.value_or(low - kBaseDepth * (high - low));
}

double z_scale_of(const SurfaceRequest& request, double side, double height) {
  if (request.z_scale) return *request.z_scale;
  const double scale = side / (2 * height);
  return height > 0 && std::isfinite(scale) && scale > 0 ? scale : 1;
}

}  // namespace ligne
