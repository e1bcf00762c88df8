#include "scene/surfaces/contours/cut_cells.hpp"

#include <algorithm>
#include <cmath>

#include "base/parallel.hpp"
#include "scene/surfaces/contours/cell_contours.hpp"

namespace ligne {
namespace {

/// Quantile of the samples of a surface with poles that is trimmed at each end; margin added at each end, relative to
/// the remaining range.
constexpr double kLeftOut = 0.05, kAdded = 0.5;

/// Number of rows and of columns that are sampled to estimate the usual range of heights.
constexpr std::size_t kSampledRows = 256;

/// Distance of heights at a pole from the usual range of heights, relative to that range.
constexpr double kBeyondUsual = 0.5;

/// Ratio of the full range of heights to the trimmed one above which a pole is searched.
constexpr double kFarOut = 4;
/// Largest number of steps of a climb, from the width of a cell down to the resolution of doubles.
constexpr int kMostSteps = 200;

/// Whether heights near a sample grow without bound, upwards or downwards, compared to the range of all samples.
bool climbs_to_pole(const HeightSource& heights, const HeightFunction& function, const Point3& sample, double up,
                    double range) {
  const std::vector<double>&grid_x = heights.x(), &grid_y = heights.y();
  bool found = false;
  function.use([&](HeightFunction::At& at) {
    Point3 best = sample;
    double size = 1;
    for (int step = 0; step < kMostSteps && !found; ++step) {
      Point3 next = best;
      for (const int dy : {-1, 0, 1}) {
        for (const int dx : {-1, 0, 1}) {
          const double x = std::clamp(best.x + dx * size * (grid_x[1] - grid_x[0]), grid_x.front(), grid_x.back());
          const double y = std::clamp(best.y + dy * size * (grid_y[1] - grid_y[0]), grid_y.front(), grid_y.back());
          const double z = at(x, y);
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

/// Whether heights that seem to grow without bound leave the usual range. Those of sin(1/x) do not.
bool leaves_usual_range(const HeightWindow& poles, const HeightSource& heights) {
  if (poles.low > poles.high) return false;
  const HeightWindow usual = window_without_poles(heights);
  const double beyond = kBeyondUsual * (usual.high - usual.low);
  return poles.low < usual.low - beyond || poles.high > usual.high + beyond;
}

/// Searches a pole at a single point, which no line between samples meets, by climbing from the highest and the lowest
/// sample.
bool has_pole_at_a_point(const HeightSource& heights, const HeightFunction& function, const SampleSpan& span) {
  const HeightWindow usual = window_without_poles(heights);
  if (!(span.range() > kFarOut * (usual.high - usual.low))) return false;
  return climbs_to_pole(heights, function, {span.lowest.x, span.lowest.y, span.low}, -1, span.range()) ||
         climbs_to_pole(heights, function, {span.highest.x, span.highest.y, span.high}, 1, span.range());
}

/// Appends the result of a row of cells to the mesh.
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

Irregularity find_irregularity(const HeightSource& heights, const HeightFunction& function, const HeightWindow& window) {
  const SampleSpan span = span_of_samples(heights, window);
  if (!span.any) return {false, false, true, span};
  const BrokenEdges broken = find_broken_edges(heights, function, window, span.range());
  const bool is_whole = window.low == HeightWindow{}.low && window.high == HeightWindow{}.high;
  const bool has_pole = !function.is_continuous() && (leaves_usual_range(broken.poles, heights) ||
                                                      (is_whole && has_pole_at_a_point(heights, function, span)));
  return {has_pole || !broken.edges.empty() || !span.all, has_pole, false, span};
}

HeightWindow window_of_samples(const HeightSource& heights) {
  const SampleSpan span = span_of_samples(heights, {});
  return {span.low, span.high};
}

HeightWindow window_without_poles(const HeightSource& source) {
  const std::size_t columns = source.x().size(), rows = source.y().size();
  const std::size_t row_step = rows / kSampledRows + 1, column_step = columns / kSampledRows + 1;
  std::vector<double> heights, row(columns);
  for (std::size_t j = 0; j < rows; j += row_step) {
    source.read_row(j, row);
    for (std::size_t i = 0; i < columns; i += column_step) {
      if (std::isfinite(row[i])) heights.push_back(row[i]);
    }
  }
  if (heights.empty()) return window_of_samples(source);
  const auto at = [&](double part) {
    const auto place = heights.begin() + static_cast<std::ptrdiff_t>(part * static_cast<double>(heights.size() - 1));
    std::nth_element(heights.begin(), place, heights.end());
    return *place;
  };
  const double low = at(kLeftOut), high = at(1 - kLeftOut), more = kAdded * (high - low);
  if (!(high > low)) return window_of_samples(source);
  // Round numbers, since they stand at the axis: multiples of 5 in the second digit, computed as quotients of integers.
  const double digits = std::floor(std::log10(high - low)) - 1, unit = std::pow(10, std::abs(digits));
  const auto rounded = [&](double height, double (*round)(double)) {
    return digits < 0 ? round(height * unit / 5) * 5 / unit : round(height / unit / 5) * 5 * unit;
  };
  HeightWindow window{rounded(low - more, [](double z) { return std::floor(z); }),
                      rounded(high + more, [](double z) { return std::ceil(z); })};
  const HeightWindow samples = window_of_samples(source);
  return {std::max(window.low, samples.low), std::min(window.high, samples.high)};
}

std::vector<char> broken_cells(const HeightSource& heights, const HeightFunction& function) {
  const std::size_t columns = heights.x().size(), width = columns - 1, height = heights.y().size() - 1;
  std::vector<char> broken(width * height, 0);
  for (const BrokenEdge& found : find_broken_edges(heights, function, {}, span_of_samples(heights, {}).range()).edges) {
    const std::size_t i = found.edge.sample % columns, j = found.edge.sample / columns;
    // The cells on both sides, if they exist.
    const bool up = found.edge.along_column;
    const std::size_t before = up ? (i > 0 ? i - 1 : width) : (j > 0 ? j - 1 : height), behind = up ? i : j;
    for (const std::size_t side : {before, behind}) {
      if (side < (up ? width : height)) broken[up ? j * width + side : side * width + i] = 1;
    }
  }
  return broken;
}

SurfaceMesh make_cut_mesh(const SurfacePoints& surface, const HeightSource& heights, const HeightWindow& window) {
  SurfaceMesh mesh{.name = surface.name, .from_formula = surface.from_formula, .vertices = surface.points};
  const double range = span_of_samples(heights, window).range();
  const BrokenEdges broken = find_broken_edges(heights, *surface.function, window, range);
  const CellContours cells(surface, window, range, broken.edges, mesh.vertices);
  std::vector<CellContours::Found> rows(surface.rows);
  parallel_for(surface.rows > 0 ? surface.rows - 1 : 0, [&](std::size_t j) { cells.cut_row(j, rows[j]); });
  for (CellContours::Found& found : rows) append(found, mesh);
  return mesh;
}

}  // namespace ligne
