#pragma once
/// Heights written into contour lines.

#include <span>
#include <string>
#include <vector>

#include "drawing/drawing.hpp"
#include "geometry/point.hpp"
#include "plotting/stroke_text.hpp"

namespace ligne {

struct ContourLabelOptions {
  double height_mm = 2;  ///< of capitals
  TextStyle style = TextStyle::font;
  bool index_only = true;    ///< lines of the layer "contour-index" alone, where there are any
  bool decades = false;      ///< heights are decimal logarithms
  double distance_mm = 100;  ///< one label on every so much of a line
  Rect page;                 ///< what labels must lie in
};

/// Contour lines with a height (Layer::height) get labels: in the middle of a straight part of the line, along it, readable
/// from below or from the right, and no two overlap each other or `others`. The line has a gap for its label. A place over
/// which no other contour runs is taken first; where a line has none, thinner ones have a gap there too. What is drawn of
/// curves and hatching gives way to all labels. The labels are given back; the drawing has no text yet.
std::vector<TextItem> label_contours(Drawing& drawing, const ContourLabelOptions& options, std::span<const TextItem> others);

/// Cuts what lies inside the boxes out of the lines. What lies on their rims stays.
Polylines without_boxes(const Polylines& lines, std::span<const TextBox> boxes);

/// Cuts the boxes out of all layers but those of the shape itself and of what stands round the picture.
void make_gaps(Drawing& drawing, std::span<const TextBox> boxes);

/// The box of a label with the white round it.
TextBox label_box(const TextItem& label, TextStyle style);

/// Heights as labels say them: as written where that is short, else with the digits that tell neighbours `step` apart.
std::string height_text(double height, double step, bool decades);

}  // namespace ligne
