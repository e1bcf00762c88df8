#pragma once
/// Every stroke lies where its source says: its two points on the page are matrix x source edge at its interval, as the JSON
/// drawing promises (docs/drawing-format.md).

#include <string>

#include "drawing/stroke.hpp"
#include "scene/model/topology.hpp"
#include "support/judge.hpp"
#include "view/view.hpp"

namespace ligne::test {

/// The ends of strokes that are farther from their places than `tolerance_mm` and what is rounded on the way: points to the
/// lattice, parameters and the product with the matrix to doubles. Shadows and lines of no face are not asked.
Fault misplaced(const StrokeModel& model, const Scene& scene, const Topology& topology, const View& view,
                double tolerance_mm);

}  // namespace ligne::test
