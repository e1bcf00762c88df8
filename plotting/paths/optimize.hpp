#pragma once
/// The shortest way for the pen.

#include <string_view>

#include "plotting/paths/join.hpp"
#include "plotting/paths/order.hpp"

namespace ligne {

enum class Optimize {
  off,   ///< as the drawing is
  join,  ///< every line once, ends joined, points that are not needed left out
  full,  ///< and in the order that makes the way of the raised pen short
};
inline constexpr std::string_view kOptimizeNames[] = {"off", "join", "full"};

struct PathOptions {
  Optimize optimize = Optimize::full;
  JoinTolerances tolerances;
  OrderOptions order;
};

/// Strokes of one pen, page mm.
Polylines optimize_paths(const Polylines& lines, const PathOptions& options);

/// How far a pen goes.
struct PathLengths {
  std::size_t strokes = 0;
  double down_mm = 0;
  double up_mm = 0;  ///< between strokes, from the home position to the first, and back where the pen returns

  PathLengths& operator+=(const PathLengths& other);
};

PathLengths measure(const Polylines& lines, Point2 home, bool returns);

}  // namespace ligne
