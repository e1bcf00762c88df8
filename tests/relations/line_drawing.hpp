#pragma once
/// The visible lines of a drawing, and by what two drawings differ.

#include <string>
#include <vector>

#include "relations/relations.hpp"
#include "support/page_segments.hpp"
#include "visibility/method.hpp"

namespace ligne::test {

/// A visible line on the page.
struct Line {
  LineClass line_class;
  Segment place;
};

struct LineDrawing {
  std::vector<Line> lines;
  /// How far a line may be off: two steps of the lattice for the rounding of its two ends, and the distance at which one of
  /// two lines stands for both. See docs/numerics.md.
  double tolerance_mm = 0;
};

LineDrawing drawn(const Method& method, const Sight& sight);

LineDrawing mirror_image(LineDrawing drawing);

/// The differences of two drawings that are longer than what a line may be off, and than `shortest_mm`; empty when there are
/// none.
std::string differences(const LineDrawing& expected, const LineDrawing& found, double shortest_mm = 0);

/// Writes the scene beside other temporary files, and tells the command that draws it.
std::string command(const std::string& stem, const Sight& sight, const Method& method);

/// The view as options of `ligne draw`.
std::string options(const CameraRequest& camera);

/// The methods for any scene that are exact and give strokes.
std::vector<const Method*> exact_methods();

/// Whether the method promises this drawing: some find no intersections.
bool draws_well(const Method& method, const LineDrawing& drawing);

}  // namespace ligne::test
