#pragma once
/// Clear drawings beside the true lines of their parts.

#include <functional>

#include "clear/true_parts.hpp"
#include "picture/draw_scene.hpp"

namespace ligne::test {

/// Samples of the edges and outlines of a part, whatever hides them.
struct KnownLines {
  std::vector<TruePoint> wanted;
  std::vector<TruePoint> other;  ///< lines that a drawing may have or not
};

struct DrawnShare {
  double seen_mm = 0, drawn_mm = 0;  ///< of true lines: surely seen, and of these drawn
  double part() const { return seen_mm > 0 ? drawn_mm / seen_mm : 1; }
};

/// A line of the page that only one of a drawing and the truth has.
struct OddPiece {
  std::vector<Point2> path;
  TruePoint sample;  ///< its first one, if it is missing
};

struct Comparison {
  Drawing drawing;
  std::array<DrawnShare, 3> kinds;  ///< by TrueLine
  double ink_mm = 0, true_mm = 0;   ///< drawn, and of this on a true line that may be seen
  std::vector<Point2> cusps;        ///< of true outlines, hidden ones too
  std::vector<OddPiece> missing;    ///< what is surely seen and not drawn
  std::vector<OddPiece> extra;      ///< what is drawn and not true
};

struct TrueScene {
  Scene drawn;  ///< the mesh that is drawn
  Scene fine;   ///< the mesh that tells what is hidden
  /// The lines of the part, with samples every `step` model units.
  std::function<KnownLines(const Viewer& viewer, double step)> lines;
  /// How far the drawn mesh lies from the true line there, in model units.
  std::function<double(const TruePoint&)> sag;
};

/// Draws with the lines of tangent borders and a pen of 0.35 mm, and compares within 0.1 mm and the sag.
Comparison compare_with_truth(const TrueScene& scene, const ViewRequest& view);

}  // namespace ligne::test
