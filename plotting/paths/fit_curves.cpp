/// In rounds over the corners of a line, each on what the rounds before left:
/// 1. arcs through many corners that lie on an ellipse but for rounding,
/// 2. arcs within the tolerance,
/// 3. arcs through a few corners, but for rounding,
/// 4. straight pieces within the tolerance.
/// Without the first round an arc would begin on the line before it, as far as the tolerance reaches, and be bent for it.
/// A few corners of a noisy circle lie on some ellipse by chance, so they come after the whole circle.
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

/// The distance by which rounding moves a point: coordinates of single precision and of six digits on a page, and the tenth
/// of a micrometre that files keep. What lies so near to a chord is no corner.
constexpr double kRoundingMm = 0.0005;

/// Least corners of an arc. Five lie on an ellipse in any case.
constexpr std::size_t kMany = 10, kLeastWithin = 8, kFew = 6;

/// An arc found but for rounding goes on within the tolerance, if by so many corners: one may be the end of a cut chord.
constexpr std::size_t kBeyond = 3;

/// In runs of fewer than kMany corners: most that a step is longer than the one beside it. More corners are proof enough.
constexpr double kUneven = 1.25;

/// The largest step from corner to corner, in eccentric angle: twelve to the turn are a circle, ten are a polygon. Between
/// the two, since perspective makes steps uneven.
constexpr double kMostStep = 2 * std::numbers::pi / 11;

/// Most that a chord may deviate from the tangent in the middle of its arc. On an ellipse they are parallel; points within
/// the tolerance alone would let the curve have bumps.
constexpr double kMostTurn = 3 * std::numbers::pi / 180;

/// The shorter radius in tolerances: what is more slender is a line there and back.
constexpr double kLeastRadius = 4;

/// Larger radii are written as straight lines: an arc of a page's length rises by less than a millimetre.
constexpr double kLargestRadiusMm = 100'000;

/// Arcs are written in parts of about so much, three to a turn. The centre follows from the two ends, and near half a turn
/// any rounding of the radii would move it far.
constexpr double kPartSweep = 2 * std::numbers::pi / 3 + 0.01;

/// Sweeps of a whole turn add up to it but for rounding.
constexpr double kWholeTurn = 2 * std::numbers::pi + 1e-3;

/// Straight pieces: most that a segment of the line deviates from the piece in direction, where it is longer than so many
/// tolerances. What is shorter has no direction of its own.
constexpr double kStraightTurn = std::numbers::pi / 180;
constexpr double kShort = 10;

double rounded(double value) {
  const auto units = static_cast<double>(power_of_ten(kArcDecimals));
  return std::round(value * units) / units;
}

/// A round's limits.
struct Round {
  double tolerance;
  std::size_t least;  ///< corners
};

/// The pieces of one run of corners that lies on an ellipse: where each ends, and its arc.
using Arcs = std::vector<std::pair<std::size_t, EllipticArc>>;

class CurveFit {
 public:
  CurveFit(std::vector<Point2> corners, const CurveLimits& limits)
      : corners_(std::move(corners)), limits_(limits), arc_to_(corners_.size()) {}

  CurvedPath run() {
    const double rounding = std::min(kRoundingMm, limits_.tolerance_mm);
    for (const Round& round : {Round{rounding, kMany}, {limits_.tolerance_mm, kLeastWithin}, {rounding, kFew}})
      find_arcs(round);
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

  /// The last corner of the run that the line begins with, of one or more arcs; 0 where it begins straight. After run().
  std::size_t first_run_end() const { return first_end_; }

 private:
  /// The last corner up to `end` of the longest run from `first` that is accepted, among runs of at least `least` corners;
  /// `first` when the shortest is not.
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
      // The whole first: noise bends a short arc more than a whole circle.
      const bool whole = new_chain && end + 1 >= i + round.least && fits(end);
      std::size_t last = whole ? end : longest(i, end, round.least, fits);
      if (last == i) {
        ++i;
        continue;
      }
      // Where rounding is worse than most, the arc goes on beyond what lies on it exactly.
      tolerance = limits_.tolerance_mm;
      last = std::max(last, longest(i, end, last - i + 1 + kBeyond, fits));
      if (i == 0) first_end_ = last;
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
      // By the longer radius all along, so that an ellipse is an arc as a whole or not at all.
      if (ellipse.radii.x * (1 - std::cos(step / 2)) > limits_.most_rise_mm) return false;
      swept.push_back(swept.back() + std::abs(step));
      unit = next;
    }
    return swept.back() <= kWholeTurn && (swept.size() >= kMany || even(swept)) &&
           parts(first, swept, ellipse, positive, arcs);
  }

  static bool even(const std::vector<double>& swept) {
    for (std::size_t i = 2; i < swept.size(); ++i) {
      const double before = swept[i - 1] - swept[i - 2], after = swept[i] - swept[i - 1];
      if (std::max(before, after) > kUneven * std::min(before, after)) return false;
    }
    return true;
  }

  /// Cuts a run into arcs as they are written, and looks again whether they hold the corners: the centre of a slender one
  /// moves with its ends.
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
      // Another arc than the one that was fitted: enlarged, or the rest of the ellipse.
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
  std::vector<std::pair<std::size_t, EllipticArc>> arc_to_;  ///< from a corner: the arc's last corner, 0 for none
};

/// Turns a closed line so that it begins at `corner`.
void begin_at(std::vector<Point2>& line, std::size_t corner) {
  line.pop_back();
  std::rotate(line.begin(), line.begin() + static_cast<std::ptrdiff_t>(corner), line.end());
  line.push_back(line.front());
}

/// Where the longest segment begins: arcs have shorter ones, so this is inside none but where all is arc.
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
    // A dot, or less than rounding.
    CurvedPath dot{line.front()};
    if (line.size() > 1) dot.pieces.push_back({line.back()});
    return dot;
  }
  const bool closed = !limits.start_stays && line.size() > 3 && line.front() == line.back() && corners.size() > 3;
  if (closed) {
    begin_at(corners, longest_segment(corners));
    corners = corners_of(corners);  // where the line began before, there may be no corner
  }
  CurveFit fit(corners, limits);
  CurvedPath path = fit.run();
  if (closed && path.pieces.front().arc && path.pieces.back().arc) {
    // It may begin inside an arc. It does not where its first arc ends, unless all is one.
    begin_at(corners, fit.first_run_end() % (corners.size() - 1));
    CurvedPath other = CurveFit(std::move(corners), limits).run();
    if (other.pieces.size() < path.pieces.size()) path = std::move(other);
  }
  path.closed = closed;
  return path;
}

bool may_be_curved(const Layer& layer) { return layer.name != "text" && layer.name != "hatch" && layer.name != "debug"; }

}  // namespace ligne
