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
/// Largest fraction of its length that a curve loses to its chords. Without it small circles would lose much more of
/// their ink than large ones. Simplification may take as much again (JoinTolerances::simplify_loss).
inline constexpr double kLengthLoss = 0.001;

/// Most points of a drawing. A plotter would take days for more, and a file of some bytes could ask for them.
inline constexpr std::size_t kMostPoints = 50'000'000;

/// A vertex of a path's data, where markers stand, and the directions in which the path reaches and leaves it, in units
/// of the element; zero if there is none.
struct PathVertex {
  Point2 at{0, 0}, in{0, 0}, out{0, 0};
};

/// A point lies beyond kFarthestMm.
struct CoordinateRangeError : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

/// Collects lines. Points come in the units of an element and are stored in page mm. Functions may throw
/// CoordinateRangeError and WorkLimitError.
class Outline {
 public:
  /// `vertices`, if it is not null, receives the vertices of paths.
  Outline(Polylines& lines, const Matrix& to_mm, std::vector<PathVertex>* vertices = nullptr)
      : lines_(lines), to_mm_(to_mm), vertices_(vertices), first_(lines.points.size()) {}

  void move_to(Point2 p);
  void line_to(Point2 p);
  void quadratic_to(Point2 control, Point2 p);
  void cubic_to(Point2 control1, Point2 control2, Point2 p);
  /// Adds an arc by the parameters of SVG's path data (SVG 1.1, F.6).
  void arc_to(double rx, double ry, double rotation_degrees, bool large, bool sweep, Point2 p);
  /// Adds an arc of an ellipse about a centre, from the angle `from` over `sweep` radians. It begins at the current
  /// point.
  void arc(Point2 center, double rx, double ry, double rotation, double from, double sweep);
  /// Adds a whole ellipse; its vertices are at the ends of its axes (SVG 2, 10.3).
  void ellipse(Point2 center, double rx, double ry);
  void close();
  void end();

  Point2 at() const { return at_; }
  Point2 start() const { return start_; }

 private:
  void add(Point2 mm);
  void straight_to(Point2 p);
  /// Notes a segment that leaves towards one point and comes to its end from another.
  void note(Point2 towards, Point2 coming_from, Point2 end);

  Polylines& lines_;
  Matrix to_mm_;
  std::vector<PathVertex>* vertices_;
  std::size_t first_vertex_ = 0;  ///< first vertex of the open line
  Point2 at_{0, 0}, start_{0, 0};
  std::size_t first_;  ///< first point of the open line
  bool open_ = false;
};

/// Adds the "d" of a path, up to its first error (SVG 1.1, F.2). Returns the error, or an empty text.
std::string add_path(Outline& outline, std::string_view data);

}  // namespace ligne::svg
