#pragma once
/// Joining and ordering of strokes, so that the pen travels less and is lifted less often.

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "drawing/drawing.hpp"

namespace ligne {

/// Tolerances in page mm. They are below what a pen shows: its line is some tenths of a millimetre wide, and the step
/// of a plotter is 0.025 mm.
struct JoinTolerances {
  double ends_mm = 0.05;      ///< ends within this distance are joined by a straight segment
  double overlap_mm = 0.01;   ///< segments that coincide within this distance are drawn once; 0 keeps all
  double simplify_mm = 0.01;  ///< largest distance of a removed point from the simplified line; 0 removes only points
                              ///< on straight lines
  /// Largest fraction of its length that a line may lose by simplification, since ink is length times width. A circle
  /// keeps at least 41 points.
  double simplify_loss = 0.001;
};

/// Draws the lines with as few strokes as possible. Where strokes meet in a point, the pairs that make the straightest
/// lines are joined first, then the remaining ones at any angle. Closed lines are inserted into lines that pass one of
/// their points. Loose ends within the tolerance are joined, nearest first. So a connected figure takes half as many
/// strokes as it has points where an odd number of lines meet. The strokes are in the order of the first lines in them.
/// A line without length stays as a dot of two equal points.
///
/// No point of the result is farther from the input, and no point of the input is farther from the result, than the sum
/// of ends_mm, overlap_mm and simplify_mm.
Polylines join_strokes(const Polylines& lines, const JoinTolerances& tolerances);

/// Joins polylines whose ends lie within the tolerance of each other by a straight segment, the nearest first. The two
/// ends of one polyline are joined only if it is several times as long as the gap. Closed polylines stay as they are. The
/// results are ordered by the first polyline in each.
Polylines join_near_ends(const Polylines& lines, double tolerance_mm);

struct OrderOptions {
  Point2 home{0, 0};          ///< start of the pen, page mm
  bool returns = false;       ///< whether the pen travels back there at the end
  bool inside_first = false;  ///< draw strokes inside a closed stroke before it, even if the raised pen travels farther
  /// Limit of the optimization, in moved strokes. It does not depend on time, so the result is the same on any machine.
  std::uint64_t most_work = 150'000'000;
};

/// Chooses order and directions of the strokes so that the travel of the raised pen is short: by nearest neighbours
/// first, then by 2-opt and or-opt until there is no gain or the limit is reached. Closed lines start at the best of
/// their points. The travel is never longer than in the given order. `order`, if not null, receives the original
/// indices of the strokes in the new order.
Polylines order_strokes(const Polylines& lines, const OrderOptions& options, std::vector<std::uint32_t>* order = nullptr);

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
