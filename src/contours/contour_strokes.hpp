#pragma once
/// Draws smooth contours after a visibility method has run: phases 7 to 9 of docs/smooth-contours.md.

#include "contours/contour_lines.hpp"
#include "contours/curve_writer.hpp"
#include "linework/stroke.hpp"

namespace ligne {

/// Replaces the strokes of sights, probes and replaced edges by strokes of the contours. Each gets a new source in
/// StrokeModel::intersections. `hidden_too`: whether the method returned hidden strokes; hidden parts are then drawn,
/// too. Returns the sources of the new strokes, and the sights that they replace.
ContourSources draw_contours(StrokeModel& model, const Scene& scene, const View& view, const SmoothContours& contours,
                             bool hidden_too, const ContourOptions& options);

}  // namespace ligne
