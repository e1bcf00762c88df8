#pragma once
/// Where a convex window is divided: along sides of its faces, [Lecture-nd] 4.1.

#include <optional>

#include "visibility/warnock/analysis.hpp"

namespace ligne::warnock {

/// A line that divides the window in two, or nothing when the window is at the limit: no longer than `limit` frame units.
/// It runs along a side of the nearest intersector that meets the inner window; in a window of many faces along the side
/// nearest to the middle. Both parts are wider than the margin on either side. Where no side serves the line passes
/// the middle of the window's box, across its longer direction.
std::optional<Border> dividing_border(const FaceTable& table, const Lists& lists, const ConvexWindow& window,
                                      const WindowShape& inner, double margin, double limit);

}  // namespace ligne::warnock
