#pragma once
/// Finds the ranges in which formulas have heights.

#include <array>
#include <memory>
#include <span>

#include "scene/surfaces/formula/height_function.hpp"

namespace ligne {

/// Ranges of x and of y.
using Ground = std::array<std::array<double, 2>, 2>;

/// Returns the part of `ground` in which any of the functions has heights, in hundredths of the ranges that are `open`.
/// The other range does not change. Both ranges stay if the part is empty or a line. The functions are sampled at about
/// ten thousand points, so parts narrower than a hundredth may be missed.
Ground defined_ground(std::span<const std::shared_ptr<const HeightFunction>> functions, const Ground& ground,
                      const std::array<bool, 2>& open);

}  // namespace ligne
