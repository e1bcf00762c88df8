#pragma once
/// The rim of filled areas.

namespace ligne {

/// Renderers blend the paper in along the border of every area, and where two areas meet the paper shows between them. So
/// opaque areas get a rim of this width of their own colour: wide enough to close the seams at 150 dpi, narrower than any
/// line.
inline constexpr double kFillRimMm = 0.15;

}  // namespace ligne
