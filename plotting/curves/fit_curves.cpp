/// Fits curves in rounds over the corners of a line, each on the parts that earlier rounds left:
/// 1. arcs through many corners that lie on an ellipse up to rounding,
/// 2. arcs within the tolerance,
/// 3. arcs through a few corners, up to rounding,
/// 4. arcs of known ellipses,
/// 5. straight pieces within the tolerance.
///
/// Without the first round an arc would begin on the line before it, within the tolerance, and would be bent for it. A
/// few corners of a noisy circle lie on some ellipse by chance, so round 3 comes after the whole circle.
///
/// A round goes along the line and takes the longest run from each corner on, found by doubling and bisection. Only runs
/// that turn one way are tried, so that zigzags cost nothing.

#include "plotting/curves/fit_curves.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <glm/geometric.hpp>

#include "base/parallel.hpp"
#include "geometry/simplify.hpp"

namespace ligne {
namespace {

/// Number of cells along the page. Adjustable.
constexpr double kCells = 32;

double side_of(const Rect& page) { return std::max(page.width(), page.height()); }

/// The lattice of a page, and of the chords that leave it.
Lattice lattice_around(const Rect& page) {
  const Point2 margin(side_of(page));
  return Lattice::covering({page.min - margin, page.max + margin});
}

/// Least and largest number of chords of an ellipse.
constexpr double kLeastChords = 8, kMostChords = 4096;

/// Distance by which rounding moves a point, mm: coordinates of single precision and of six digits on a page, and the
/// tenth of a micrometre that files keep. A point this near to a chord is not a corner.
constexpr double kRoundingMm = 0.0005;

/// Fewest corners of an arc in rounds 1, 2 and 3. Any five points lie on an ellipse or another conic.
constexpr std::size_t kMany = 10, kLeastWithin = 8, kFew = 6;

/// Fewest corners of an arc of a known ellipse. Two may be the ends of a line across it.
constexpr std::size_t kLeastOnKnown = 3;

/// Fewest corners by which an arc is extended within the tolerance: a single corner may be the end of a cut chord.
constexpr std::size_t kBeyond = 3;

/// Largest ratio of neighbouring steps in runs of fewer than kMany corners. More corners are proof enough.
constexpr double kUneven = 1.25;

/// Largest step between corners in eccentric angle, radians: twelve steps to the turn are a circle, ten are a polygon.
/// The limit lies between, since perspective makes steps uneven.
constexpr double kMostStep = 2 * std::numbers::pi / 11;

/// Largest angle between a chord and the tangent in the middle of its arc, radians. On an ellipse they are parallel.
/// Without this limit points within the tolerance would allow bumps.
constexpr double kMostTurn = 3 * std::numbers::pi / 180;

/// Smallest shorter radius, in tolerances: a more slender ellipse is a line there and back.
constexpr double kLeastRadius = 4;

/// Largest radius of an arc, mm. With a larger radius an arc as long as a page rises by less than a millimetre; it is
/// written as straight lines.
constexpr double kLargestRadiusMm = 100'000;

/// Largest sum of sweeps, radians: a whole turn and its rounding.
constexpr double kWholeTurn = 2 * std::numbers::pi + 1e-3;

/// Largest angle between a straight piece and a segment that it replaces, radians, for segments longer than kShort
/// tolerances. A shorter segment has no reliable direction.
constexpr double kStraightTurn = std::numbers::pi / 180;
constexpr double kShort = 10;

/// The limits of a round.
struct Round {
  double tolerance;
  std::size_t least;      ///< fewest corners of a run
  bool is_known = false;  ///< tries known ellipses instead of fitting one to the corners
};

/// An arc, and the corner at which it ends.
struct ArcTo {
  std::size_t last = 0;  ///< 0: there is no arc
  EllipticArc arc{};
};

class CurveFit {
 public:
  CurveFit(std::vector<Point2> corners, const CurveLimits& limits)
      : corners_(std::move(corners)), limits_(limits), arcs_(corners_.size()) {}

