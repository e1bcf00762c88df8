#include "scene/surfaces/grid_edges.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/parallel.hpp"

namespace ligne {
namespace {

/// Steps between samples are out of step, and the formula is asked, when they differ from those beside them by more than
/// this part of the larger one ...
constexpr double kOutOfStep = 0.25;
/// ... and by more than this part of the range of heights: less is no stroke on any page.
constexpr double kLeastStep = 0x1p-20;

/// Six samples in a row, of which the middle two are the edge's ends; NaN where there is none that counts.
using Neighbours = std::array<double, 6>;

bool is_out_of_step(const Neighbours& z, double least) {
  std::array<double, 5> step{};
  for (std::size_t k = 0; k < step.size(); ++k) step[k] = z[k + 1] - z[k];
  const double here = step[2];
  double before = step[1], behind = step[3];
  if (std::isnan(before)) before = behind;
  if (std::isnan(behind)) behind = before;
  if (std::isnan(before)) return true;
  const double larger = std::max(std::abs(before), std::abs(behind));
  if (std::abs(here - (before + behind) / 2) > kOutOfStep * larger + least) return true;
  // Up and down again, more steeply than farther out: a pole may stand between the samples.
  if (!((before > 0) != (behind > 0)) || std::isnan(step[0]) || std::isnan(step[4])) return false;
  return std::abs(before - behind) > std::abs(step[0]) + std::abs(step[4]) + least;
}

class EdgeFinder {
 public:
  EdgeFinder(const SurfacePoints& surface, const HeightWindow& window)
      : surface_(surface), window_(window), range_(range_of_heights(surface, window)) {}

  /// The edges that begin in row j.
  void find(std::size_t j, LineBreaks& breaks, std::vector<BrokenEdge>& found) const {
    for (std::size_t i = 0; i < surface_.columns; ++i) {
      const std::size_t k = j * surface_.columns + i;
      if (i + 1 < surface_.columns) look_at({k, false}, i, surface_.columns, 1, breaks, found);
      if (j + 1 < surface_.rows) look_at({k, true}, j, surface_.rows, surface_.columns, breaks, found);
    }
  }

 private:
  double height(std::size_t k) const { return surface_.points[k].z; }

  /// `place` of `count` along the line, samples `step` apart.
  void look_at(GridEdge edge, std::size_t place, std::size_t count, std::size_t step, LineBreaks& breaks,
               std::vector<BrokenEdge>& found) const {
    const Point3 &a = surface_.points[edge.sample], &b = surface_.points[edge.sample + step];
    const bool start = window_.holds(a.z), end = window_.holds(b.z);
    bool may_jump = false;
    if (start && end) {
      Neighbours z;
      for (std::size_t k = 0; k < z.size(); ++k) {
        const bool inside = place + k >= 2 && place + k < count + 2;
        const double there = inside ? height(edge.sample + k * step - 2 * step) : NAN;
        z[k] = window_.holds(there) ? there : NAN;
      }
      may_jump = is_out_of_step(z, kLeastStep * range_);
      if (!may_jump) return;
    } else if (!start && !end && !(std::isfinite(a.z) && std::isfinite(b.z) && (a.z < window_.low) != (b.z < window_.low))) {
      return;
    }
    std::vector<LinePiece> pieces = breaks.pieces(a, b, may_jump, kLeastHeightPart * range_);
    const bool is_whole = pieces.size() == 1 && pieces[0].from_start && pieces[0].to_end;
    if (!is_whole) found.push_back({edge, std::move(pieces)});
  }

  const SurfacePoints& surface_;
  HeightWindow window_;
  double range_;
};

}  // namespace

double range_of_heights(const SurfacePoints& surface, const HeightWindow& window) {
  double low = INFINITY, high = -INFINITY;
  for (const Point3& p : surface.points) {
    if (!window.holds(p.z)) continue;
    low = std::min(low, p.z);
    high = std::max(high, p.z);
  }
  return low < high ? high - low : 0;
}

BrokenEdges find_broken_edges(const SurfacePoints& surface, const HeightWindow& window) {
  const EdgeFinder finder(surface, window);
  std::vector<std::vector<BrokenEdge>> rows(surface.rows);
  std::vector<char> poles(surface.rows, 0);
  parallel_for(surface.rows, [&](std::size_t j) {
    surface.function->use([&](HeightFunction::At& at) {
      LineBreaks breaks(at, window);
      finder.find(j, breaks, rows[j]);
      poles[j] = breaks.has_pole();
    });
  });
  BrokenEdges all;
  for (std::size_t j = 0; j < rows.size(); ++j) {
    std::move(rows[j].begin(), rows[j].end(), std::back_inserter(all.edges));
    all.has_pole = all.has_pole || poles[j];
  }
  return all;
}

}  // namespace ligne
