#include "scene/surfaces/surface_curve.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "scene/surfaces/formula/formula_evaluator.hpp"

namespace ligne {
namespace {

constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();
constexpr std::array<std::string_view, 1> kCurveVariables{"t"};

double column_at(const SurfacePoints& surface, std::size_t i) { return surface.points[i].x; }
double row_at(const SurfacePoints& surface, std::size_t j) { return surface.points[j * surface.columns].y; }

/// The cell of an axis that contains a place; the last cell includes its end.
template <class At>
std::optional<std::size_t> cell_of(std::size_t count, At at, double place) {
  if (count < 2 || !(at(0) <= place && place <= at(count - 1))) return std::nullopt;
  std::size_t low = 0, high = count - 1;
  while (high - low > 1) {
    const std::size_t middle = (low + high) / 2;
    (at(middle) <= place ? low : high) = middle;
  }
  return low;
}

struct Cell {
  std::size_t i, j;
};

std::optional<Cell> cell_at(const SurfacePoints& surface, double x, double y) {
  const auto i = cell_of(
      surface.columns, [&](std::size_t k) { return column_at(surface, k); }, x);
  const auto j = cell_of(
      surface.rows, [&](std::size_t k) { return row_at(surface, k); }, y);
  if (!i || !j) return std::nullopt;
  if (!surface.left_out.empty() && surface.left_out[*j * (surface.columns - 1) + *i]) return std::nullopt;
  return Cell{*i, *j};
}

/// Fractions of the way through a cell in x and y.
Point2 fractions(const SurfacePoints& surface, Cell c, double x, double y) {
  const double x0 = column_at(surface, c.i), x1 = column_at(surface, c.i + 1);
  const double y0 = row_at(surface, c.j), y1 = row_at(surface, c.j + 1);
  return {(x - x0) / (x1 - x0), (y - y0) / (y1 - y0)};
}

/// Height of the triangles of a cell at a place; NaN in a hole.
double height_in(const SurfacePoints& surface, Cell c, double x, double y, bool upper) {
  const auto z = [&](std::size_t di, std::size_t dj) { return surface.points[(c.j + dj) * surface.columns + c.i + di].z; };
  // A cell with a hole at a corner has no triangles.
  if (!std::isfinite(z(0, 0) + z(1, 0) + z(0, 1) + z(1, 1))) return kNoNumber;
  const Point2 f = fractions(surface, c, x, y);
  if (!upper) return z(0, 0) + f.x * (z(1, 0) - z(0, 0)) + f.y * (z(0, 1) - z(0, 0));
  return z(1, 1) + (1 - f.x) * (z(0, 1) - z(1, 1)) + (1 - f.y) * (z(1, 0) - z(1, 1));
}

/// Adds the parameters of a segment at which it reaches positions of an axis.
template <class At>
void add_crossings(std::size_t count, At at, double from, double to, std::vector<double>& parts) {
  if (from == to) return;
  const double low = std::min(from, to), high = std::max(from, to);
  std::size_t begin = 0, end = count;
  while (begin < end) {
    const std::size_t middle = (begin + end) / 2;
    if (at(middle) > low) {
      end = middle;
    } else {
      begin = middle + 1;
    }
  }
  for (std::size_t k = begin; k < count && at(k) < high; ++k) parts.push_back((at(k) - from) / (to - from));
}

}  // namespace

std::vector<Point3> curve_points(const std::array<std::string, 3>& formulas, double from, double to, std::size_t count) {
  constexpr std::array<const char*, 3> kNames{"curve: formula of x", "curve: formula of y", "curve: formula of z"};
  std::array<std::unique_ptr<FormulaEvaluator>, 3> evaluators;
  for (std::size_t k = 0; k < 3; ++k) {
    if (k == 2 && formulas[k] == kOnSurface) continue;
    evaluators[k] = std::make_unique<FormulaEvaluator>(prepare_formula(formulas[k], {kCurveVariables, kNames[k]}));
  }
  std::vector<Point3> points;
  for (std::size_t i = 0; i < count; ++i) {
    const double t = from + (to - from) * static_cast<double>(i) / static_cast<double>(count - 1);
    Point3 p{kNoNumber, kNoNumber, kNoNumber};
    for (int k = 0; k < 3; ++k) {
      if (evaluators[static_cast<std::size_t>(k)]) p[k] = (*evaluators[static_cast<std::size_t>(k)])(std::array{t});
    }
    const bool whole = std::isfinite(p.x) && std::isfinite(p.y) && (!evaluators[2] || std::isfinite(p.z));
    points.push_back(whole ? p : Point3{kNoNumber, kNoNumber, kNoNumber});
  }
  return points;
}

std::optional<double> height_at(const SurfacePoints& surface, double x, double y) {
  const auto cell = cell_at(surface, x, y);
  if (!cell) return std::nullopt;
  const Point2 f = fractions(surface, *cell, x, y);
  const double z = height_in(surface, *cell, x, y, f.x + f.y > 1);
  return std::isfinite(z) ? std::optional(z) : std::nullopt;
}

void drape(const SurfacePoints& surface, const Point3& from, const Point3& to,
           std::vector<std::array<Point3, 2>>& segments) {
  std::vector<double> parts{0, 1};
  add_crossings(
      surface.columns, [&](std::size_t k) { return column_at(surface, k); }, from.x, to.x, parts);
  add_crossings(
      surface.rows, [&](std::size_t k) { return row_at(surface, k); }, from.y, to.y, parts);
  std::sort(parts.begin(), parts.end());
  const auto at = [&](double s) { return Point2{from.x + s * (to.x - from.x), from.y + s * (to.y - from.y)}; };
  for (std::size_t k = 1; k < parts.size(); ++k) {
    const double s0 = parts[k - 1], s1 = parts[k];
    const Point2 a = at(s0), b = at(s1), middle = at((s0 + s1) / 2);
    const auto cell = s0 < s1 ? cell_at(surface, middle.x, middle.y) : std::nullopt;
    if (!cell) continue;
    // The diagonal divides the cell where the two fractions add to 1.
    const Point2 fa = fractions(surface, *cell, a.x, a.y), fb = fractions(surface, *cell, b.x, b.y);
    const double da = fa.x + fa.y - 1, db = fb.x + fb.y - 1;
    std::vector<Point2> way{a, b};
    if ((da < 0 && db > 0) || (da > 0 && db < 0)) way.insert(way.begin() + 1, a + (b - a) * (da / (da - db)));
    for (std::size_t n = 1; n < way.size(); ++n) {
      const Point2 p = way[n - 1], q = way[n];
      const Point2 f = fractions(surface, *cell, (p.x + q.x) / 2, (p.y + q.y) / 2);
      const bool upper = f.x + f.y > 1;
      const double zp = height_in(surface, *cell, p.x, p.y, upper), zq = height_in(surface, *cell, q.x, q.y, upper);
      if (std::isfinite(zp + zq)) segments.push_back({Point3{p.x, p.y, zp}, Point3{q.x, q.y, zq}});
    }
  }
}

}  // namespace ligne
