#pragma once
/// Strokes of a scan on the page, for tests of what is left out of its outlines.

#include <cstdint>

#include "drawing/flecks.hpp"
#include "drawing/stroke.hpp"

namespace ligne {

/// Strokes on the page with steps of 1/1000 mm; sources below 100 are of the rough body, whose outline is 200 mm long.
class ScanPage {
 public:
  ScanPage() {
    model.lattice.step_mm = 0.001;
    model.edge_count = 1000;
    add(0, {0, 0}, {200, 0});
  }

  ScanPage& add(std::uint32_t source, Point2 from, Point2 to, LineClass line_class = LineClass::outline,
                bool visible = true) {
    Stroke s;
    s.from = model.lattice.snap(from);
    s.to = model.lattice.snap(to);
    s.source = source;
    s.line_class = line_class;
    s.visible = visible;
    model.strokes.push_back(s);
    return *this;
  }

  static std::uint32_t body_of(const Stroke& s) { return s.source < 100 ? 0u : kNoBody; }

  StrokeModel model;
};

}  // namespace ligne
