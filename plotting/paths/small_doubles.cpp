#include "plotting/paths/small_doubles.hpp"

#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "geometry/nearest_on_segment.hpp"
#include "linework/map/line_cells.hpp"
#include "plotting/paths/path_length.hpp"

namespace ligne {
namespace {

/// Fraction of the tolerance within which sample points must lie. They are one tolerance apart, so a point between two
/// of them is at most the other half farther away.
constexpr double kPlacePart = 0.5;

using Line = std::span<const Point2>;

/// Largest mean segment length of a small line, in tolerances. Longer segments are left to the search by segments.
constexpr double kShortSegment = 2;

bool is_small(Line line, double tolerance) {
  const double length = path_length(line);
  return length <= kSmallLength * tolerance && length <= static_cast<double>(line.size() - 1) * kShortSegment * tolerance;
}

bool lies_on(Point2 p, Line line, double reach) {
  for (std::size_t k = 1; k < line.size(); ++k) {
    if (squared_distance(p, line[k - 1], line[k]) <= reach * reach) return true;
  }
  return false;
}

bool lies_on(Line line, Line other, double tolerance) {
  const double reach = kPlacePart * tolerance;
  for (std::size_t k = 1; k < line.size(); ++k) {
    const double steps = std::ceil(glm::distance(line[k - 1], line[k]) / tolerance);
    for (double step = 0; step <= steps; ++step) {
      if (!lies_on(glm::mix(line[k - 1], line[k], steps > 0 ? step / steps : 0), other, reach)) return false;
    }
  }
  return true;
}

/// The centre of the bounding box.
Point2 middle_of(Line line) {
  Rect box;
  for (const Point2 p : line) box.extend(p);
  return (box.min + box.max) * 0.5;
}

}  // namespace

std::vector<char> small_doubles(std::span<const Point2> points, std::span<const std::uint32_t> begin, const Lattice& lattice,
                                double tolerance_mm) {
  const auto line_at = [&](std::uint32_t i) { return points.subspan(begin[i], begin[i + 1] - begin[i]); };
  const double tolerance = tolerance_mm / lattice.step_mm;
  std::vector<char> doubled(begin.size() - 1, 0);
  LineCells middles(tolerance);
  for (std::uint32_t i = 0; i < doubled.size(); ++i) {
    const Line line = line_at(i);
    if (!is_small(line, tolerance_mm)) continue;
    const LatticePoint middle = lattice.snap(middle_of(line));
    int compared = 0;
    middles.near(middle, middle, kPlacePart * tolerance, [&](std::uint32_t other) {
      if (++compared > kMostCompared) return true;
      doubled[i] = lies_on(line, line_at(other), tolerance_mm) && lies_on(line_at(other), line, tolerance_mm);
      return doubled[i] != 0;
    });
    if (!doubled[i] && compared <= kMostCompared) middles.insert(i, middle, middle);
  }
  return doubled;
}

}  // namespace ligne
