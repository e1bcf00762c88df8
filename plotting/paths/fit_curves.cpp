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

#include "plotting/paths/fit_curves.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include <glm/geometric.hpp>

#include "base/parallel.hpp"
#include "plotting/paths/simplify.hpp"
#include "plotting/writers/number_text.hpp"

namespace ligne {
namespace {

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

/// Sweep of a written arc, radians: about three arcs to a turn. A reader derives the centre from the two ends, and near
/// half a turn any rounding of the radii would move it far.
constexpr double kPartSweep = 2 * std::numbers::pi / 3 + 0.01;

/// Largest sum of sweeps, radians: a whole turn and its rounding.
constexpr double kWholeTurn = 2 * std::numbers::pi + 1e-3;

/// Largest angle between a straight piece and a segment that it replaces, radians, for segments longer than kShort
/// tolerances. A shorter segment has no reliable direction.
constexpr double kStraightTurn = std::numbers::pi / 180;
constexpr double kShort = 10;

double rounded(double value) {
  const auto units = static_cast<double>(power_of_ten(kArcDecimals));
  return std::round(value * units) / units;
}

/// The limits of a round.
struct Round {
  double tolerance;
  std::size_t least;      ///< fewest corners of a run
  bool is_known = false;  ///< the ellipse is not fitted to the corners
};

/// The pieces of one run of corners that lies on an ellipse: where each ends, and its arc.
using Arcs = std::vector<std::pair<std::size_t, EllipticArc>>;

class CurveFit {
 public:
  CurveFit(std::vector<Point2> corners, const CurveLimits& limits)
      : corners_(std::move(corners)), limits_(limits), arc_to_(corners_.size()) {}

  CurvedPath run() {
    const double rounding = std::min(kRoundingMm, limits_.tolerance_mm);
    find_arcs({rounding, kMany});
    find_arcs({limits_.tolerance_mm, kLeastWithin});
    find_arcs({rounding, kFew});
    if (limits_.known) find_known_arcs();
    CurvedPath path{corners_.front()};
    std::size_t free = 0;  // the corner up to which no arc begins
    for (std::size_t i = 0; i + 1 < corners_.size();) {
      if (arc_to_[i].first > i) {
        path.pieces.push_back({corners_[arc_to_[i].first], arc_to_[i].second});
        i = arc_to_[i].first;
      } else {
        free = std::max(free, i + 1);
        while (free + 1 < corners_.size() && arc_to_[free].first == 0) ++free;
        i = longest(i, free, 2, [&](std::size_t last) { return straight(i, last); });
        path.pieces.push_back({corners_[i]});
      }
    }
    return path;
  }

  /// The last corner of the run of arcs with which the line begins; 0 if it begins straight. Valid after run().
  std::size_t first_run_end() const { return first_end_; }

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
      if (arc_to_[i].first > i) {
        i = arc_to_[i].first;
        continue;
      }
      const bool new_chain = end < i + 2;
      if (new_chain) {
        end = i + 1;
        const int way = end + 1 < corners_.size() ? turn(end) : 0;
        while (end + 1 < corners_.size() && arc_to_[end].first == 0 && way != 0 && turn(end) == way) ++end;
      }
      Arcs arcs, best;
      double tolerance = round.tolerance;
      const auto fits = [&](std::size_t to) {
        if (!on_ellipse(i, to, {tolerance, round.least}, arcs)) return false;
        best = arcs;
        return true;
      };
      // The whole chain is tried first: noise bends a short arc more than a whole circle.
      const bool whole = new_chain && end + 1 >= i + round.least && fits(end);
      std::size_t last = whole ? end : longest(i, end, round.least, fits);
      if (last == i) {
        ++i;
        continue;
      }
      // Where rounding is worse than usual, the arc is extended to corners within the tolerance.
      tolerance = limits_.tolerance_mm;
      last = std::max(last, longest(i, end, last - i + 1 + kBeyond, fits));
      if (i == 0) first_end_ = last;
      for (const auto& [to, arc] : best) {
        arc_to_[i] = {to, arc};
        i = to;
      }
    }
  }

  /// Takes the longest arc of a known ellipse from each corner on.
  void find_known_arcs() {
    const Round round{limits_.tolerance_mm, kLeastOnKnown, true};
    for (std::size_t i = 0; i + 1 < corners_.size();) {
      if (arc_to_[i].first > i) {
        i = arc_to_[i].first;
        continue;
      }
      std::size_t last = i;
      Arcs best;
      for (const std::uint32_t number : limits_.known->near(corners_[i])) {
        const auto is_on = [&](std::size_t k) { return limits_.known->is_on(number, corners_[k], round.tolerance); };
        std::size_t end = i;  // the last corner of the run on this ellipse
        if (!is_on(i)) continue;
        while (end + 1 < corners_.size() && arc_to_[end].first == 0 && is_on(end + 1)) ++end;
        if (end <= last) continue;
        Arcs arcs, longest_arcs;
        const auto fits = [&](std::size_t to) {
          if (!accepted(i, to, (*limits_.known)[number], round, arcs)) return false;
          longest_arcs = arcs;
          return true;
        };
        const std::size_t to = longest(i, end, kLeastOnKnown, fits);
        if (to <= last) continue;
        last = to;
        best = std::move(longest_arcs);
      }
      if (i == 0) first_end_ = std::max(first_end_, last);
      if (last == i) ++i;
      for (const auto& [to, arc] : best) {
        arc_to_[i] = {to, arc};
        i = to;
      }
    }
  }

