#include "picture/surface/curve_distance.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace ligne {
namespace {

constexpr std::size_t kFewestCurves = 8;

}  // namespace

std::size_t stride_apart(const GridOnPage& grid, const View& view, double pen_width_mm) {
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
  const std::size_t most = std::max<std::size_t>(1, (std::min(grid.columns, grid.rows) - 1) / (kFewestCurves - 1));
  const double stride = std::ceil(kCurveDistance * pen_width_mm / least);
  return stride >= 1 && stride < static_cast<double>(most) ? static_cast<std::size_t>(stride) : stride >= 1 ? most : 1;
}

}  // namespace ligne
