#include "plotting/paths/small_doubles.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "plotting/paths/path_length.hpp"
#include "plotting/paths/segment_distance.hpp"

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

/// Lines by the centre of their bounding boxes, in grid cells of one tolerance.
class LinesByMiddle {
 public:
  explicit LinesByMiddle(double tolerance) : tolerance_(tolerance) {}

  /// Whether a stored line lies on this one. If not, this one is stored, unless too many lines were compared.
  bool known(Line line) {
    Rect box;
    for (const Point2 p : line) box.extend(p);
    const Point2 middle = (box.min + box.max) * (0.5 / tolerance_);
    const Cell cell{std::floor(middle.x), std::floor(middle.y)};
    int compared = 0;
    for (double y = -1; y <= 1; ++y) {
      for (double x = -1; x <= 1; ++x) {
        const auto found = cells_.find({cell[0] + x, cell[1] + y});
        if (found == cells_.end()) continue;
        for (const Line other : found->second) {
          if (++compared > kMostCompared) return false;
          if (lies_on(line, other, tolerance_) && lies_on(other, line, tolerance_)) return true;
        }
      }
    }
    cells_[cell].push_back(line);
    return false;
  }

 private:
  using Cell = std::array<double, 2>;
  double tolerance_;
  std::map<Cell, std::vector<Line>> cells_;
};

}  // namespace

std::vector<char> small_doubles(std::span<const Point2> points, std::span<const std::uint32_t> begin, double tolerance_mm) {
  std::vector<char> doubled(begin.size() - 1, 0);
  LinesByMiddle lines(tolerance_mm);
  for (std::size_t i = 0; i + 1 < begin.size(); ++i) {
    const Line line = points.subspan(begin[i], begin[i + 1] - begin[i]);
    doubled[i] = is_small(line, tolerance_mm) && lines.known(line);
  }
  return doubled;
}

}  // namespace ligne
