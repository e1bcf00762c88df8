#pragma once
/// Draws a scan plane below the picture ([Boulle1980] figures 2.39 to 2.50).

#include "drawing/drawing.hpp"
#include "drawing/result_models.hpp"
#include "picture/requests.hpp"

namespace ligne {

/// Part of the drawable height reserved below a picture that shows a scan plane, else 0.
double inset_part(const LineRequest& lines);

/// Draws the scan line on the picture, and in `area` its plane: x as on the picture, depth upwards, the eye below.
/// Segments are thin, visible runs heavy. The steps of the span method are drawn below the plane.
void add_scan_plane(Drawing& drawing, const ScanPlane& plane, const Rect& picture, const Rect& area, double text_mm);

}  // namespace ligne
