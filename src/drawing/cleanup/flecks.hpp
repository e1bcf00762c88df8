#pragma once
/// Short lines that show no shape: outlines of what is rough on a surface, and lines that meet no other.

#include <cstddef>
#include <cstdint>
#include <functional>

#include "base/no_index.hpp"
#include "drawing/stroke.hpp"

namespace ligne {

struct FleckLimits {
  double longest_mm = 0;   ///< of a fleck on the page
  double body_part = 0;    ///< and of the extent of its body's lines on the page
  double touching_mm = 0;  ///< lines meet within this distance
  LineClasses classes{1u << static_cast<unsigned>(LineClass::outline)};
  std::uint32_t most_ends_on_lines = 1;
  double ring_width_mm = 0;  ///< a ring that is no wider is a line to and fro
};

/// Hides the lines of bodies that are flecks, or takes them out where no stroke is hidden: open chains of visible strokes
/// of the limits' classes, short on the page, that stand alone; rings too that are lines to and fro, as narrow triangles
/// are. Chains that touch each other count together, by the longer side of the box round them. A chain stays on which
/// another line ends, since that line goes on behind it; and one with more ends on lines than the limits say. `body_of`
/// numbers the bodies from 0 on, kNone for all other strokes. No two visible strokes coincide. Returns the number of
/// chains. O(n + m), with m the grid cells of the side of `touching_mm` x 2 that lines pass near the flecks.
std::size_t drop_flecks(StrokeModel& model, const std::function<std::uint32_t(const Stroke&)>& body_of,
                        const FleckLimits& limits);

/// The diagonals of the boxes round what is seen of each body, lattice steps.
std::vector<double> body_extents(const std::vector<Stroke>& strokes,
                                 const std::function<std::uint32_t(const Stroke&)>& body_of);

}  // namespace ligne
