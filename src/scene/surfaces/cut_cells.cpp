#include "scene/surfaces/cut_cells.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/parallel.hpp"
#include "scene/surfaces/cell_contours.hpp"
#include "scene/surfaces/grid_edges.hpp"

namespace ligne {
namespace {

/// Of the samples of a surface with poles, what is left out at either end, and what is added to the rest on either side.
constexpr double kLeftOut = 0.05, kAdded = 0.5;

/// A height that is no number has a corner left out of its cell; so has an edge that is broken.
bool all_count(const SurfacePoints& surface, const HeightWindow& window) {
  return std::all_of(surface.points.begin(), surface.points.end(), [&](const Point3& p) { return window.holds(p.z); });
}

/// Heights that reach so many times farther than what is left without poles may come from one.
constexpr double kFarOut = 4;
/// Steps of a climb, from the width of a cell down to what doubles tell apart, and the growth that makes a peak a pole.
constexpr int kMostSteps = 200;
constexpr double kPoleGrowth = 0x1p20;

/// Whether heights grow beyond bounds near a sample, upwards or downwards, against the range of all samples.
bool climbs_to_pole(const SurfacePoints& surface, std::size_t sample, double up, double range) {
  bool found = false;
  surface.function->use([&](HeightFunction::At& at) {
    const Point3 &low = surface.points.front(), &high = surface.points.back();
    const double step_x = surface.points[1].x - low.x, step_y = surface.points[surface.columns].y - low.y;
    Point3 best = surface.points[sample];
    double size = 1;
    for (int step = 0; step < kMostSteps && !found; ++step) {
      Point3 next = best;
      for (const int dy : {-1, 0, 1}) {
        for (const int dx : {-1, 0, 1}) {
          const double x = std::clamp(best.x + dx * size * step_x, low.x, high.x);
          const double y = std::clamp(best.y + dy * size * step_y, low.y, high.y), z = at(x, y);
          if (up * z > up * next.z) next = {x, y, z};
        }
      }
      if (next == best) size /= 2;
      best = next;
      found = up * best.z > kPoleGrowth * range;
    }
  });
  return found;
}

/// A pole at a point, which no line between samples goes through, is found from the highest and the lowest sample.
bool has_pole_at_a_point(const SurfacePoints& surface) {
  const HeightWindow usual = window_without_poles(surface);
  std::size_t lowest = 0, highest = 0;
  for (std::size_t k = 0; k < surface.points.size(); ++k) {
    if (!(surface.points[lowest].z <= surface.points[k].z) && std::isfinite(surface.points[k].z)) lowest = k;
    if (!(surface.points[highest].z >= surface.points[k].z) && std::isfinite(surface.points[k].z)) highest = k;
  }
  const double low = surface.points[lowest].z, high = surface.points[highest].z;
  if (!(high - low > kFarOut * (usual.high - usual.low))) return false;
  return climbs_to_pole(surface, lowest, -1, high - low) || climbs_to_pole(surface, highest, 1, high - low);
}

/// Puts what the rows of cells have found into one mesh.
void append(CellContours::Found& found, SurfaceMesh& mesh) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), found.points.begin(), found.points.end());
  for (std::array<std::uint32_t, 3>& triangle : found.triangles) {
    for (std::uint32_t& v : triangle) {
      if (v & CellContours::kOwn) v = first + (v & ~CellContours::kOwn);
    }
  }
  mesh.triangles.insert(mesh.triangles.end(), found.triangles.begin(), found.triangles.end());
  mesh.flags.insert(mesh.flags.end(), found.flags.begin(), found.flags.end());
}

}  // namespace

Irregularity find_irregularity(const SurfacePoints& surface, const HeightWindow& window) {
  const bool empty =
      std::none_of(surface.points.begin(), surface.points.end(), [&](const Point3& p) { return window.holds(p.z); });
  if (empty) return {false, false, true};
  const BrokenEdges broken = find_broken_edges(surface, window);
  const bool is_whole = window.low == HeightWindow{}.low && window.high == HeightWindow{}.high;
  const bool has_pole = broken.has_pole || (is_whole && has_pole_at_a_point(surface));
  return {has_pole || !broken.edges.empty() || !all_count(surface, window), has_pole, false};
}

HeightWindow window_of_samples(const SurfacePoints& surface) {
  double low = INFINITY, high = -INFINITY;
  for (const Point3& p : surface.points) {
    if (!std::isfinite(p.z)) continue;
    low = std::min(low, p.z);
    high = std::max(high, p.z);
  }
  return {low, high};
}

HeightWindow window_without_poles(const SurfacePoints& surface) {
  std::vector<double> heights;
  for (const Point3& p : surface.points) {
    if (std::isfinite(p.z)) heights.push_back(p.z);
  }
  if (heights.empty()) return {};
  const auto at = [&](double part) {
    const auto place = heights.begin() + static_cast<std::ptrdiff_t>(part * static_cast<double>(heights.size() - 1));
    std::nth_element(heights.begin(), place, heights.end());
    return *place;
  };
  const double low = at(kLeftOut), high = at(1 - kLeftOut), more = kAdded * (high - low);
  if (!(high > low)) return {};
  // Round numbers, since they stand at the axis: multiples of 5 at the second digit, as quotients of whole numbers.
  const double digits = std::floor(std::log10(high - low)) - 1, unit = std::pow(10, std::abs(digits));
  const auto rounded = [&](double height, double (*round)(double)) {
    const double tens = digits < 0 ? round(height * unit / 5) * 5 / unit : round(height / unit / 5) * 5 * unit;
    return tens;
  };
  HeightWindow window{rounded(low - more, [](double z) { return std::floor(z); }),
                      rounded(high + more, [](double z) { return std::ceil(z); })};
  const HeightWindow samples = window_of_samples(surface);
  return {std::max(window.low, samples.low), std::min(window.high, samples.high)};
}

std::vector<char> broken_cells(const SurfacePoints& surface) {
  const std::size_t width = surface.columns - 1, height = surface.rows - 1;
  std::vector<char> broken(width * height, 0);
  for (const BrokenEdge& found : find_broken_edges(surface, {}).edges) {
    const std::size_t i = found.edge.sample % surface.columns, j = found.edge.sample / surface.columns;
    // The cells on both sides, where there are any.
    const bool up = found.edge.along_column;
    const std::size_t before = up ? (i > 0 ? i - 1 : width) : (j > 0 ? j - 1 : height), behind = up ? i : j;
    for (const std::size_t side : {before, behind}) {
      if (side < (up ? width : height)) broken[up ? j * width + side : side * width + i] = 1;
    }
  }
  return broken;
}

SurfaceMesh make_cut_mesh(const SurfacePoints& surface, const HeightWindow& window) {
  SurfaceMesh mesh;
  mesh.name = surface.name;
  mesh.from_formula = surface.from_formula;
  mesh.vertices = surface.points;
  const BrokenEdges broken = find_broken_edges(surface, window);
  const CellContours cells(surface, window, broken.edges, mesh.vertices);
  std::vector<CellContours::Found> rows(surface.rows);
  parallel_for(surface.rows > 0 ? surface.rows - 1 : 0, [&](std::size_t j) { cells.cut_row(j, rows[j]); });
  for (CellContours::Found& found : rows) append(found, mesh);
  return mesh;
}

}  // namespace ligne
