#pragma once
/// The shortest way for the pen.

#include <span>
#include <string_view>
#include <vector>

#include "plotting/paths/join.hpp"
#include "plotting/paths/order.hpp"

namespace ligne {

enum class Optimize {
  off,    ///< as the drawing is
  order,  ///< strokes as they are, in the order that makes the way of the raised pen short
  join,   ///< every line once, ends joined, points that are not needed left out
  full,   ///< both
};
inline constexpr std::string_view kOptimizeNames[] = {"off", "order", "join", "full"};

/// How far a pen goes.
struct PathLengths {
  std::size_t strokes = 0;
  double down_mm = 0;
  double up_mm = 0;  ///< between strokes, from the home position to the first, and back where the pen returns

  PathLengths& operator+=(const PathLengths& other);
};

PathLengths measure(const Polylines& lines, Point2 home, bool returns);

/// How fast a plotter is. Adjustable where no device is named: a small one with a servo.
struct PathPace {
  double down_mm_s = 40, up_mm_s = 80, lift_s = 0.25;

  double seconds(const PathLengths& lengths) const;
  /// A line of this length takes as long to draw as the pen to be lifted and lowered.
  double lift_mm() const { return lift_s * down_mm_s; }
};

struct PathOptions {
  Optimize optimize = Optimize::full;
  JoinTolerances tolerances;
  OrderOptions order;
  double min_length_mm = 0;  ///< strokes that are shorter are left out, dots too
  PathPace pace;             ///< by which the way is judged; tolerances.lift_mm should follow from it
};

/// Numbers of the strokes that are not shorter.
std::vector<std::uint32_t> long_strokes(const Polylines& lines, double min_length_mm);
/// The strokes of these numbers.
Polylines picked(const Polylines& lines, std::span<const std::uint32_t> numbers);

/// Strokes of one pen, page mm.
Polylines optimize_paths(const Polylines& lines, const PathOptions& options);

}  // namespace ligne
