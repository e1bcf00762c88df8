#include "picture/surface/surface_request.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/degrees.hpp"
#include "picture/errors.hpp"
#include "view/axes/ticks.hpp"

namespace ligne {
namespace {

constexpr double kAzimuth = -60, kElevation = 30;
constexpr unsigned kMostContours = 10'000, kContours = 10, kIndexContours = 5;
/// Distance of the contours of the base below the lowest height, as a fraction of the range of heights.
constexpr double kContourDepth = 0.3;

void check_sources(const SurfaceRequest& request) {
  const bool formulas = !request.formulas.empty(), parametric = !request.parametric.empty();
  const bool grids = !request.grids.empty() || !request.heights.empty();
  if (!formulas && !grids && !parametric) {
    throw RequestError("", "surface: give a formula in x and y, or --grid FILE, or --parametric X Y Z");
  }
  if (!formulas && !grids) {
    if (request.x || request.y) {
      throw RequestError("", "-x, -y: work for z = f(x, y) only; a parametric surface has -u and -v");
    }
    for (std::size_t k = 0; k < 3; ++k) {
      if (request.log_axes[k]) throw RequestError(std::string("log-") + "xyz"[k], "works for z = f(x, y) only");
    }
  }
  if (parametric && request.skirt) {
    throw RequestError("skirt", "works for z = f(x, y), which has a border, not for --parametric");
  }
  if (std::max(request.u.size(), request.v.size()) > request.parametric.size()) {
    throw RequestError("",
                       parametric ? "-u, -v: there are more ranges than parametric surfaces" : "-u, -v: need --parametric");
  }
  if (!formulas && !parametric && request.samples) throw RequestError("samples", "a grid has its own samples");
  if (!formulas && ((request.x && request.x->curves) || (request.y && request.y->curves))) {
    throw RequestError("", "-x, -y: a grid takes A:B, a window; --every N selects the curves");
  }
  if (!grids && request.every) {
    throw RequestError("every", "needs --grid; for a formula, -x A:B:N sets the number of curves");
  }
  if (!grids && request.gridded) throw RequestError("gridded", "needs --grid");
  if (request.grids.empty()) {
    if (request.layout != TableLayout::automatic) throw RequestError("layout", "needs --grid");
    if (request.data_set) throw RequestError("index", "needs --grid");
    if (!request.using_columns.empty()) throw RequestError("using", "needs --grid");
  }
  if (request.grids.empty() && request.band) throw RequestError("band", "needs --grid");
  if (!grids && request.ground != GroundChoice::as_read) throw RequestError("ground", "needs --grid");
  if (!grids && request.max_slope) {
    throw RequestError("max-slope", "needs --grid; jumps of formulas are detected automatically");
  }
}

void check_curves(const SurfaceRequest& surface) {
  const CurveRequest& request = surface.curves;
  const bool curves_hide = request.hidden_by == HiddenBy::curves;
  if (request.contours && request.contour_step) {
    throw RequestError("", "--contours, --contour-step: can not be combined");
  }
  const bool contours = request.contours || request.contour_step || request.contours_base;
  if (!contours && (request.labels != ContourLabels::none || request.index_contours)) {
    throw RequestError(request.index_contours ? "index-contours" : "contour-labels", "needs --contours or --contour-step");
  }
  if (curves_hide && contours) {
    throw RequestError("hidden-by", "curves provides no surface for contours");
  }
  if (curves_hide && request.outline.value_or(false)) {
    throw RequestError("hidden-by", "curves provides no surface for outlines");
  }
  if (request.ridgeline && (contours || request.outline.value_or(false))) {
    throw RequestError("ridgeline", "draws rows only");
  }
  if (request.ridgeline && !(request.ridgeline_overlap > 0)) {
    throw RequestError("ridgeline", "the overlap must be above 0");
  }
  if (surface.lines == CurveFamilies::none && curves_hide)
    throw RequestError("hidden-by", "curves needs --lines x, y or xy");
}

void check_terrain(const SurfaceRequest& request) {
  const TerrainRequest& terrain = request.terrain;
  if ((terrain.has_water() || terrain.hachures != HachureKind::none) && !request.parametric.empty()) {
    throw RequestError(terrain.has_water() ? "water" : "hachures", "works for z = f(x, y) only");
  }
  if (terrain.water && terrain.water_at_holes) throw RequestError("water", "is a height or nodata, not both");
  if (!terrain.has_water() && terrain.water_fill != WaterFill::blank) throw RequestError("water-fill", "needs --water");
  if (terrain.hachures == HachureKind::none && terrain.hachure_mm) {
    throw RequestError("hachure-spacing", "needs --hachures");
  }
  if (request.curves.ridgeline && terrain.water_fill != WaterFill::blank) {
    throw RequestError("ridgeline", "can not hatch water");
  }
}

void check_scale(const SurfaceRequest& request) {
  const bool is_ratio = request.aspect && request.aspect->kind == AspectRequest::ratio;
  if (is_ratio && (request.z_scale || request.exaggeration)) {
    throw RequestError("aspect",
                       "X:Y:Z sets the height of the picture, and can not be combined with --z-scale or --exaggeration");
  }
  if (request.exaggeration && request.aspect && request.aspect->kind == AspectRequest::box)
    throw RequestError("exaggeration", "needs --aspect equal");
  if (request.curves.ridgeline && request.aspect) throw RequestError("ridgeline", "sets the aspect");
  const std::optional<CurveRange>* ranges[] = {&request.x, &request.y};
  for (std::size_t k = 0; k < 2; ++k) {
    const std::string name(1, "xy"[k]);
    if (!request.log_axes[k] || !request.grids.empty()) continue;
    if (!*ranges[k]) throw RequestError("log-" + name, "needs a range -" + name + " A:B above zero");
    if (!((*ranges[k])->from > 0)) throw RequestError("log-" + name, "the range -" + name + " reaches down to zero");
  }
}

std::vector<double> even_levels(double low, double high, unsigned n) {
  std::vector<double> levels;
  for (unsigned k = 1; k <= n; ++k) levels.push_back(low + (high - low) * k / (n + 1));
  return levels;
}

/// Multiples of a step, mantissa * 10^exponent, between two heights.
struct RoundStep {
  double mantissa, low, high;
  int exponent;

