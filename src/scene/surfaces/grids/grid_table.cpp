// Makes surfaces of points in any order.

#include <algorithm>
#include <array>
#include <cmath>

#include "scene/surfaces/grids/grid_formats.hpp"
#include "scene/surfaces/held_heights.hpp"
#include "scene/surfaces/scattered_points.hpp"

namespace ligne {
namespace {

/// Largest difference of positions that count as equal, relative to the extent: rounding when they were written. Grids
/// have far fewer positions on an axis than its inverse.
constexpr double kSamePosition = 0x1p-24;
/// Limits for points that form a grid: largest number of grid places per point, or largest number of points per cell
/// that has all four corners.
constexpr double kPlacesPerPoint = 2, kPointsPerCell = 2;
/// Number of rows that are sampled to tell whether columns hold places.
constexpr std::size_t kRowsLookedAt = 65536;
/// Largest number of places (columns times rows) of a grid with holes, per point.
constexpr double kMostPlaces = 8;

/// Larger values are missing heights. Surfer writes 1.70141e38 for them, others the largest number of single precision.
constexpr double kBeyondHeights = 1e30;

/// A number such as -9999 means a missing height only if no other height is below this part of it.
constexpr double kFarFromSign = 0.1;

/// The distinct positions of an axis, ascending.
std::vector<double> positions_of(const std::vector<double>& at) {
  std::vector<double> sorted = at;
  std::sort(sorted.begin(), sorted.end());
  const double same = kSamePosition * (sorted.back() - sorted.front());
  std::vector<double> positions{sorted.front()};
  for (const double p : sorted) {
    if (p - positions.back() > same) positions.push_back(p);
  }
  return positions;
}

/// Whether points may form a grid, judged from a sample of them: a grid has at least as many positions as the sample.
bool can_be_grid(const std::vector<Point3>& points) {
  const std::size_t step =
      std::max<std::size_t>(1, static_cast<std::size_t>(std::sqrt(static_cast<double>(points.size())) / 8));
  std::array<std::vector<double>, 2> at;
  for (std::size_t k = 0; k < points.size(); k += step) {
    at[0].push_back(points[k].x);
    at[1].push_back(points[k].y);
  }
  const auto places = static_cast<double>(positions_of(at[0]).size()) * static_cast<double>(positions_of(at[1]).size());
  return places <= kMostPlaces * static_cast<double>(points.size());
}

/// The index of the position at or just before `at`.
std::size_t number_of(const std::vector<double>& positions, double at) {
  return static_cast<std::size_t>(std::upper_bound(positions.begin(), positions.end(), at) - positions.begin()) - 1;
}

/// Makes a grid with holes of points; null if they fill too little of one.
std::unique_ptr<HeightSource> grid_with_holes(const std::vector<Point3>& points, const std::string& name,
                                              Warnings& warnings) {
  if (!can_be_grid(points)) return nullptr;
  std::array<std::vector<double>, 2> at;
  for (const Point3& p : points) {
    at[0].push_back(p.x);
    at[1].push_back(p.y);
  }
  std::vector<double> x = positions_of(at[0]), y = positions_of(at[1]);
  const auto count = static_cast<double>(points.size());
  if (static_cast<double>(x.size()) * static_cast<double>(y.size()) > kMostPlaces * count) return nullptr;
  const std::size_t columns = x.size(), rows = y.size();
  std::vector<double> sum(columns * rows, 0);
  std::vector<std::uint32_t> given(columns * rows, 0), heights(columns * rows, 0);
  std::size_t repeated = 0;
  for (const Point3& p : points) {
    const std::size_t k = number_of(y, p.y) * columns + number_of(x, p.x);
    repeated += given[k]++ > 0;
    if (!std::isfinite(p.z)) continue;
    sum[k] += p.z;
    ++heights[k];
  }
  std::size_t cells = 0;
  for (std::size_t j = 0; j + 1 < rows; ++j) {
    for (std::size_t i = 0; i + 1 < columns; ++i) {
      const std::size_t k = j * columns + i;
      cells += given[k] && given[k + 1] && given[k + columns] && given[k + columns + 1];
    }
  }
  const bool dense = cells > 0 && kPlacesPerPoint * count >= static_cast<double>(columns * rows);
  if (!dense && kPointsPerCell * static_cast<double>(cells) < count) return nullptr;
  for (std::size_t k = 0; k < sum.size(); ++k) sum[k] = heights[k] ? sum[k] / heights[k] : kNoHeight;
  if (repeated > 0) warnings.add("points at equal positions: heights averaged", repeated);
  return held_heights(std::move(x), std::move(y), std::move(sum), SampleOrder::first_row_lowest(columns), name);
}

}  // namespace

void drop_missing_values(std::vector<double>& values, std::size_t step, Warnings& warnings) {
  std::size_t beyond = 0;
  for (std::size_t k = step - 1; k < values.size(); k += step) {
    if (!(std::abs(values[k]) >= kBeyondHeights)) continue;
    values[k] = kNoHeight;
    ++beyond;
  }
  warnings.add("heights beyond 1e30 read as NODATA", beyond);
  for (const double sign : {-9999., -32768., -99999.}) {
    std::size_t found = 0;
    bool are_others_far = true;
    for (std::size_t k = step - 1; k < values.size(); k += step) {
      if (values[k] == sign) {
        ++found;
      } else if (values[k] < kFarFromSign * sign) {
        are_others_far = false;
      }
    }
    if (found == 0 || !are_others_far || (found + 1) * step > values.size()) continue;
    for (std::size_t k = step - 1; k < values.size(); k += step) {
      if (values[k] == sign) values[k] = kNoHeight;
    }
    warnings.add("heights of " + std::to_string(static_cast<int>(sign)) + " read as NODATA", found);
  }
}

std::unique_ptr<HeightSource> surface_of_rows(const PointRows& rows, const GridChoice& choice, const std::string& name,
                                              Warnings& warnings) {
  std::vector<Point3> points;
  points.reserve(rows.lines.size());
  for (std::size_t row = 0; row < rows.lines.size(); ++row) {
    const Point3 p{rows.values[3 * row], rows.values[3 * row + 1], rows.values[3 * row + 2]};
    if (std::isfinite(p.x) && std::isfinite(p.y)) points.push_back(p);
  }
  warnings.leave_out("rows without x or y", rows.lines.size() - points.size());
  if (points.empty()) throw InputError(name, "holds no row of numbers");
  return surface_of_cloud(std::move(points), choice, name, warnings);
}

std::unique_ptr<HeightSource> surface_of_cloud(std::vector<Point3> points, const GridChoice& choice, const std::string& name,
                                               Warnings& warnings) {
  if (!choice.columns) {
    if (std::unique_ptr<HeightSource> grid = grid_with_holes(points, name, warnings)) return grid;
  }
  const std::size_t holes = std::erase_if(points, [](const Point3& p) { return !std::isfinite(p.z); });
  if (holes > 0) warnings.add("points without a height omitted", holes);
  warnings.add("scattered points: heights are linear in their Delaunay triangles", points.size());
  return surface_of_points(std::move(points), choice.columns, name, warnings);
}

bool are_places(const PointRows& rows) {
  const std::size_t step = rows.lines.size() / kRowsLookedAt + 1;
  std::vector<std::array<double, 2>> places;
  for (std::size_t row = 0; row < rows.lines.size(); row += step) {
    places.push_back({rows.values[3 * row], rows.values[3 * row + 1]});
    if (!std::isfinite(places.back()[0] + places.back()[1])) return false;
  }
  std::sort(places.begin(), places.end());
  const auto different = std::unique(places.begin(), places.end()) - places.begin();
  return 2 * static_cast<std::size_t>(different) > places.size();
}

}  // namespace ligne
