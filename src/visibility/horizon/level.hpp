#pragma once
/// Tolerances of the horizon, as parts of the picture's size.

namespace ligne::horizon {

/// Parts of the u axis that are shorter than this part of it are rounding.
inline constexpr double kLeastPart = 0x1p-42;

/// Heights that differ by less than this part of the picture's size are level: they are the sum of a dozen roundings. So are
/// heights that a line has at places that differ by less.
inline constexpr double kLevelPart = 0x1p-44;

}  // namespace ligne::horizon
