#pragma once
/// Is a drawing right? Every drawn stroke is looked at from point to point, and every edge of the model.
///
/// Drawn although hidden: the point of the stroke, points of its edge within the tolerance before and after it, and eight
/// points of the same depth round it on the page are all certainly blocked.
/// Visible but not drawn: no stroke passes within the tolerance, and the point and its edge within the tolerance before and
/// after it are certainly visible.
/// Undecided: blocked here and visible there within the tolerance. A stroke of this kind is right where another edge that
/// should be drawn is visible within the tolerance: lines that coincide are drawn once, as either.

#include "sight.hpp"

namespace ligne::check {

// The JSON drawing, as a stranger reads it: docs/drawing-format.md.

struct DrawnStroke {
  LineKind kind = kMesh;
  bool visible = true;
  std::array<Point3, 2> ends{};                         ///< ends of the source edge, model coordinates
  std::array<double, 2> interval{0, 1};                 ///< parameters on the source edge
  std::optional<std::uint32_t> edge;                    ///< number of the source edge; none for an intersection
  std::array<std::optional<std::uint32_t>, 2> faces{};  ///< that meet at the source edge
  std::array<Point2, 2> points{};                       ///< page mm
};

struct DrawingFile {
  Rows model_to_page{};
  Rect window;               ///< page mm
  double near_distance = 0;  ///< smallest W that is drawn; in a perspective
  std::vector<DrawnStroke> strokes;
};

/// Throws std::runtime_error with one line.
DrawingFile parse_drawing(std::string_view text);

/// "outline" and so on; throws std::runtime_error for another name.
LineKind kind_of(std::string_view name);
std::string_view name_of(LineKind kind);

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

struct SeenCrossing {
  Point2 at{0, 0};        ///< page mm
  Point3 point{0, 0, 0};  ///< unit box
  std::array<std::uint32_t, 2> faces{};
  double length_mm = 0;  ///< of the intersection, by this crossing's share of the grid
};

/// Finds visible intersections of penetrating faces by looking, with no intersection computed: rays on a grid of page
/// points; between neighbours that see different faces the place of the change is found by bisection; where both faces go on
/// beyond that place, one can have come before the other only by passing through it.
std::vector<SeenCrossing> find_intersections_seen(const CheckedScene& scene, const PageMap& map, const Sight& sight,
                                                  const CheckOptions& options);

}  // namespace ligne::check
