#pragma once
/// Tolerances of the horizon, as parts of the picture's size.

namespace ligne::horizon {

/// Length on the u axis below which a part is only rounding, as a part of the picture's width.
inline constexpr double kLeastPart = 0x1p-42;

/// Difference between level heights, as a part of the picture's size: a height carries a dozen roundings. Heights of
/// one line at two places that are nearer to each other than this are level, too.
inline constexpr double kLevelPart = 0x1p-44;

}  // namespace ligne::horizon
