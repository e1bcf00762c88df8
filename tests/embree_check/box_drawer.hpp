#pragma once
/// Right drawings of scenes of axis-parallel boxes, made by trying every box at many points of every edge.

#include "drawing_file.hpp"

namespace ligne::check {

struct Box {
  Point3 low{0, 0, 0}, high{1, 1, 1};
};

/// A viewer: an eye, or a line of sight.
struct Viewer {
  bool perspective = false;
  Point3 eye{0, 0, 0};      ///< perspective only
  Point3 forward{0, 1, 0};  ///< line of sight, any length
  double scale = 30;        ///< page mm per model unit (in perspective: at `distance`)
  double distance = 5;
};

/// Every box an object of six quadrilaterals, wound to the outside.
Scene box_scene(const std::vector<Box>& boxes);

/// The visible parts of the edges of the boxes, in class outline or crease; no intersections. The picture's axis is at the
/// middle of an A4 sheet.
DrawingFile draw_boxes(const std::vector<Box>& boxes, const Viewer& viewer);

/// Page point of a model point; W must be positive.
Point2 page_point(const Rows& model_to_page, const Point3& p);

}  // namespace ligne::check
