// A jump is told from a steep slope by halving: of the two halves of an interval the one over which heights change more is
// kept. Over a slope, however steep, what is left shrinks with the interval; over a jump it stays, and at a pole it grows.

#include "scene/surfaces/height_breaks.hpp"

#include <algorithm>
#include <cmath>

namespace ligne {
namespace {

/// Halvings until an interval is as short as doubles tell apart.
constexpr int kMostHalvings = 60;
/// Halvings after which a jump is told from a slope: that of |x|^(1/5), the steepest that is expected of a formula, has
/// shrunk to a 256th by then, and a slope of ten million to nothing.
constexpr int kJumpHalvings = 40;
/// A change is a jump where more than this part of it is left after halving its interval.
constexpr double kJumpPart = 1. / 64;
/// A change of less than this share of the smallest visible one is a rounding, and no jump.
constexpr double kLeastJump = 0x1p-10;
/// Jumps between two samples are looked for to this depth.
constexpr int kMostJumps = 3;
/// A line between two jumps is a single point, such as the 0 of sign(x), when it is shorter than this part of its span.
constexpr double kPointPart = 0x1p-30;
/// Near to a border, as a part of the way from a sample to it.
constexpr double kNear = 0x1p-20;
/// Between two samples a pole has shown itself after so many halvings by so much growth.
constexpr int kPeakHalvings = 8;
constexpr double kPeakGrowth = 4;

double change(const Point3& a, const Point3& b) { return std::abs(b.z - a.z); }

bool is_number(const Point3& p) { return std::isfinite(p.z); }

}  // namespace

/// From a point that counts to one that does not: the last that does, as near as doubles can tell.
Point3 LineBreaks::last_that_counts(Point3 a, Point3 b) {
  const double rounding = kNear * change(a, b);
  for (int i = 0; i < kMostHalvings; ++i) {
    const Point3 m = between(a, b);
    if ((m.x == a.x && m.y == a.y) || (m.x == b.x && m.y == b.y)) break;
    (counts(m) ? a : b) = m;
  }
  // Where the surface leaves the window it goes on, and has the window's height there.
  if (change(a, b) <= rounding && b.z > window_.high) a.z = window_.high;
  if (change(a, b) <= rounding && b.z < window_.low) a.z = window_.low;
  return a;
}

/// Both ends are numbers. What is before and behind a jump, or a place without a number, between them.
std::optional<LineBreaks::Pair> LineBreaks::jump(Point3 a, Point3 b) {
  const double first = change(a, b);
  for (int i = 0; i < kJumpHalvings; ++i) {
    const Point3 m = between(a, b);
    if ((m.x == a.x && m.y == a.y) || (m.x == b.x && m.y == b.y)) break;
    if (!is_number(m)) {
      const HeightWindow all = window_;
      window_ = {};
      const Pair gap{last_that_counts(a, m), last_that_counts(b, m)};
      window_ = all;
      has_pole_ = has_pole_ || std::max(std::abs(gap.before.z), std::abs(gap.after.z)) > kPoleGrowth * (1 + first);
      return gap;
    }
    (change(a, m) > change(m, b) ? b : a) = m;
    if (!(change(a, b) > kJumpPart * first)) return std::nullopt;
  }
  if (!(change(a, b) > kJumpPart * first)) return std::nullopt;
  has_pole_ = has_pole_ || change(a, b) > kPoleGrowth * first;
  return Pair{a, b};
}

/// All jumps between two numbers, in the order of the line.
void LineBreaks::find_jumps(const Point3& a, const Point3& b, double least, int most, std::vector<Pair>& found) {
  if (most == 0 || !(change(a, b) > least)) return;
  const auto pair = jump(a, b);
  if (!pair) return;
  find_jumps(a, pair->before, least, most - 1, found);
  found.push_back(*pair);
  find_jumps(pair->after, b, least, most - 1, found);
}

/// A pole between two ends of like heights, on its way up at one and down at the other: the same heights on both sides of
/// it.
std::optional<LineBreaks::Pair> LineBreaks::peak(Point3 a, Point3 b) {
  const double first = std::max({change(a, b), std::abs(a.z), std::abs(b.z)});
  Point3 m = between(a, b);
  for (int i = 0; i < kJumpHalvings && is_number(m); ++i) {
    if (i == kPeakHalvings && !(std::abs(m.z) > kPeakGrowth * first)) return std::nullopt;
    const Point3 left = between(a, m), right = between(m, b);
    if (!is_number(left) || !is_number(right)) {
      m = is_number(left) ? right : left;
    } else if (std::abs(left.z) > std::abs(m.z) && std::abs(left.z) >= std::abs(right.z)) {
      b = m, m = left;
    } else if (std::abs(right.z) > std::abs(m.z)) {
      a = m, m = right;
    } else {
      a = left, b = right;
    }
  }
  if (is_number(m) && !(std::abs(m.z) > kPoleGrowth * first)) return std::nullopt;
  has_pole_ = true;
  return Pair{a, b};
}

/// From below what counts to above it, or the other way round: a point in between that counts.
std::optional<Point3> LineBreaks::crossing(Point3 a, Point3 b) {
  for (int i = 0; i < kMostHalvings; ++i) {
    const Point3 m = between(a, b);
    if (counts(m)) return m;
    if (!is_number(m) || (m.x == a.x && m.y == a.y) || (m.x == b.x && m.y == b.y)) break;
    ((m.z < window_.low) == (a.z < window_.low) ? a : b) = m;
  }
  return std::nullopt;
}

/// Whether heights change without end towards the border: as much over the last millionth of the way as over all of it.
bool LineBreaks::diverges(const Point3& border, const Point3& end) {
  const Point3 near = point({border.x + kNear * (end.x - border.x), border.y + kNear * (end.y - border.y)});
  return change(border, near) > change(near, end) / 2 && !(change(border, near) <= kNear * std::abs(end.z));
}

/// Puts points between `border` and `inner`, denser towards the border, in this order.
void LineBreaks::add_between(const Point3& border, const Point3& inner, double least, bool at_border, int halvings,
                             std::vector<Point3>& out) {
  if (halvings == 0) return;
  const double t = at_border ? 0.25 : 0.5;  // heights over the square root of the distance come at equal steps
  const Point3 m = point({border.x + t * (inner.x - border.x), border.y + t * (inner.y - border.y)});
  if (!counts(m) || std::abs(m.z - (border.z + t * (inner.z - border.z))) <= least) return;
  add_between(border, m, least, at_border, halvings - 1, out);
  out.push_back(m);
  add_between(m, inner, least, false, halvings - 1, out);
}

void LineBreaks::refine(const Point3& a, const Point3& b, double least, int halvings, std::vector<LinePiece>& pieces) {
  for (LinePiece& piece : pieces) {
    if (piece.from_start == piece.to_end || piece.points.empty()) continue;
    const Point3 border = piece.points[0];
    add_between(border, piece.from_start ? a : b, least, true, halvings, piece.points);
    if (piece.from_start) std::reverse(piece.points.begin(), piece.points.end());
  }
}

std::optional<Point3> LineBreaks::last_before_break(const Point3& a, Point2 b) {
  const Point3 end = point(b);
  if (!counts(end)) return last_that_counts(a, end);
  const auto broken = jump(a, end);
  if (!broken) return std::nullopt;
  return counts(broken->before) ? broken->before : last_that_counts(a, broken->before);
}

std::vector<LinePiece> LineBreaks::pieces(const Point3& a, const Point3& b, bool may_jump, double least) {
  std::vector<LinePiece> found;
  const auto is_point = [&](const Point3& from, const Point3& to) {
    return std::hypot(to.x - from.x, to.y - from.y) < kPointPart * std::hypot(b.x - a.x, b.y - a.y);
  };
  // From an end of the line to a border; in the order of the line.
  const auto add = [&](const Point3& end, const Point3& border, bool from_start) {
    has_pole_ = has_pole_ || diverges(border, end);
    LinePiece& piece = found.emplace_back();
    (from_start ? piece.from_start : piece.to_end) = true;
    if (!is_point(border, end)) piece.points.push_back(border);
  };
  // Between the end that counts and the border the surface may jump too.
  const auto add_to_border = [&](const Point3& end, const Point3& beyond, bool from_start) {
    const Point3 border = last_that_counts(end, beyond);
    const bool jumps = may_jump && change(end, border) > kLeastJump * least;
    const auto gap = jumps ? jump(end, border) : std::nullopt;
    if (!gap) return add(end, border, from_start);
    const Point3 &first = gap->before, &then = gap->after;
    const bool goes_on = counts(then) && !is_point(then, border);
    if (goes_on && !from_start) found.push_back({false, false, {border, then}});
    add(end, counts(first) ? first : last_that_counts(end, first), from_start);
    if (goes_on && from_start) found.push_back({false, false, {then, border}});
  };
  const bool start = counts(a), end = counts(b);
  if (start && end) {
    std::vector<Pair> gaps;
    if (may_jump) find_jumps(a, b, kLeastJump * least, kMostJumps, gaps);
    if (may_jump && gaps.empty()) {
      if (const auto gap = peak(a, b)) gaps.push_back(*gap);
    }
    if (gaps.empty()) return {{true, true, {}}};
    const Pair &first = gaps.front(), &last = gaps.back();
    add(a, counts(first.before) ? first.before : last_that_counts(a, first.before), true);
    for (std::size_t k = 1; k < gaps.size(); ++k) {
      const Point3 &from = gaps[k - 1].after, &to = gaps[k].before;
      if (!is_point(from, to) && counts(from) && counts(to)) found.push_back({false, false, {from, to}});
    }
    add(b, counts(last.after) ? last.after : last_that_counts(b, last.after), false);
  } else if (start) {
    add_to_border(a, b, true);
  } else if (end) {
    add_to_border(b, a, false);
  } else if (is_number(a) && is_number(b) && (a.z < window_.low) != (b.z < window_.low)) {
    if (const auto inside = crossing(a, b))
      found.push_back({false, false, {last_that_counts(*inside, a), last_that_counts(*inside, b)}});
  }
  return found;
}

}  // namespace ligne
