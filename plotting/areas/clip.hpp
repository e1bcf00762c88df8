#pragma once
/// Clip paths and masks of an SVG, and lines cut down to them. Private to plotting.

#include <memory>
#include <vector>

#include "areas/area.hpp"

namespace ligne::svg {

/// Links that lead on to links.
inline constexpr int kMostLinks = 16;

/// The part of the page that one or several clip paths or masks, one inside the other, leave open.
struct Clip {
  std::vector<Area> any_of;  ///< inside one of these
  std::vector<char> opens;   ///< of a mask: whether an area shows or hides, the last painted decides; empty: all show
  std::vector<std::shared_ptr<const Clip>> within;  ///< of each area: clip paths that cut it alone; empty: none has any
  std::shared_ptr<const Clip> outer;                ///< and of this; nullptr: nothing more
};

/// The parts of the lines that show. Half of the ink of a line along a rim shows, so the line does. `filled`: the lines are
/// contours of this area and stand for its ink: they show where the area itself shows beside them.
Polylines clipped(const Polylines& lines, const Clip& clip, const Area* filled = nullptr);

/// The parts of the contours of an area that are its borders: not those on both sides of which it lies.
Polylines area_borders(const Polylines& contours, const Area& area);

/// Where the clip paths cut the area: the parts of their contours on one side of which it shows, and not along its own.
Polylines clip_borders(const Area& area, const Clip& clip);

/// The lines without the parts that lie along earlier ones of them, up to rounding. Time: n log n, and what lies near.
Polylines drawn_once(const Polylines& lines);

}  // namespace ligne::svg
