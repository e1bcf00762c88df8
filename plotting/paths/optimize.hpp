#pragma once
/// Joining and ordering of strokes, so that the pen travels less and is lifted less often.

#include <span>
#include <string_view>
#include <vector>

#include "plotting/paths/join.hpp"
#include "plotting/paths/order.hpp"

namespace ligne {

enum class Optimize {
  off,    ///< strokes and their order stay as in the drawing
  order,  ///< strokes stay; their order and directions make the travel of the raised pen short
  join,   ///< coincident lines are drawn once, ends are joined, superfluous points are left out; the order stays
  full,   ///< join, then order
};
inline constexpr std::string_view kOptimizeNames[] = {"off", "order", "join", "full"};

/// Lengths that a pen travels.
struct PathLengths {
  std::size_t strokes = 0;  ///< number of times the pen is lowered
  double down_mm = 0;       ///< drawn length
  double up_mm = 0;         ///< from the home position to the first stroke, between strokes, and home if it returns

  PathLengths& operator+=(const PathLengths& other);
};

/// Lengths of the strokes drawn in this order from `home` (page mm). With `returns` the pen travels back there at the
/// end.
PathLengths measure(const Polylines& lines, Point2 home, bool returns);

/// Speeds of a plotter. The defaults are for a small plotter with a servo, and hold if no device is named. Adjustable.
struct PathPace {
  /// Speeds of the lowered and of the raised pen; time to lift the pen and to lower it again.
  double down_mm_s = 40, up_mm_s = 80, lift_s = 0.25;

  double seconds(const PathLengths& lengths) const;
};

struct PathOptions {
  Optimize optimize = Optimize::full;
  JoinTolerances tolerances;
  OrderOptions order;
  double min_length_mm = 0;  ///< shorter strokes, and dots, are left out; 0 keeps all
  PathPace pace;             ///< compares plots by their time
};

/// Indices of the strokes that are at least this long, ascending.
std::vector<std::uint32_t> long_strokes(const Polylines& lines, double min_length_mm);
/// The strokes with these indices, in the order of the indices.
Polylines picked(const Polylines& lines, std::span<const std::uint32_t> numbers);

/// The strokes of one pen (page mm), joined, without short ones, and ordered, as the options say. Short strokes are
/// left out after joining.
Polylines optimize_paths(const Polylines& lines, const PathOptions& options);

}  // namespace ligne
