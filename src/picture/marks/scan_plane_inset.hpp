#pragma once
/// A scan plane below the picture ([Boulle1980] figures 2.39 to 2.50).

#include "drawing/drawing.hpp"
#include "drawing/result_models.hpp"
#include "picture/requests.hpp"

namespace ligne {

/// Part of the drawable height that is kept free below a picture whose request shows a scan plane, else 0.
double inset_part(const LineRequest& lines);

/// Draws the scan line on the picture, and in `area` the plane: x as on the picture, depth upwards, the eye below. Its
/// segments are thin, the visible runs heavy. Below the plane stand the steps of the span method.
void add_scan_plane(Drawing& drawing, const ScanPlane& plane, const Rect& picture, const Rect& area, double text_mm);

}  // namespace ligne
