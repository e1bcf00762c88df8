#pragma once
/// The visible and hidden runs of contours, and their junctions with other lines.
///
/// The faces that hide a contour, and the lines that it hides, were computed from the mesh. The contour as drawn runs
/// up to the height of a chord's arc beside the outline of the mesh. So ends of visible parts are moved along their own
/// line to the point where it crosses the line that is drawn.

#include <algorithm>
#include <vector>

#include "base/no_index.hpp"
#include "contours/contour_curves.hpp"
#include "geometry/search/line_cells.hpp"
#include "linework/stroke.hpp"

namespace ligne {

struct SmoothContours;

/// State of a run: the number of transparent faces in front of it, if it is visible, or one of these.
inline constexpr int kHiddenState = -1;
inline constexpr int kOutsideState = -2;  ///< outside the window of the view

/// A part of a curve with one state, between two values of CurvePoint::at.
struct ContourRun {
  double from = 0, to = 0;
  int state = kHiddenState;
};

/// Makes the runs of a chain of `segments` segments from their strokes, sorted by source; segment i has the source
/// `first_source` + i. With `hidden_too` hidden parts have strokes, so parts without a stroke are outside; otherwise
/// parts without a stroke are hidden.
std::vector<ContourRun> runs_of(const std::vector<Stroke>& strokes, std::uint32_t first_source, std::size_t segments,
                                bool hidden_too);

/// Overwrites the states of `runs` within the intervals of `changed`, which must be ascending.
void put_in(std::vector<ContourRun>& runs, const std::vector<ContourRun>& changed);

/// Gives runs shorter than `shortest_mm` on the page the state of their longer neighbour.
void drop_short_runs(std::vector<ContourRun>& runs, const ContourCurve& curve, double shortest_mm);

/// A straight piece of a line that may hide another.
struct OutlineSegment {
  Point2 from{0, 0}, to{0, 0};
  double z_from = 0, z_to = 0;
  std::uint32_t chain = kNone;            ///< index of its contour; kNone if it is another line
  double length_from = 0, length_to = 0;  ///< arc lengths along the contour, page mm
  double beside_mm = 0;                   ///< largest distance of the mesh's outline from the contour there

  /// Whether its bounding box lies within `reach` of p in x and in y: a quick test before its distance is computed.
  bool may_reach(Point2 p, double reach) const {
    return std::max(from.x, to.x) >= p.x - reach && std::min(from.x, to.x) <= p.x + reach &&
           std::max(from.y, to.y) >= p.y - reach && std::min(from.y, to.y) <= p.y + reach;
  }
};

/// Finds segments near a query segment, by a grid.
class SegmentFinder {
 public:
  /// `cell_mm` is the side of a grid cell.
  SegmentFinder(const Lattice& lattice, double cell_mm);
  /// Limits the queries to a box. To be called before the first add().
  void expect_within(const Rect& box) { box_ = box; }
  /// Stores a segment, unless it lies outside the box of the queries. Segments may be long and far outside the page.
  void add(const OutlineSegment& segment);
  /// Calls found(segment) for all segments within the reach of from-to; for some of them more than once.
  template <class Found>
  void near(Point2 from, Point2 to, double reach_mm, const Found& found) const {
    any_near(from, to, reach_mm, [&](const OutlineSegment& s) {
      found(s);
      return false;
    });
  }
  /// As near(), until found(segment) returns true. Returns whether it did.
  template <class Found>
  bool any_near(Point2 from, Point2 to, double reach_mm, const Found& found) const {
    return cells_.near(lattice_.snap(from), lattice_.snap(to), reach_mm / lattice_.step_mm,
                       [&](std::uint32_t i) { return found(segments_[i]); });
  }

 private:
  Lattice lattice_;
  LineCells cells_;
  Rect box_;  ///< of all queries; at first the extent of the lattice
  std::vector<OutlineSegment> segments_;
};

/// A contour with its visible and hidden runs.
struct SeenContour {
  ContourCurve curve;
  std::vector<ContourRun> runs;
  std::vector<double> beside_mm;  ///< per segment: largest distance of the mesh's outline; empty: 0
};

/// Moves the ends of the visible runs of contours onto visible lines in front that cross them. The reach of a move is
/// `reach_mm`, or half a segment of the contour if that is longer. A hidden run shorter than twice the reach becomes visible
/// if no line crosses its ends: it is an artefact of the mesh.
void move_ends_of_contours(std::vector<SeenContour>& contours, const StrokeModel& others, double reach_mm);

/// Moves the ends at which other visible strokes become hidden onto visible contours in front of them.
void move_ends_of_strokes(StrokeModel& others, const std::vector<SeenContour>& contours, double reach_mm);

/// Leads free ends of visible tangent lines, on an edge at which a visible contour runs from one surface into another
/// (ContourNode::is_joint), to that place. The new strokes get sources in StrokeModel::intersections. `seen`: per chain of
/// `contours`.
void join_tangents_to_contours(StrokeModel& model, const Scene& scene, const View& view, const SmoothContours& contours,
                               const std::vector<SeenContour>& seen);

}  // namespace ligne
