#pragma once
/// The strokes of a study as the lines of a drawing.

#include "linework/clean_lines.hpp"
#include "linework/stroke.hpp"
#include "picture/prepared_scene.hpp"
#include "picture/run_report.hpp"

namespace ligne {

/// Draws every line once, and where short bits are no lines (LineRequest::least_mm) cleans the lines. The changes are
/// counted in `run.clear`.
void tidy_strokes(StrokeModel& strokes, const PreparedScene& prepared, RunReport& run);

/// Cleans the lines of a scene, none of which coincide: clean_lines() with the scene's scans and objects. Bits of lines are
/// shown from `least_mm` on.
CleanReport clean_scene_lines(StrokeModel& strokes, const PreparedScene& prepared, double least_mm);

/// The shortest bit of a line that is shown, millimetres; 0: any.
double least_bit_mm(const PreparedScene& prepared);

}  // namespace ligne
