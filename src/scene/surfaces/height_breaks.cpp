// Bisection distinguishes a jump from a steep slope: of the two halves of an interval, the one with the larger change
// of height is kept. On a slope of any steepness, the remaining change shrinks with the interval. At a jump it stays,
// and at a pole it grows.

#include "scene/surfaces/height_breaks.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ligne {
namespace {

/// Number of halvings down to the resolution of doubles.
constexpr int kMostHalvings = 60;
/// Number of halvings that distinguish a jump from a slope. The fifth root of x at 0, the steepest slope expected in a
/// formula, has then shrunk to a 256th, and a slope of ten million to nothing.
constexpr int kJumpHalvings = 40;
/// Smallest part of a change that must remain after halving its interval for a jump.
constexpr double kJumpPart = 1. / 64;
/// Smallest change that can be a jump, relative to the smallest visible one; smaller ones are rounding.
constexpr double kLeastJump = 0x1p-10;
/// Recursion depth of the search for jumps between two samples.
constexpr int kMostJumps = 3;
/// Largest length of a line between two jumps that counts as a point, such as the 0 of sign(x), relative to the line.
constexpr double kPointPart = 0x1p-30;
/// Distance of a point near a border, relative to the distance from a sample to the border.
constexpr double kNear = 0x1p-20;
/// Number of halvings between two samples after which a pole must have grown by kPeakGrowth.
constexpr int kPeakHalvings = 8;
constexpr double kPeakGrowth = 4;

double change(const Point3& a, const Point3& b) { return std::abs(b.z - a.z); }

bool is_number(const Point3& p) { return std::isfinite(p.z); }

}  // namespace

/// The last point that counts between `a`, which counts, and `b`, which does not, at the resolution of doubles.
Point3 LineBreaks::last_that_counts(Point3 a, Point3 b) {
  const double rounding = kNear * change(a, b);
  for (int i = 0; i < kMostHalvings; ++i) {
    const Point3 m = between(a, b);
    if ((m.x == a.x && m.y == a.y) || (m.x == b.x && m.y == b.y)) break;
    (counts(m) ? a : b) = m;
  }
  // A surface that leaves the window continues, so the border gets the height of the window's limit.
  if (change(a, b) <= rounding && b.z > window_.high) a.z = window_.high;
  if (change(a, b) <= rounding && b.z < window_.low) a.z = window_.low;
  return a;
}

/// The last numbers on both sides of a place without one.
LineBreaks::Pair LineBreaks::gap_at(const Point3& a, const Point3& m, const Point3& b) {
  const HeightWindow window = std::exchange(window_, {});
  const Pair gap{last_that_counts(a, m), last_that_counts(b, m)};
  window_ = window;
  return gap;
}

/// The two sides of a jump, or of a place without a number, between two numbers; nothing if there is none.
std::optional<LineBreaks::Pair> LineBreaks::jump(Point3 a, Point3 b) {
  const double first = change(a, b);
  for (int i = 0; i < kJumpHalvings; ++i) {
    const Point3 m = between(a, b);
    if ((m.x == a.x && m.y == a.y) || (m.x == b.x && m.y == b.y)) break;
    if (!is_number(m)) {
      const Pair gap = gap_at(a, m, b);
      if (std::max(std::abs(gap.before.z), std::abs(gap.after.z)) > kPoleGrowth * (1 + first)) add_pole(gap);
      return gap;
    }
    (change(a, m) > change(m, b) ? b : a) = m;
    if (!(change(a, b) > kJumpPart * first)) return std::nullopt;
  }
  if (!(change(a, b) > kJumpPart * first)) return std::nullopt;
  if (change(a, b) > kPoleGrowth * first) add_pole({a, b});
  return Pair{a, b};
}

void LineBreaks::add_pole(const Pair& sides) {
  poles_.low = std::min({poles_.low, sides.before.z, sides.after.z});
  poles_.high = std::max({poles_.high, sides.before.z, sides.after.z});
}

/// Finds all jumps between two numbers, in the order of the line.
void LineBreaks::find_jumps(const Point3& a, const Point3& b, double least, int most, std::vector<Pair>& found) {
  if (most == 0 || !(change(a, b) > least)) return;
  const auto pair = jump(a, b);
  if (!pair) return;
  find_jumps(a, pair->before, least, most - 1, found);
  found.push_back(*pair);
  find_jumps(pair->after, b, least, most - 1, found);
}

/// Finds a pole between two ends of similar heights, where the heights on both sides of it are equal.
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
  add_pole(is_number(m) ? Pair{m, m} : gap_at(a, m, b));
  return Pair{a, b};
}

/// A point that counts between one below the window and one above it, in either order.
std::optional<Point3> LineBreaks::crossing(Point3 a, Point3 b) {
  for (int i = 0; i < kMostHalvings; ++i) {
    const Point3 m = between(a, b);
    if (counts(m)) return m;
    if (!is_number(m) || (m.x == a.x && m.y == a.y) || (m.x == b.x && m.y == b.y)) break;
    ((m.z < window_.low) == (a.z < window_.low) ? a : b) = m;
  }
  return std::nullopt;
}

/// Whether heights diverge towards the border: they change as much over the last millionth of the way as over all of
/// it.
bool LineBreaks::diverges(const Point3& border, const Point3& end) {
  const Point3 near = point({border.x + kNear * (end.x - border.x), border.y + kNear * (end.y - border.y)});
  return change(border, near) > change(near, end) / 2 && !(change(border, near) <= kNear * std::abs(end.z));
}

/// Inserts points between `border` and `inner`, in this order, denser towards the border.
void LineBreaks::add_between(const Point3& border, const Point3& inner, double least, bool at_border, int halvings,
                             std::vector<Point3>& out) {
  if (halvings == 0) return;
  const double t = at_border ? 0.25 : 0.5;  // heights that follow the square root of the distance get equal steps
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
  // Adds the piece from an end of the line to a border. Pieces are added in the order of the line.
  const auto add = [&](const Point3& end, const Point3& border, bool from_start) {
    if (diverges(border, end)) add_pole({border, border});
    LinePiece& piece = found.emplace_back();
    (from_start ? piece.from_start : piece.to_end) = true;
    if (!is_point(border, end)) piece.points.push_back(border);
  };
  // The surface may also jump between the end that counts and the border.
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
