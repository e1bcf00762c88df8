#pragma once
/// The rim of filled areas.

namespace ligne {

/// Width of the rim that opaque areas get in their own colour, mm. Renderers blend the paper in along the border of
/// every area, so paper would show between two areas that meet. The rim is wide enough to close the seams at 150 dpi,
/// and narrower than any line.
inline constexpr double kFillRimMm = 0.15;

}  // namespace ligne
