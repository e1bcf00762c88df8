#pragma once
/// Smooth contours: the way out of a study.

#include <cstdint>
#include <vector>

#include "contours/contour_lines.hpp"
#include "drawing/stroke.hpp"

namespace ligne {

/// The sources of contours in a model: `first` + i is a segment that was studied at the line lines[i], beside the contour.
struct ContourSources {
  std::uint32_t first = 0;
  std::vector<std::uint32_t> lines;
};

/// Replaces the strokes of the lines that were studied for the contours by strokes of the contours themselves, with sources
/// of their own behind the intersections. `hidden_too`: as in the study.
ContourSources draw_contours(StrokeModel& model, const Scene& scene, const View& view, const SmoothContours& contours,
                             bool hidden_too, const ContourOptions& options);

}  // namespace ligne