  double size() const { return mantissa * std::pow(10.0, exponent); }
  double first() const { return std::floor(low / size() + kAtEnd) + 1; }
  double last() const { return std::ceil(high / size() - kAtEnd) - 1; }
  double count() const { return std::max(0.0, last() - first() + 1); }
  /// Divides by a power of ten, since powers of ten are exact and fractional steps are not.
  double multiple(double k) const {
    if (k == 0) return 0;
    return exponent < 0 ? k * mantissa / std::pow(10.0, -exponent) : k * size();
  }

  /// Least distance of a level from the lowest and the highest height, in steps. A nearer level would be a point or a
  /// speck.
  static constexpr double kAtEnd = 1e-9;
};

/// Returns nothing if the heights are too close for round numbers between them.
std::vector<double> round_levels(double low, double high, unsigned n, bool decades) {
  std::vector<double> levels;
  if (!(high > low) || !std::isfinite(high - low)) return levels;
  if (decades) {
    for (const Tick& tick : round_ticks(TickScale::decades, low, high, n)) {
      if (low < tick.at && tick.at < high) levels.push_back(tick.at);
    }
    return levels;
  }
  constexpr double kMostSteps = 0x1p40;  // largest number of steps; doubles have digits to spare
  const int exponent = static_cast<int>(std::floor(std::log10((high - low) / n)));
  std::optional<RoundStep> best;
  const auto misses = [n](const RoundStep& step) { return std::abs(std::log(step.count() / n)); };
  for (int e = exponent + 1; e >= exponent - 1; --e) {
    for (const double mantissa : {5., 2., 1.}) {
      const RoundStep step{mantissa, low, high, e};
      if (step.count() < 1 || std::max(std::abs(low), std::abs(high)) / step.size() > kMostSteps) continue;
      if (!best || misses(step) < misses(*best)) best = step;
    }
  }
  if (!best) return levels;
  for (double k = best->first(); k <= best->last(); ++k) levels.push_back(best->multiple(k));
  return levels;
}

}  // namespace

void check(const SurfaceRequest& request) {
  check_sources(request);
  check_scale(request);
  check_curves(request);
  check_terrain(request);
  if (request.t.size() > request.space_curves.size()) throw RequestError("", "-t: there are more ranges than curves");
  if (!request.names.empty() && !request.legend) throw RequestError("name", "needs --legend");
  if (request.legend && request.picture.output.format == OutputFormat::json) {
    throw RequestError("legend", "is not written as json");
  }
  if (!request.point_files.empty() && request.picture.output.format == OutputFormat::json) {
    throw RequestError("points", "are not written as json");
  }
}

std::string needs_mesh(const SurfaceRequest& request) {
  if (!request.parametric.empty()) return "--parametric";
  if (height_count(request) > 1) return "several surfaces";
  if (request.z_range) return "--z-range";
  if (request.skirt) return "--skirt";
  if (request.terrain.has_water() && !request.curves.ridgeline) return "--water";
  if (request.terrain.hachures != HachureKind::none) return "--hachures";
  if (!request.space_curves.empty()) return "--curve";
  if (!request.point_files.empty()) return "--points";
  if (!request.line_files.empty()) return "--path";
  if (request.bands) return "--bands";
  if (!request.colors.empty()) return "--colors";
  if (request.legend) return "--legend";
  if (request.picture.lines.hidden != HiddenLines::none) return "--hidden";
  if (request.picture.hatch.is_requested()) return "--hatch";
  if (request.picture.fill.is_requested()) return "--fill";
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
  // In views straight from above and below, the azimuth defines the up direction of the page.
  if (!view.up && cos_elevation == 0) view.up = Point3{-cos_azimuth * sin_elevation, -sin_azimuth * sin_elevation, 0};
  return view;
}

std::string place_of_warnings(const SurfaceRequest& request) {
  const bool one_grid = request.grids.size() == 1 && height_count(request) == 1 && request.parametric.empty();
  return one_grid ? request.grids.front() : "surface";
}

std::vector<double> contour_levels(const CurveRequest& request, double low, double high, bool decades) {
  std::vector<double> levels;
  if (request.contour_step) {
    const double step = *request.contour_step, first = std::ceil(low / step);
    if (!((high - low) / step < kMostContours)) {
      throw RequestError("contour-step", "gives more than " + std::to_string(kMostContours) + " contour lines");
    }
    for (double k = first; k * step <= high; ++k) levels.push_back(k == 0 ? 0 : k * step);
  } else if (!request.contour_heights.empty()) {
    for (const double height : request.contour_heights) {
      const double level = decades ? std::log10(height) : height;
      if (low <= level && level <= high) levels.push_back(level);
    }
  } else if (request.contours || request.contours_base) {
    const unsigned n = request.contours.value_or(kContours);
    if (!request.even_contours) levels = round_levels(low, high, n, decades);
    if (levels.empty() && high > low) levels = even_levels(low, high, n);
  }
  return levels;
}

bool is_index_contour(const CurveRequest& request, double level, std::size_t number) {
  const unsigned every = request.index_contours.value_or(request.contour_step ? kIndexContours : 0);
  if (every == 0) return false;
  if (!request.contour_step) return (number + 1) % every == 0;
  return std::fmod(std::round(level / *request.contour_step), every) == 0;
}

bool names_heights(const CurveRequest& request) {
  return request.labels != ContourLabels::none || request.index_contours.value_or(request.contour_step ? 1 : 0) > 0;
}

double contour_base_of(const CurveRequest& request, double low, double high) {
  return request.contour_base.value_or(low - kContourDepth * (high - low));
}

}  // namespace ligne
