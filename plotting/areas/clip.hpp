#pragma once
/// Clip paths and masks of an SVG, and lines cut down to them. Private to plotting.

#include <memory>
#include <vector>

#include "areas/area.hpp"

namespace ligne::svg {

/// Longest chain of links that is followed: uses, clip paths or markers that lead on to others.
inline constexpr int kMostLinks = 16;

/// The part of the page that nested clip paths and masks leave visible.
struct Clip {
  std::vector<Area> any_of;  ///< a visible point is inside one of these
  std::vector<char> opens;   ///< masks, per area: whether it shows or hides; the last painted one decides; empty: all
                             ///< show
  std::vector<std::shared_ptr<const Clip>> within;  ///< per area: clip paths that cut only this area; empty: no area
                                                    ///< has any
  std::shared_ptr<const Clip> outer;                ///< a further clip that must show the point; nullptr: none
};

/// Returns the visible parts of the lines. A line along a rim is visible, since half of its ink is. If `filled` is
/// given, the lines are contours of this area and represent its ink: they are visible where the area itself is visible
/// beside them.
Polylines clipped(const Polylines& lines, const Clip& clip, const Area* filled = nullptr);

/// The parts of the contours that are borders of the area: parts with the area on both sides are left out.
Polylines area_borders(const Polylines& contours, const Area& area);

/// Lines divided by an area that was painted before them.
struct DividedLines {
  Polylines on;   ///< the area lies beside the line, and below the area that the line borders
  Polylines off;  ///< the area does not lie beside the line, or only below the area that the line borders
};

/// Divides lines by the visible part of an area. `over`: the area painted on it whose borders the lines are; nullptr:
/// lines of their own. Borders that both areas have in common, side by side, are in neither part of the result.
DividedLines divided(const Polylines& lines, const Area& under, const Clip* under_clip, const Area* over,
                     const Clip* over_clip);

/// The borders where the clip paths cut the area: the parts of their contours with the visible area on exactly one
/// side, except parts along the contours of the area itself.
Polylines clip_borders(const Area& area, const Clip& clip);

/// Removes the parts of lines that lie along earlier lines up to rounding. Time: O(n log n), plus the number of segment
/// pairs with boxes that meet.
Polylines drawn_once(const Polylines& lines);

}  // namespace ligne::svg
