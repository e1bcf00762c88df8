#pragma once
/// Turns the strokes of a visibility method into the lines of a drawing.

#include "linework/clean_lines.hpp"
#include "linework/stroke.hpp"
#include "picture/prepared_scene.hpp"
#include "picture/run_report.hpp"

namespace ligne {

/// Removes coincident strokes and, if LineRequest::least_mm requests it, cleans the lines. Counts the changes in
/// `run.clear`.
void tidy_strokes(StrokeModel& strokes, const PreparedScene& prepared, RunReport& run);

/// Cleans the lines of a scene with clean_lines() and the scene's scans and objects. No two lines may coincide. Bits
/// shorter than `least_mm` are removed.
CleanReport clean_scene_lines(StrokeModel& strokes, const PreparedScene& prepared, double least_mm);

/// Returns the length of the shortest bit of a line that is drawn, in mm; 0: any.
double least_bit_mm(const PreparedScene& prepared);

}  // namespace ligne