  CurvedPath run() {
    const double rounding = std::min(kRoundingMm, limits_.tolerance_mm);
    find_arcs({rounding, kMany});
    find_arcs({limits_.tolerance_mm, kLeastWithin});
    find_arcs({rounding, kFew});
    if (limits_.known) find_arcs({limits_.tolerance_mm, kLeastOnKnown, true});
    CurvedPath path{corners_.front()};
    std::size_t free = 0;  // the corner up to which no arc begins
    for (std::size_t i = 0; i + 1 < corners_.size();) {
      if (arcs_[i].last > i) {
        path.pieces.push_back({corners_[arcs_[i].last], arcs_[i].arc});
        i = arcs_[i].last;
      } else {
        free = std::max(free, i + 1);
        while (free + 1 < corners_.size() && arcs_[free].last == 0) ++free;
        i = longest(i, free, 2, [&](std::size_t last) { return straight(i, last); });
        path.pieces.push_back({corners_[i]});
      }
    }
    return path;
  }

  /// The last corner of the arc with which the line begins; 0 if it begins straight. Valid after run().
  std::size_t first_arc_end() const { return arcs_.front().last; }

 private:
  /// Finds the longest accepted run of at least `least` corners from `first` to at most `end`. Returns its last corner,
  /// or `first` if the shortest of these runs is not accepted.
  std::size_t longest(std::size_t first, std::size_t end, std::size_t least, FunctionRef<bool(std::size_t)> accepted) const {
    std::size_t good = first, bad = end + 1;
    for (std::size_t count = least; first + count - 1 < bad; count *= 2) {
      if (!accepted(first + count - 1)) {
        bad = first + count - 1;
        break;
      }
      good = first + count - 1;
    }
    if (good == first) return first;
    while (good + 1 < bad) {
      const std::size_t middle = good + (bad - good) / 2;
      (accepted(middle) ? good : bad) = middle;
    }
    return good;
  }

  /// Sign of the turn at a corner inside the line.
  int turn(std::size_t i) const {
    const double area = cross(corners_[i] - corners_[i - 1], corners_[i + 1] - corners_[i]);
    return area > 0 ? 1 : area < 0 ? -1 : 0;
  }

  void find_arcs(const Round& round) {
    std::size_t end = 0;  // the corners up to here turn one way, and none is inside an arc
    for (std::size_t i = 0; i + 1 < corners_.size();) {
      if (arcs_[i].last > i) {
        i = arcs_[i].last;
        continue;
      }
      const bool new_chain = end < i + 2;
      if (new_chain) {
        end = i + 1;
        const int way = end + 1 < corners_.size() ? turn(end) : 0;
        while (end + 1 < corners_.size() && arcs_[end].last == 0 && way != 0 && turn(end) == way) ++end;
      }
      const ArcTo found = round.is_known ? longest_known(i, end, round) : longest_fitted(i, end, new_chain, round);
      if (found.last > i) arcs_[i] = found;
      i = std::max(found.last, i + 1);
    }
  }

  /// The longest arc from the corner `first` to at most `end` that fits the corners.
  ArcTo longest_fitted(std::size_t first, std::size_t end, bool new_chain, Round round) const {
    ArcTo best;
    const auto fits = [&](std::size_t to) {
      const std::span<const Point2> run(corners_.data() + first, to - first + 1);
      Ellipse ellipse;
      std::optional<EllipticArc> arc;
      if (fit_circle(run, ellipse)) arc = arc_on(ellipse, first, to, round);
      if (!arc && fit_ellipse(run, ellipse)) arc = arc_on(ellipse, first, to, round);
      if (arc) best = {to, *arc};
      return arc.has_value();
    };
    // The whole chain is tried first: noise bends a short arc more than a whole circle.
    const bool whole = new_chain && end + 1 >= first + round.least && fits(end);
    if (!whole && longest(first, end, round.least, fits) == first) return {};
    // Where rounding is worse than usual, the arc is extended to corners within the tolerance.
    round.tolerance = limits_.tolerance_mm;
    longest(first, end, best.last - first + 1 + kBeyond, fits);
    return best;
  }

