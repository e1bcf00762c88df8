#pragma once
/// Collapses the edges that rounding has left of nothing.

#include <cstddef>

#include "scene/model/scene.hpp"

namespace ligne {

/// Merges the ends of edges that are shorter than a step of the coordinates, and drops the faces that vanish. Where
/// programs find one corner several times, each time rounded differently, needles without thickness connect these, and
/// some of them are turned over: their sides would be outlines in the midst of a plane. A step is
/// twice Object::precision, and that of a float32 at the largest coordinate of a face if this is less. A vertex moves by
/// up to four steps, over a chain of such edges. Returns the number
/// of vertices that were merged. Takes O(n) time.
std::size_t collapse_short_edges(Scene& scene);

}  // namespace ligne
