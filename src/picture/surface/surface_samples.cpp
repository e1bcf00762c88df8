#include "picture/surface/surface_samples.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "files/message_text.hpp"
#include "picture/errors.hpp"
#include "picture/surface/defined_ground.hpp"
#include "picture/surface/surface_scale.hpp"
#include "scene/surfaces/grids/grid_surfaces.hpp"
#include "scene/surfaces/height_filters.hpp"
#include "scene/surfaces/held_heights.hpp"

namespace ligne {
namespace {

/// Finds formulas whose samples show another surface than the formula.

/// The directions in which a picture interpolates between samples.
struct InterpolatedAxes {
  bool x = true, y = true;
};

/// Number of rows of cells, and of cells of each, that are looked at. With the samples of two rows they cost less than two
/// hundredths of a surface of 200 x 200 samples.
constexpr std::size_t kRows = 16, kCellsOfRow = 16;
/// Smallest number of cells with heights that tells anything.
constexpr std::size_t kFewestCells = 32;
/// Trimmed part of the heights at each end: their range without peaks and poles.
constexpr double kTrimmed = 0.1;
/// A difference is gross above this part of the trimmed range, and the surface is undersampled if this part of the cells
/// has gross differences. Taste: sines of less than eight samples in a period are undersampled.
constexpr double kGross = 1. / 16, kLargePart = 1. / 3;

/// The k-th of `count` places among `size`, spread evenly but not regularly, so that a periodic surface can not hide.
std::size_t spread(std::size_t k, std::size_t count, std::size_t size, std::size_t shift) {
  constexpr double kGoldenRatio = 0.6180339887498949;
  const double turns = static_cast<double>(k + shift * count) * kGoldenRatio;
  const double at = (static_cast<double>(k) + turns - std::floor(turns)) / static_cast<double>(count);
  return std::min(size - 1, static_cast<std::size_t>(at * static_cast<double>(size)));
}

struct Differences {
  std::vector<double> heights, differences;
};

/// Adds the cells between the rows j and j + 1; on row j only if the picture does not interpolate between rows.
void add_row(const HeightSource& heights, HeightFunction::At& at, InterpolatedAxes axes, std::size_t j, Differences& out) {
  const std::vector<double>&x = heights.x(), &y = heights.y();
  const std::size_t next = axes.y ? j + 1 : j, cells = std::min(kCellsOfRow, x.size() - 1);
  std::vector<double> low(x.size()), high(x.size());
  heights.read_row(j, low);
  heights.read_row(next, high);
  for (std::size_t k = 0; k < cells; ++k) {
    const std::size_t i = spread(k, cells, x.size() - 1, j), i_next = axes.x ? i + 1 : i;
    const double between = (low[i] + low[i_next] + high[i] + high[i_next]) / 4;
    const double z = at((x[i] + x[i_next]) / 2, (y[j] + y[next]) / 2);
    if (!std::isfinite(between) || !std::isfinite(z)) continue;
    out.heights.push_back(z);
    out.differences.push_back(std::abs(z - between));
  }
}

/// Whether the function differs grossly, at half steps, from the interpolation of its samples, in a large part of the
/// cells. Poles, jumps and edges along lines do not count: they are in few cells. Looks at an even choice of some 256
/// cells.
bool is_undersampled(const HeightSource& heights, const HeightFunction& function, InterpolatedAxes axes) {
  Differences found;
  function.use([&](HeightFunction::At& at) {
    const std::size_t rows = heights.y().size() - 1, chosen = std::min(kRows, rows);
    for (std::size_t k = 0; k < chosen; ++k) add_row(heights, at, axes, spread(k, chosen, rows, 0), found);
  });
  const std::size_t n = found.heights.size();
  if (n < kFewestCells) return false;
  std::ranges::sort(found.heights);
  const auto trimmed = static_cast<std::size_t>(kTrimmed * static_cast<double>(n));
  const double range = found.heights[n - 1 - trimmed] - found.heights[trimmed];
  const auto gross = std::ranges::count_if(found.differences, [&](double d) { return d > kGross * range; });
  return range > 0 && static_cast<double>(gross) > kLargePart * static_cast<double>(n);
}

constexpr unsigned kCurves = 40;
/// Default number of samples between two neighbouring curves: smooth, but by default at most a thousand along a curve.
/// Fewer curves have as many samples in all as the default number.
constexpr unsigned kSamplesBetween = 5, kSamplesAlong = 1000, kFewestAlong = kSamplesBetween * (kCurves - 1);

/// Largest number of samples of a formula that are stored (32 MB), since a picture uses each several times. Larger
/// surfaces are computed again each time.
constexpr std::size_t kHeldSamples = std::size_t{1} << 22;

/// Largest number of samples of a formula. More would take minutes.
constexpr std::size_t kMostSamplesOfFormula = 1'000'000'000;

/// Positions of the samples, and the stride of the curves.
struct Positions {
  std::vector<double> at;
  std::size_t stride = 1;
};

/// `crossed`: curves run along this axis and need samples between the curves of the other family.
Positions positions(CurveRange range, bool crossed, const std::optional<unsigned>& samples, bool log = false) {
  if (log) range = {std::log10(range.from), std::log10(range.to), range.curves};
  const unsigned intervals = range.curves.value_or(kCurves) - 1;
  Positions result;
  if (crossed && samples) {
    result.stride = std::max(1u, (*samples - 1 + intervals - 1) / intervals);
  } else if (crossed) {
    const unsigned between = std::max(kSamplesBetween, (kFewestAlong + intervals - 1) / intervals);
    result.stride = std::clamp(kSamplesAlong / intervals, 1u, between);
  }
  const std::size_t n = result.stride * intervals;
  for (std::size_t i = 0; i <= n; ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(n);
    result.at.push_back(i == n ? range.to : range.from + t * (range.to - range.from));
  }
  return result;
}

std::string samples_text(std::size_t columns, std::size_t rows) {
  return std::to_string(columns) + " x " + std::to_string(rows) + " samples";
}

/// Refuses too many samples of formulas. `ranges`: the options that give the numbers of curves.
void check_samples(const SurfaceRequest& request, const Positions& columns, const Positions& rows, const char* ranges) {
  if (columns.at.size() <= kMostSamplesOfFormula / rows.at.size()) return;
  const std::string cause =
      "gives " + samples_text(columns.at.size(), rows.at.size()) + ", more than " + std::to_string(kMostSamplesOfFormula);
  if (request.samples) throw RequestError("samples", cause);
  throw RequestError("", std::string(ranges) + ": " + cause);
}

/// A mesh has a point for each sample.
void check_mesh_memory(const SurfaceRequest& request, std::size_t columns, std::size_t rows, std::size_t all) {
  request.picture.memory.require(static_cast<double>(all) * sizeof(Point3), {"read", samples_text(columns, rows)});
}

bool x_curves(const SurfaceRequest& request) {
  return (request.lines == CurveFamilies::x || request.lines == CurveFamilies::xy) && !request.curves.ridgeline;
}
bool y_curves(const SurfaceRequest& request) {
  return request.lines == CurveFamilies::y || request.lines == CurveFamilies::xy || request.curves.ridgeline;
}

AxisWindow window_of(const std::optional<CurveRange>& range) {
  return range ? AxisWindow{range->from, range->to} : AxisWindow{};
}

/// Throws InputError if an option needs a single height over each position.
void check_mesh(const SurfaceRequest& request, const std::string& file) {
  const auto refuse = [&](bool is_given, const char* option) {
    if (is_given)
      throw InputError(printable(file),
                       std::string("holds a mesh whose x and y both vary: ") + option + " works for z = f(x, y) only");
  };
  refuse(request.x || request.y, "a window -x or -y");
  refuse(request.max_slope.has_value(), "--max-slope");
  refuse(request.skirt, "--skirt");
  refuse(request.terrain.has_water(), "--water");
  refuse(request.terrain.hachures != HachureKind::none, "--hachures");
  refuse(request.log_axes[0] || request.log_axes[1] || request.log_axes[2], "a logarithmic axis");
}

/// The unit of x and y: from the request, else from the file.
GroundUnit ground_of(const SurfaceRequest& request, GroundUnit as_read) {
  if (request.ground == GroundChoice::as_read) return as_read;
  return request.ground == GroundChoice::metres ? GroundUnit::same : GroundUnit::degrees;
}

/// Adds a surface of a file. `name`: name of the surface.
Surface grid_surface(const SurfaceRequest& request, GridSurface read, const std::string& file, std::string name) {
  Surface surface;
  surface.name = std::move(name);
  if (read.mesh) {
    check_mesh(request, file);
    surface.mesh = std::move(read.mesh);
    surface.unit = ground_of(request, surface.mesh->unit);
    surface.x_stride = surface.y_stride = request.every.value_or(1);
    return surface;
  }
  surface.heights = std::move(read.heights);
  const std::size_t thinned_by = request.every ? surface.heights->thinned_by() : 1;
  if (!request.log_axes[0] && !request.log_axes[1] && !request.log_axes[2]) surface.function = surface.heights->function();
  const GroundUnit unit = ground_of(request, surface.heights->unit());
  if (request.x || request.y) {
    surface.heights = window_heights(std::move(surface.heights), window_of(request.x), window_of(request.y), file);
  }
  if (request.max_slope) {
    surface.left_out = steep_cells(*surface.heights, *request.max_slope, unit == GroundUnit::degrees ? kMetresPerDegree : 1);
  }
  surface.x_stride = surface.y_stride = request.every.value_or(1) / thinned_by;
  surface.thinned = !request.every && !request.curves.ridgeline;
  surface.unit = unit;
  return surface;
}

/// Adds the surfaces of a file. Several data sets are numbered.
void add_grids(const SurfaceRequest& request, const std::string& file, std::vector<Surface>& grids, RunReport& run) {
  Warnings warnings;
  const bool whole = request.x || request.y;  // a window of a large grid keeps all samples
  GridChoice choice{request.gridded, request.every, !whole};
  choice.layout = request.layout;
  choice.data_set = request.data_set;
  choice.using_columns = request.using_columns;
  choice.band = request.band;
  std::vector<GridSurface> surfaces = read_surfaces(file, warnings, &run.files, choice);
  for (std::string& line : warnings.lines()) run.warnings.push_back({file, std::move(line)});
  for (std::size_t k = 0; k < surfaces.size(); ++k) {
    std::string name = surfaces.size() == 1 ? file : file + ", data set " + std::to_string(k);
    grids.push_back(grid_surface(request, std::move(surfaces[k]), file, std::move(name)));
  }
}

Surface given_surface(const SurfaceRequest& request, const GivenHeights& given) {
  Surface surface;
  surface.name = given.name;
  surface.heights = held_heights(given.x, given.y, given.z, SampleOrder::first_row_lowest(given.x.size()), given.name);
  if (request.x || request.y) {
    surface.heights = window_heights(std::move(surface.heights), window_of(request.x), window_of(request.y), given.name);
  }
  if (request.max_slope) surface.left_out = steep_cells(*surface.heights, *request.max_slope, 1);
  surface.x_stride = surface.y_stride = request.every.value_or(1);
  surface.thinned = !request.every && !request.curves.ridgeline;
  return surface;
}

/// The range of a variable of a formula: the given one, else that of the grids, else the default.
CurveRange range_of(const std::optional<CurveRange>& given, const std::vector<Surface>& grids,
                    const std::vector<double>& (HeightSource::*axis)() const) {
  CurveRange range = given.value_or(CurveRange{});
  if (given || grids.empty()) return range;
  bool is_first = true;
  for (const Surface& grid : grids) {
    if (!grid.heights) continue;
    if (is_first) range.from = ((*grid.heights).*axis)().front(), range.to = ((*grid.heights).*axis)().back();
    is_first = false;
    range.from = std::min(range.from, ((*grid.heights).*axis)().front());
    range.to = std::max(range.to, ((*grid.heights).*axis)().back());
  }
  return range;
}

/// Narrows default ranges to the part where the formulas have heights, so that the scale of heights and the curves do
/// not depend on empty ground.
void narrow_default_ranges(const SurfaceRequest& request, CurveRange& x, CurveRange& y, RunReport& run) {
  const std::array<bool, 2> open{!request.x && !request.log_axes[0], !request.y && !request.log_axes[1]};
  if (request.formulas.empty() || (!open[0] && !open[1])) return;
  std::vector<std::shared_ptr<const HeightFunction>> functions;
  for (const std::string& formula : request.formulas) functions.push_back(formula_function(formula, request.log_axes));
  const auto positions_of = [](const CurveRange& range, bool log) {
    return log ? std::array{std::log10(range.from), std::log10(range.to)} : std::array{range.from, range.to};
  };
  const Ground ground{positions_of(x, request.log_axes[0]), positions_of(y, request.log_axes[1])};
  const Ground defined = defined_ground(functions, ground, open);
  const auto narrow = [&](CurveRange& range, std::size_t axis, const char* name) {
    if (defined[axis] == ground[axis]) return;
    range.from = defined[axis][0];
    range.to = defined[axis][1];
    run.choices.emplace_back(name, short_number(range.from) + ":" + short_number(range.to) + ": where there are heights");
  };
  narrow(x, 0, "x");
  narrow(y, 1, "y");
}

void warn_if_undersampled(const Surface& surface, InterpolatedAxes axes, RunReport& run) {
  if (!is_undersampled(*surface.heights, *surface.function, axes)) return;
  run.warn(printable(surface.name) +
           " changes faster than its samples show; more of them (--samples) or a smaller range (-x, -y) draws it");
}

/// Range of a parameter of the k-th parametric surface.
CurveRange parameter_range(const std::vector<CurveRange>& given, std::size_t k) {
  if (given.empty()) return {0, 2 * std::numbers::pi, {}};
  return given[std::min(k, given.size() - 1)];
}

/// Removes the families of curves that are not requested.
template <class AnySurface>
void choose_curves(AnySurface& surface, const SurfaceRequest& request) {
  if (!x_curves(request)) surface.x_stride = 0;
  if (!y_curves(request)) surface.y_stride = 0;
}

}  // namespace

std::vector<Surface> surfaces_of(const SurfaceRequest& request, RunReport& run) {
  std::vector<Surface> grids;
  for (const std::string& file : request.grids) add_grids(request, file, grids, run);
  for (const GivenHeights& given : request.heights) grids.push_back(given_surface(request, given));
  // The hiding surface is finely sampled in both directions, unless only the curves hide.
  const bool by_curves = request.curves.hidden_by == HiddenBy::curves || request.curves.ridgeline;
  CurveRange x_range = range_of(request.x, grids, &HeightSource::x), y_range = range_of(request.y, grids, &HeightSource::y);
  if (grids.empty()) narrow_default_ranges(request, x_range, y_range, run);
  std::vector<Surface> surfaces;
  const InterpolatedAxes axes{!by_curves || y_curves(request), !by_curves || x_curves(request)};
  for (const std::string& formula : request.formulas) {
    Positions x = positions(x_range, axes.x, request.samples, request.log_axes[0]);
    Positions y = positions(y_range, axes.y, request.samples, request.log_axes[1]);
    check_samples(request, x, y, "-x, -y");
    Surface& surface = surfaces.emplace_back();
    surface.name = formula;
    surface.x_stride = x.stride;
    surface.y_stride = y.stride;
    surface.from_formula = true;
    surface.function = formula_function(formula, request.log_axes);
    surface.heights = heights_of(surface.function, std::move(x.at), std::move(y.at));
    if (surface.heights->x().size() * surface.heights->y().size() <= kHeldSamples) surface.heights = held(*surface.heights);
    warn_if_undersampled(surface, axes, run);
  }
  std::stable_partition(grids.begin(), grids.end(), [](const Surface& grid) { return !grid.mesh; });
  for (Surface& grid : grids) {
    if (!grid.mesh) grid.heights = log_ground(std::move(grid.heights), request.log_axes[0], request.log_axes[1], grid.name);
    if (request.log_axes[2] && !grid.mesh) grid.heights = log_heights(std::move(grid.heights));
    surfaces.push_back(std::move(grid));
  }
  for (Surface& surface : surfaces) {
    choose_curves(surface, request);
    if (surface.heights && level_noise(surface.heights)) surface.function = nullptr;
  }
  return surfaces;
}

void refuse_empty(const SurfaceRequest& request, const std::string& formula, RunReport& run) {
  const std::string cause = printable(formula) + (request.z_range ? " has no height within --z-range" : " has no value") +
                            " in the drawn range of -x and -y";
  if (request.formulas.size() + request.grids.size() + request.parametric.size() == 1) throw InputError("surface", cause);
  run.warn(cause);
}

std::vector<SurfacePoints> points_of(const SurfaceRequest& request, const std::vector<Surface>& surfaces) {
  std::vector<SurfacePoints> all;
  std::size_t samples = 0;
  for (const Surface& surface : surfaces) {
    const std::size_t columns = surface.mesh ? surface.mesh->columns : surface.heights->x().size();
    const std::size_t rows = surface.mesh ? surface.mesh->rows : surface.heights->y().size();
    take_samples(samples, columns, rows, surface.name);
    check_mesh_memory(request, columns, rows, samples);
    SurfacePoints& points = all.emplace_back(surface.mesh ? *surface.mesh : points_of(*surface.heights));
    points.name = surface.name;
    points.x_stride = surface.x_stride;
    points.y_stride = surface.y_stride;
    points.from_formula = surface.from_formula;
    points.function = surface.function;
    points.unit = surface.unit;
    points.left_out = surface.left_out;
  }
  for (std::size_t k = 0; k < request.parametric.size(); ++k) {
    const std::array<std::string, 3>& formulas = request.parametric[k];
    const Positions u = positions(parameter_range(request.u, k), true, request.samples);
    const Positions v = positions(parameter_range(request.v, k), true, request.samples);
    const std::string name = formulas[0] + "; " + formulas[1] + "; " + formulas[2];
    check_samples(request, u, v, "-u, -v");
    take_samples(samples, u.at.size(), v.at.size(), name);
    check_mesh_memory(request, u.at.size(), v.at.size(), samples);
    SurfacePoints& points = all.emplace_back(parametric_points(formulas, u.at, v.at));
    points.name = name;
    points.x_stride = u.stride;
    points.y_stride = v.stride;
    choose_curves(points, request);
  }
  return all;
}

}  // namespace ligne