  /// The longest arc of a known ellipse from the corner `first` to at most `end`.
  ArcTo longest_known(std::size_t first, std::size_t end, const Round& round) const {
    ArcTo best;
    for (const std::uint32_t number : limits_.known->near(corners_[first])) {
      longest(first, end, round.least, [&](std::size_t to) {
        const auto arc = arc_on((*limits_.known)[number], first, to, round);
        if (arc && to > best.last) best = {to, *arc};
        return arc.has_value();
      });
    }
    return best;
  }

  /// The arc of the ellipse that runs along the corners from `first` to `last`, if it keeps the limits.
  std::optional<EllipticArc> arc_on(const Ellipse& ellipse, std::size_t first, std::size_t last, const Round& round) const {
    if (ellipse.radii.y < kLeastRadius * round.tolerance || ellipse.radii.x > kLargestRadiusMm) return {};
    const bool positive = turn(first + 1) > 0, may_be_uneven = round.is_known || last - first + 1 >= kMany;
    const EllipseFrame frame(ellipse);
    Point2 unit = frame.to_unit(corners_[first]);
    if (frame.distance(unit) > round.tolerance) return {};
    EllipticArc arc{ellipse, frame.nearest_angle(corners_[first]), 0};
    arc.sweep = angle_of(unit) - arc.from;
    double before = 0;  // size of the last step
    for (std::size_t i = first; i <= last; ++i) {
      if (frame.distance(unit) > round.tolerance) return {};
      if (i == last) break;
      const Point2 next = frame.to_unit(corners_[i + 1]), chord = corners_[i + 1] - corners_[i];
      const double from = angle_of(unit), step = std::remainder(angle_of(next) - from, 2 * std::numbers::pi);
      const double size = std::abs(step);
      if ((step > 0) != positive || size > kMostStep) return {};
      const Point2 tangent = (positive ? 1.0 : -1.0) * frame.tangent_at(from + step / 2);
      if (std::abs(cross(tangent, chord)) > std::tan(kMostTurn) * glm::dot(tangent, chord)) return {};
      // The longer radius is used at every step, so that an ellipse becomes an arc as a whole or not at all.
      if (ellipse.radii.x * (1 - std::cos(step / 2)) > limits_.most_rise_mm) return {};
      if (!may_be_uneven && i > first && std::max(before, size) > kUneven * std::min(before, size)) return {};
      arc.sweep += step;
      before = size;
      unit = next;
    }
    arc.sweep += frame.nearest_angle(corners_[last]) - angle_of(unit);
    return std::abs(arc.sweep) <= kWholeTurn ? std::optional(arc) : std::nullopt;
  }

  bool straight(std::size_t first, std::size_t last) const {
    const Point2 along = corners_[last] - corners_[first];
    const double length = glm::length(along);
    if (last == first + 1) return true;
    if (!(length > 0)) return false;
    for (std::size_t i = first; i < last; ++i) {
      const Point2 offset = corners_[i] - corners_[first], segment = corners_[i + 1] - corners_[i];
      const double at = glm::dot(offset, along) / length;
      if (std::abs(cross(along, offset)) / length > limits_.tolerance_mm) return false;
      if (at < -limits_.tolerance_mm || at > length + limits_.tolerance_mm) return false;
      if (glm::length(segment) > kShort * limits_.tolerance_mm &&
          std::abs(cross(along, segment)) > std::tan(kStraightTurn) * glm::dot(along, segment)) {
        return false;
      }
    }
    return true;
  }

