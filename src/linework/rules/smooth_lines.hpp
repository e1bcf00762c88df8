#pragma once
/// Lines along the edges of a mesh that is finer than what they stand for.

#include <cstddef>
#include <functional>

#include "linework/stroke.hpp"

namespace ligne {

/// Smooths the lines of the strokes for which is_rough() holds: the vertices of a scan lie to either side of a ridge, and
/// the edges from one to the next zigzag along it. A point moves where two such strokes meet that are seen alike, and no
/// third one: onto the parabola that fits the points up to three to either side, twice. Ends, junctions and corners stay.
/// Returns the number of points. O(n).
std::size_t smooth_lines(StrokeModel& model, const std::function<bool(const Stroke&)>& is_rough);

}  // namespace ligne
