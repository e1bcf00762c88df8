#pragma once
/// Smooths lines along the edges of a mesh that is finer than the shape it represents.

#include <cstddef>
#include <functional>

#include "linework/stroke.hpp"

namespace ligne {

/// Smooths the lines of the strokes for which is_rough() holds. The vertices of a scan lie on both sides of a ridge, so
/// the edges along it zigzag. A point moves if exactly two strokes meet there, both rough and of equal visibility. It
/// moves towards the middle of its neighbours and back, several times. Ends, junctions and corners stay.
/// Returns the number of points moved. O(n).
std::size_t smooth_lines(StrokeModel& model, const std::function<bool(const Stroke&)>& is_rough);

}  // namespace ligne
