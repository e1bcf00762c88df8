#pragma once
/// Where lines meet contours: T-junctions.
///
/// The faces that hide a contour, and the lines that it hides, were found at the mesh; the contour that is drawn runs up to
/// a chord's rise beside the outline of the mesh. So ends of visible parts are moved along their own line to where it
/// crosses the line that is drawn.

#include <vector>

#include "base/key_table.hpp"
#include "base/no_index.hpp"
#include "contours/contour_states.hpp"
#include "drawing/stroke.hpp"

namespace ligne {

/// A straight piece of a line that may hide another.
struct OutlineSegment {
  Point2 from{0, 0}, to{0, 0};
  double z_from = 0, z_to = 0;
  std::uint32_t chain = kNone;            ///< of a contour, else kNone
  double length_from = 0, length_to = 0;  ///< along the contour
};

/// Segments near places that are asked about.
class SegmentFinder {
 public:
  explicit SegmentFinder(double cell_mm) : cell_mm_(cell_mm) {}

  /// A segment will be asked about. To be called before the first add().
  void expect(Point2 from, Point2 to);
  /// Segments that nothing expected passes are left out. They may be long, and lie far away.
  void add(const OutlineSegment& segment);
  /// Calls found(segment) for the segments that may cross from-to; some more than once.
  template <class Found>
  void near(Point2 from, Point2 to, Found found) const {
    for_cells(cells_round(from, to), [&](std::uint64_t key) {
      const std::uint32_t cell = cells_.find(key);
      if (cell == kNone) return;
      for (const std::uint32_t i : lists_[cell]) found(segments_[i]);
    });
  }

 private:
  /// Cells [x0, x1] x [y0, y1].
  struct Rectangle {
    std::int32_t x0 = 0, x1 = -1, y0 = 0, y1 = -1;
    friend bool operator==(const Rectangle&, const Rectangle&) = default;
  };
  /// Those of the rectangle round the segment.
  Rectangle cells_round(Point2 from, Point2 to) const;
  template <class Visit>
  static void for_cells(const Rectangle& cells, Visit visit);

  double cell_mm_;
  Point2 low_{1e300, 1e300}, high_{-1e300, -1e300};  ///< of all that is expected
  KeyTable cells_;                                   ///< of each cell that is asked about the list
  Rectangle expected_;                               ///< last: mostly the next one is the same
  std::vector<std::vector<std::uint32_t>> lists_;
  std::vector<OutlineSegment> segments_;
};

/// The fraction of `from`-`to` at which the segment crosses it, and the depth of the segment there; false when it does not.
bool crossing(Point2 from, Point2 to, const OutlineSegment& segment, double& fraction, double& depth);

/// A contour with what is seen of it.
struct SeenContour {
  ContourCurve curve;
  std::vector<ContourRun> runs;
  std::vector<int> sides;  ///< per segment: see ContourSight::side
};

/// Moves the ends of the visible runs of contours onto the visible lines that hide them, by `reach_mm` at the most or half
/// the segments of their mesh. Hidden runs twice as short as that, which no line crosses and that are no turn at a cusp, are
/// a fault of the mesh, and are seen.
void move_ends_of_contours(std::vector<SeenContour>& contours, const StrokeModel& others, double reach_mm);

/// Moves the ends of other visible strokes, where these are hidden, onto visible contours in front of them.
void move_ends_of_strokes(StrokeModel& others, const std::vector<SeenContour>& contours, double reach_mm);

}  // namespace ligne

#include "contours/contour_junctions.inl.hpp"
