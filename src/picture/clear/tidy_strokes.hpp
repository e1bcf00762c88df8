#pragma once
/// The strokes of a study as the lines of a drawing.

#include "drawing/stroke.hpp"
#include "picture/prepared_scene.hpp"
#include "picture/run_report.hpp"

namespace ligne {

/// Every line once; and where short bits are no lines (LineRequest::least_mm), without gaps that are none on the page,
/// without bits that are no lines there, and with one class where a line has one. What is changed is counted in `run.clear`.
void tidy_strokes(StrokeModel& strokes, const PreparedScene& prepared, RunReport& run);

}  // namespace ligne
