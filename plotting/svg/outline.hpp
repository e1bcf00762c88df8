#pragma once
/// SVG shapes as polylines on the page. Private to plotting.

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "drawing/drawing.hpp"
#include "plotting/svg/values.hpp"

namespace ligne::svg {

/// Largest distance of a chord from its curve, on the page.
inline constexpr double kFlatnessMm = 0.005;
/// Largest part of its length that a curve loses to its chords: small circles would else lose much more of their ink than
/// large ones. As much again may go when points are left out later (JoinTolerances::simplify_loss).
inline constexpr double kLengthLoss = 0.001;

/// More points than this are refused: a plotter would take days, and a file of some bytes could ask for them.
inline constexpr std::size_t kMostPoints = 50'000'000;

/// A vertex of a path as its data tell it, where markers stand: the directions in which it is reached and left, units of the
/// element; zero where there is none.
struct PathVertex {
  Point2 at{0, 0}, in{0, 0}, out{0, 0};
};

/// A point lies beyond kFarthestMm.
struct OutOfReach : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

/// Collects lines, which may throw OutOfReach and EndlessWork; points come in the units of an element and are kept in page
/// mm.
class Outline {
 public:
  /// `vertices`: collects them too, if it is not null.
  Outline(Polylines& lines, const Matrix& to_mm, std::vector<PathVertex>* vertices = nullptr)
      : lines_(lines), to_mm_(to_mm), vertices_(vertices), first_(lines.points.size()) {}

  void move_to(Point2 p);
  void line_to(Point2 p);
  void quadratic_to(Point2 control, Point2 p);
  void cubic_to(Point2 control1, Point2 control2, Point2 p);
  /// An arc as the path data of SVG give it (SVG 1.1, F.6).
  void arc_to(double rx, double ry, double rotation_degrees, bool large, bool sweep, Point2 p);
  /// Ellipse about a centre, from the angle over so many radians; its first point is where the pen is.
  void arc(Point2 center, double rx, double ry, double rotation, double from, double sweep);
  /// A whole ellipse; its vertices are at the ends of its axes (SVG 2, 10.3).
  void ellipse(Point2 center, double rx, double ry);
  void close();
  void end();

  Point2 at() const { return at_; }
  Point2 start() const { return start_; }

 private:
  void add(Point2 mm);
  void straight_to(Point2 p);
  /// A segment that leaves towards one point and comes to its end from another.
  void note(Point2 towards, Point2 coming_from, Point2 end);

  Polylines& lines_;
  Matrix to_mm_;
  std::vector<PathVertex>* vertices_;
  std::size_t first_vertex_ = 0;  ///< of the line that is open
  Point2 at_{0, 0}, start_{0, 0};
  std::size_t first_;  ///< of the line that is open
  bool open_ = false;
};

/// The "d" of a path, up to its first error (SVG 1.1, F.2). Gives what is wrong there, or an empty text.
std::string add_path(Outline& outline, std::string_view data);

}  // namespace ligne::svg
