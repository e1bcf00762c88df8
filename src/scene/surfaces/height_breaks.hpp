#pragma once
/// Finds where a function z = f(x, y) ends or jumps along a straight line, by bisecting the formula; the steepness of
/// its samples does not decide.

#include <limits>
#include <optional>
#include <vector>

#include "geometry/point.hpp"
#include "scene/surfaces/formula/height_function.hpp"

namespace ligne {

/// Growth of a change between samples that indicates a pole.
inline constexpr double kPoleGrowth = 0x1p20;

/// Heights that count: the finite ones within the limits.
struct HeightWindow {
  double low = -std::numeric_limits<double>::infinity(), high = std::numeric_limits<double>::infinity();
  bool holds(double z) const { return z >= low && z <= high && z - z == 0; }
};

inline constexpr HeightWindow kNoHeights{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};

/// A part of a line on which the surface has no break.
struct LinePiece {
  bool from_start = false, to_end = false;  ///< whether it reaches the ends of the line
  std::vector<Point3> points;               ///< its ends where they are not those of the line, and points between
};

class LineBreaks {
 public:
  LineBreaks(HeightFunction::At& at, const HeightWindow& window) : at_(at), window_(window) {}

  /// The pieces of the line from `a` to `b`, which are points with heights, NaN where there is none. `may_jump`:
  /// whether to search for jumps. `least`: height that is just invisible.
  std::vector<LinePiece> pieces(const Point3& a, const Point3& b, bool may_jump, double least);

  /// Inserts points between the ends of pieces that reach one end of the line, with at most `halvings` halvings each.
  /// Parts that deviate from a straight line by at most `least` stay straight.
  void refine(const Point3& a, const Point3& b, double least, int halvings, std::vector<LinePiece>& pieces);

  /// The last point before the surface breaks off, from `a`, which counts, towards `b`; nothing if it reaches `b`.
  std::optional<Point3> last_before_break(const Point3& a, Point2 b);

  /// A point with its height.
  Point3 point(Point2 p) { return {p.x, p.y, at_(p.x, p.y)}; }
  bool counts(const Point3& p) const { return window_.holds(p.z); }

  /// Range of the heights where these seemed to grow without bound as a line was bisected; low > high if none did.
  HeightWindow poles() const { return poles_; }

 private:
  struct Pair {
    Point3 before, after;
  };

  Point3 between(const Point3& a, const Point3& b) { return point({a.x + (b.x - a.x) / 2, a.y + (b.y - a.y) / 2}); }
  Point3 last_that_counts(Point3 a, Point3 b);
  std::optional<Pair> jump(Point3 a, Point3 b);
  void add_pole(const Pair& sides);
  Pair gap_at(const Point3& a, const Point3& m, const Point3& b);
  void find_jumps(const Point3& a, const Point3& b, double least, int most, std::vector<Pair>& found);
  std::optional<Pair> peak(Point3 a, Point3 b);
  std::optional<Point3> crossing(Point3 a, Point3 b);
  bool diverges(const Point3& border, const Point3& end);
  void add_between(const Point3& border, const Point3& inner, double least, bool at_border, int halvings,
                   std::vector<Point3>& out);

  HeightFunction::At& at_;
  HeightWindow window_;
  HeightWindow poles_ = kNoHeights;
};

}  // namespace ligne
