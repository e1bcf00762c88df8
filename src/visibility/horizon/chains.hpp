#pragma once
/// Collects short segments on the page, and joins them to polylines at the end.

#include "drawing/drawing.hpp"
#include "view/tolerances.hpp"

namespace ligne::horizon {

class Chains {
 public:
  explicit Chains(const Rect& page_mm) { model_.lattice = Lattice::covering(page_mm); }

  void add(Point2 a, Point2 b) {
    Stroke stroke;
    stroke.from = model_.lattice.snap(a);
    stroke.to = model_.lattice.snap(b);
    if (!(stroke.from == stroke.to)) model_.strokes.push_back(stroke);
  }

  Polylines finish() {
    Drawing drawing = make_drawing(model_);
    return drawing.layers.empty() ? Polylines{} : std::move(drawing.layers.front().lines);
  }

 private:
  StrokeModel model_;
};

}  // namespace ligne::horizon
