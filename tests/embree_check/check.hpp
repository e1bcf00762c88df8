#pragma once
/// Is a drawing right? Every drawn stroke is looked at from point to point, and every edge of the model.
///
/// Drawn although hidden: the point of the stroke, points of its edge within the tolerance before and after it, and eight
/// points of the same depth round it on the page are all certainly blocked.
/// Visible but not drawn: no stroke passes within the tolerance, and the point and its edge within the tolerance before and
/// after it are certainly visible.
/// Undecided: blocked here and visible there within the tolerance. A stroke of this kind is right where another edge that
/// should be drawn is visible within the tolerance: lines that coincide are drawn once, as either.

#include "drawing_file.hpp"

namespace ligne::check {

struct CheckOptions {
  std::uint8_t kinds = kFeatureKinds;  ///< classes that the drawing should hold
  double crease_degrees = 30;
  double tolerance_mm = 0.02;
  double step_mm = 0.1;       ///< from sample to sample
  double seen_step_mm = 0.5;  ///< from sample to sample in the search for intersections
};

/// Something wrong on one stroke or edge.
struct Finding {
  std::string what;
  double length_mm = 0;
  Point2 at{0, 0};                    ///< one of the places, page mm
  std::optional<std::uint32_t> edge;  ///< as numbered by the drawing
  Point3 a{0, 0, 0}, b{0, 0, 0};      ///< ends of the source edge, model coordinates
};

/// Lengths on the page in mm.
struct Report {
  double drawn = 0;         ///< visible strokes
  double hidden_drawn = 0;  ///< drawn although hidden
  double misplaced = 0;     ///< strokes whose points are not where their edge is
  double no_line = 0;       ///< strokes of no edge, or of a class which that edge cannot have, or which is not asked for
  double drawn_undecided = 0;
  double visible = 0;  ///< edges that should be drawn and are certainly visible
  double missing = 0;  ///< of these, not drawn
  double missing_undecided = 0;
  double intersections_seen = 0;     ///< estimate from the crossings found
  double intersections_missing = 0;  ///< of these, not drawn
  std::vector<Finding> findings;     ///< longest first

  double drawn_wrong() const { return hidden_drawn + misplaced + no_line; }
  double not_drawn() const { return missing + intersections_missing; }
  /// Part of the drawn length (of the visible length where nothing is drawn).
  double share(double length) const;
};

Report check_drawing(const Scene& scene, const DrawingFile& drawing, const CheckOptions& options);

/// A table for people: the lengths, their shares, and the `worst` longest findings.
std::string to_text(const Report& report, std::size_t worst);

}  // namespace ligne::check
