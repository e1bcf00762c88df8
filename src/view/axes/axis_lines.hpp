#pragma once
/// Draws lines in model space on the page.

#include <functional>
#include <span>
#include <vector>

#include "drawing/drawing.hpp"
#include "view/axes/axes_box.hpp"

namespace ligne {

/// A part of a line a, b: from a + from (b - a) to a + to (b - a), 0 <= from < to <= 1.
struct VisibleInterval {
  double from = 0, to = 1;
};

/// Finds the visible parts of every line, ascending and disjoint.
using LineVisibility = std::function<std::vector<std::vector<VisibleInterval>>(std::span<const AxisLine>)>;

/// The visible parts of the lines, clipped to the view's window, as polylines in page mm. Of lines that coincide within
/// `coincidence_mm` one is drawn; lines that continue each other are joined. Without a `visibility` nothing is hidden.
Polylines axis_lines(std::span<const AxisLine> lines, const View& view, const LineVisibility& visibility,
                     double coincidence_mm);

}  // namespace ligne
