#pragma once
/// Where a function z = f(x, y) ends or jumps along a straight line: found by bisecting the formula, not by how steep its
/// samples are.

#include <limits>
#include <optional>
#include <vector>

#include "geometry/point.hpp"
#include "scene/surfaces/formula/height_function.hpp"

namespace ligne {

/// A change that grows by more than this between samples is a pole's.
inline constexpr double kPoleGrowth = 0x1p20;

/// Heights that count: finite, and within these.
struct HeightWindow {
  double low = -std::numeric_limits<double>::infinity(), high = std::numeric_limits<double>::infinity();
  bool holds(double z) const { return z >= low && z <= high && z - z == 0; }
};

/// A stretch of a line over which the surface goes on without a break.
struct LinePiece {
  bool from_start = false, to_end = false;  ///< it reaches the line's ends
  std::vector<Point3> points;               ///< its own ends where it does not reach the line's, and what is between them
};

class LineBreaks {
 public:
  LineBreaks(HeightFunction::At& at, const HeightWindow& window) : at_(at), window_(window) {}

  /// The pieces of the line from `a` to `b`, points with their heights, or NaN where there is none. `may_jump`: whether the
  /// line is looked at for a jump. `least`: height that is nothing to see.
  std::vector<LinePiece> pieces(const Point3& a, const Point3& b, bool may_jump, double least);

  /// Puts points between the ends of such pieces that reach one end of the line, halving each so often at most; what curves
  /// by no more than `least` between two points is left straight.
  void refine(const Point3& a, const Point3& b, double least, int halvings, std::vector<LinePiece>& pieces);

  /// The last point from `a`, which counts, towards `b` before the surface breaks off; nothing when it reaches `b`.
  std::optional<Point3> last_before_break(const Point3& a, Point2 b);

  /// A point with its height.
  Point3 point(Point2 p) { return {p.x, p.y, at_(p.x, p.y)}; }
  bool counts(const Point3& p) const { return window_.holds(p.z); }

  /// Heights grew beyond bounds where a line was bisected.
  bool has_pole() const { return has_pole_; }

 private:
  struct Pair {
    Point3 before, after;
  };

  Point3 between(const Point3& a, const Point3& b) { return point({a.x + (b.x - a.x) / 2, a.y + (b.y - a.y) / 2}); }
  Point3 last_that_counts(Point3 a, Point3 b);
  std::optional<Pair> jump(Point3 a, Point3 b);
  void find_jumps(const Point3& a, const Point3& b, double least, int most, std::vector<Pair>& found);
  std::optional<Pair> peak(Point3 a, Point3 b);
  std::optional<Point3> crossing(Point3 a, Point3 b);
  bool diverges(const Point3& border, const Point3& end);
  void add_between(const Point3& border, const Point3& inner, double least, bool at_border, int halvings,
                   std::vector<Point3>& out);

  HeightFunction::At& at_;
  HeightWindow window_;
  bool has_pole_ = false;
};

}  // namespace ligne