  std::vector<Point2> corners_;
  CurveLimits limits_;
  std::vector<ArcTo> arcs_;  ///< by the corner at which they begin
};

/// Rotates a closed line so that it begins at `corner`.
void begin_at(std::vector<Point2>& line, std::size_t corner) {
  line.pop_back();
  std::rotate(line.begin(), line.begin() + static_cast<std::ptrdiff_t>(corner), line.end());
  line.push_back(line.front());
}

/// Index at which the longest segment begins. Arcs have shorter segments, so it lies inside an arc only if the whole
/// line is arcs.
std::size_t longest_segment(const std::vector<Point2>& line) {
  std::size_t longest = 0;
  for (std::size_t i = 1; i + 1 < line.size(); ++i) {
    if (glm::length(line[i + 1] - line[i]) > glm::length(line[longest + 1] - line[longest])) longest = i;
  }
  return longest;
}

std::vector<Point2> corners_of(std::span<const Point2> line) {
  std::vector<Point2> corners;
  for (const std::uint32_t i : simplified(line, kRoundingMm)) {
    if (corners.empty() || line[i] != corners.back()) corners.push_back(line[i]);
  }
  return corners;
}

}  // namespace

CurvedPath fit_curves(std::span<const Point2> line, const CurveLimits& limits) {
  if (line.empty()) return {};
  std::vector<Point2> corners = corners_of(line);
  if (corners.size() == 1) {
    // A dot, or a line shorter than rounding.
    CurvedPath dot{line.front()};
    if (line.size() > 1) dot.pieces.push_back({line.back()});
    return dot;
  }
  const bool closed = !limits.start_stays && line.size() > 3 && line.front() == line.back() && corners.size() > 3;
  if (closed) {
    begin_at(corners, longest_segment(corners));
    corners = corners_of(corners);  // the former start may be no corner
  }
  CurveFit fit(corners, limits);
  CurvedPath path = fit.run();
  if (closed && path.pieces.front().arc && path.pieces.back().arc) {
    // The line may begin inside an arc. The end of its first arc is inside none, unless the whole line is one arc.
    begin_at(corners, fit.first_arc_end() % (corners.size() - 1));
    CurvedPath other = CurveFit(std::move(corners), limits).run();
    if (other.pieces.size() < path.pieces.size()) path = std::move(other);
  }
  path.closed = closed;
  return path;
}

bool may_be_curved(const Layer& layer) { return layer.name != "text" && layer.name != "hatch" && layer.name != "debug"; }

KnownEllipses::KnownEllipses(std::vector<Ellipse> ellipses, const Rect& page)
    : ellipses_(std::move(ellipses)), lattice_(lattice_around(page)), cells_(side_of(page) / kCells / lattice_.step_mm) {
  for (std::uint32_t i = 0; i < ellipses_.size(); ++i) file(i, page);
}

/// Files the chords of an ellipse that may meet the page, about one for each cell that it passes.
void KnownEllipses::file(std::uint32_t ellipse, const Rect& page) {
  const Ellipse& e = ellipses_[ellipse];
  const double cell_mm = side_of(page) / kCells;
  const double count = std::clamp(std::ceil(2 * std::numbers::pi * e.radii.x / cell_mm), kLeastChords, kMostChords);
  const double step = 2 * std::numbers::pi / count, rise_mm = e.radii.x * (1 - std::cos(step / 2));
  rise_mm_ = std::max(rise_mm_, rise_mm);
  const Point2 margin(rise_mm + kNearMm);
  const EllipseFrame frame(e);
  Point2 from, to = frame.point_at(0);
  for (double k = 0; k < count; ++k) {
    Rect chord;
    from = std::exchange(to, frame.point_at((k + 1) * step));
    for (const Point2 p : {from, to}) chord.extend(p - margin), chord.extend(p + margin);
    const bool is_outside =
        chord.max.x < page.min.x || chord.max.y < page.min.y || chord.min.x > page.max.x || chord.min.y > page.max.y;
    if (!is_outside) cells_.insert(ellipse, lattice_.snap(from), lattice_.snap(to));
  }
}

std::vector<std::uint32_t> KnownEllipses::near(Point2 p) const {
  std::vector<std::uint32_t> found;
  const LatticePoint at = lattice_.snap(p);
  cells_.near(at, at, (kNearMm + rise_mm_) / lattice_.step_mm, [&](std::uint32_t i) {
    found.push_back(i);
    return false;
  });
  std::ranges::sort(found);
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

}  // namespace ligne