  bool on_ellipse(std::size_t first, std::size_t last, const Round& round, Arcs& arcs) const {
    const std::span<const Point2> run(corners_.data() + first, last - first + 1);
    Ellipse ellipse;
    return (fit_circle(run, ellipse) && accepted(first, last, ellipse, round, arcs)) ||
           (fit_ellipse(run, ellipse) && accepted(first, last, ellipse, round, arcs));
  }

  bool accepted(std::size_t first, std::size_t last, const Ellipse& ellipse, const Round& round, Arcs& arcs) const {
    if (ellipse.radii.y < kLeastRadius * round.tolerance || ellipse.radii.x > kLargestRadiusMm) return false;
    const bool positive = turn(first + 1) > 0;
    const EllipseFrame frame(ellipse);
    std::vector<double> swept(1, 0.0);
    Point2 unit = frame.to_unit(corners_[first]);
    for (std::size_t i = first; i <= last; ++i) {
      if (frame.distance(unit) > round.tolerance) return false;
      if (i == last) break;
      const Point2 next = frame.to_unit(corners_[i + 1]);
      const double from = angle_of(unit);
      const double step = std::remainder(angle_of(next) - from, 2 * std::numbers::pi);
      if ((step > 0) != positive || std::abs(step) > kMostStep) return false;
      const Point2 chord = corners_[i + 1] - corners_[i];
      Point2 tangent = frame.tangent_at(from + step / 2);
      if (!positive) tangent = -tangent;
      if (std::abs(cross(tangent, chord)) > std::tan(kMostTurn) * glm::dot(tangent, chord)) return false;
      // The longer radius is used at every step, so that an ellipse becomes an arc as a whole or not at all.
      if (ellipse.radii.x * (1 - std::cos(step / 2)) > limits_.most_rise_mm) return false;
      swept.push_back(swept.back() + std::abs(step));
      unit = next;
    }
    return swept.back() <= kWholeTurn && (swept.size() >= kMany || round.is_known || even(swept)) &&
           parts(first, swept, ellipse, positive, arcs);
  }

  static bool even(const std::vector<double>& swept) {
    for (std::size_t i = 2; i < swept.size(); ++i) {
      const double before = swept[i - 1] - swept[i - 2], after = swept[i] - swept[i - 1];
      if (std::max(before, after) > kUneven * std::min(before, after)) return false;
    }
    return true;
  }

  /// Cuts a run into arcs with the roundings of a file, and tests the corners again: the centre of a slender arc moves
  /// with its ends.
  bool parts(std::size_t first, const std::vector<double>& swept, const Ellipse& ellipse, bool positive, Arcs& arcs) const {
    Ellipse size = ellipse;
    size.radii = {rounded(size.radii.x), rounded(size.radii.y)};
    size.rotation = rounded(size.rotation * 180 / std::numbers::pi) * std::numbers::pi / 180;
    arcs.clear();
    const double count = std::ceil(swept.back() / kPartSweep);
    std::size_t from = 0;
    for (double part = 1; part <= count; ++part) {
      const double goal = swept.back() * part / count;
      std::size_t to = from + 1;
      while (to + 1 < swept.size() && goal - swept[to] > swept[to + 1] - goal) ++to;
      if (part == count) to = swept.size() - 1;
      if (to <= from) return false;
      const EllipticArc arc = arc_between(corners_[first + from], corners_[first + to], size, positive);
      const EllipseFrame frame(arc.ellipse);
      for (std::size_t i = from + 1; i < to; ++i) {
        if (frame.distance(frame.to_unit(corners_[first + i])) > limits_.tolerance_mm) return false;
      }
      // This is not the fitted arc: it was enlarged, or is the rest of the ellipse.
      if (std::abs(std::abs(arc.sweep) - (swept[to] - swept[from])) > kMostStep) return false;
      arcs.emplace_back(first + to, arc);
      from = to;
    }
    return true;
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
  std::size_t first_end_ = 0;
  std::vector<std::pair<std::size_t, EllipticArc>> arc_to_;  ///< per corner: last corner of the arc that begins there,
                                                             ///< 0 for none
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
    begin_at(corners, fit.first_run_end() % (corners.size() - 1));
    CurvedPath other = CurveFit(std::move(corners), limits).run();
    if (other.pieces.size() < path.pieces.size()) path = std::move(other);
  }
  path.closed = closed;
  return path;
}

bool may_be_curved(const Layer& layer) { return layer.name != "text" && layer.name != "hatch" && layer.name != "debug"; }

}  // namespace ligne
