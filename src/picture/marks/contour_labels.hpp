#pragma once
/// Labels of contour lines with their heights.

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
  bool index_only = true;    ///< whether only lines of the layer "contour-index" have labels, if there are any
  bool decades = false;      ///< heights are decimal logarithms
  double distance_mm = 100;  ///< distance of labels along a line
  Rect page;                 ///< labels must lie inside
};

/// Labels contour lines that have a height (Layer::height). A label lies in the middle of a straight part of the line,
/// along it, is readable from below or from the right, and overlaps no other label and no text of `others`. The line
/// has a gap for it. Places that no other contour line crosses are preferred; if a line has none, thinner lines have a
/// gap too. Curves and hatching are cut at all labels. Returns the labels, which are not yet in the drawing.
std::vector<TextItem> label_contours(Drawing& drawing, const ContourLabelOptions& options, std::span<const TextItem> others);

/// Removes the parts of lines inside the boxes. Parts on their rims stay.
Polylines without_boxes(const Polylines& lines, std::span<const TextBox> boxes);

/// Cuts the boxes out of all layers except the shape itself and the marks around the picture.
void make_gaps(Drawing& drawing, std::span<const TextBox> boxes);

/// The box of a label with the white around it.
TextBox label_box(const TextItem& label, TextStyle style);

/// Text of a height: as written if that is short, else with the digits that distinguish neighbours at the distance
/// `step`.
std::string height_text(double height, double step, bool decades);

}  // namespace ligne
