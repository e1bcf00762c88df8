#pragma once
/// Finds formulas whose samples show another surface than the formula.

#include "scene/surfaces/formula/height_function.hpp"
#include "scene/surfaces/height_source.hpp"

namespace ligne {

/// The directions in which a picture interpolates between samples.
struct InterpolatedAxes {
  bool x = true, y = true;
};

/// Whether the function differs grossly, at half steps, from the interpolation of its samples, in a large part of the
/// cells. Poles, jumps and edges along lines do not count: they are in few cells. Looks at an even choice of some 256
/// cells.
bool is_undersampled(const HeightSource& heights, const HeightFunction& function, InterpolatedAxes axes);

}  // namespace ligne
