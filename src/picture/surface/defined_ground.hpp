#pragma once
/// Where formulas have heights at all.

#include <array>
#include <memory>
#include <span>

#include "scene/surfaces/formula/height_function.hpp"

namespace ligne {

/// Ranges of x and of y.
using Ground = std::array<std::array<double, 2>, 2>;

/// The part of `ground` in which one of the functions has heights, in hundredths of the ranges that are `open`; the other
/// range stays, and so do both where that is nothing or a line. It is looked at in some ten thousand places, so what is
/// narrower than a hundredth may be missed.
Ground defined_ground(std::span<const std::shared_ptr<const HeightFunction>> functions, const Ground& ground,
                      const std::array<bool, 2>& open);

}  // namespace ligne
