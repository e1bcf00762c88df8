#pragma once
/// Smooth contours: the way out of a study.

#include "contours/contour_lines.hpp"
#include "contours/curve_writer.hpp"
#include "drawing/stroke.hpp"

namespace ligne {

/// Replaces the strokes of the lines that were studied for the contours by strokes of the contours themselves, with sources
/// of their own behind the intersections. `hidden_too`: as in the study.
ContourSources draw_contours(StrokeModel& model, const Scene& scene, const View& view, const SmoothContours& contours,
                             bool hidden_too, const ContourOptions& options);

}  // namespace ligne
