#pragma once
/// Edges tracked from line to line by their states, as [Boulle1980] 2.3.4 describes it: 2 visible on this line, 1 visible
/// on the line before, 0 invisible. A part begins on the line on which its edge becomes visible. So the ends of strokes are
/// imprecise by up to one line (figure 2.57), and edges that no line meets are missing. EdgeTracker has the exact ends.

#include <cstdint>
#include <span>
#include <vector>

#include "base/add_counts.hpp"
#include "base/index_lists.hpp"
#include "visibility/common/hidden_interval.hpp"
#include "visibility/common/open_parts.hpp"
#include "visibility/penetration/penetration.hpp"
#include "visibility/watkins/exact/exact_sweep.hpp"
#include "visibility/watkins/line_scan.hpp"

namespace ligne::watkins {

/// The scan line on which a visible part ends: the last one on which it is visible, or the first one on which it is hidden,
/// so that it crosses the edge that hides it.
enum class PartEnd : std::uint8_t { last_visible, first_hidden };

/// A visible part of a line. Places are parameters on the line.
struct TrackedPart {
  std::uint32_t line;         ///< index of the SweepLine
  std::uint32_t first, last;  ///< scan lines on which it is visible
  double from, to;            ///< where it meets these scan lines
  double beyond;              ///< where it meets the first scan line on which it is hidden; `to` if it ends before
};

/// A place on a scan line where two visible faces penetrate.
struct PenetrationPoint {
  double u, z;  ///< grid units; depth
  std::uint32_t line;
  std::uint32_t face0, face1;  ///< face0 < face1
};

/// Tracks one group of lines.
class StateTracker final : public LineListener {
 public:
  explicit StateTracker(std::span<const SweepLine> lines) : lines_(lines) {}

  void line(const LineScan& scan, std::uint32_t line, bool studied) override;

  /// The parts found so far, those of one line in order.
  std::vector<TrackedPart> take_parts();
  const std::vector<PenetrationPoint>& points() const { return points_; }

 private:
  void see(const LineScan& scan, std::uint32_t slot, std::uint32_t line);
  double place(const ScanEdge& edge, std::uint32_t line_index, std::uint32_t line) const;

  std::span<const SweepLine> lines_;
  std::vector<TrackedPart> parts_;
  std::vector<std::uint32_t> part_of_;  ///< by SweepLine: its last part, or kNone
  std::vector<PenetrationPoint> points_;
};

/// The visible parts of all lines, joined across the seams of the groups.
class TrackedParts {
 public:
  TrackedParts() = default;
  /// `parts` by group, from the top.
  TrackedParts(const std::vector<std::vector<TrackedPart>>& parts, std::size_t line_count);

  /// The parts of a line, ascending. A part visible on one scan line only has no length.
  std::vector<LinePart> visible_parts(std::size_t line, PartEnd end) const;
  std::size_t points() const;  ///< parts that are visible on one line only

 private:
  ListsOf<TrackedPart> parts_;  ///< by line
};

/// The curves along which skew faces penetrate others: a straight piece from each line to the next. A piece is left out
/// where the two faces have more points on one line than on the next.
std::vector<Intersection> curves_of_points(std::vector<PenetrationPoint> points, const ScanScene& scene);

/// The points as marks on the page, one cell wide, so that each of them can be drawn.
std::vector<Intersection> marks_of_points(const std::vector<PenetrationPoint>& points, const ScanScene& scene);

/// Visible edges tracked from line to line ([Boulle1980] 2.3.4, after Archuleta 1972).
///
/// On every studied scan line the spans give the state of each candidate line: visible on this scan line (2), visible on the
/// preceding one (1), invisible (0). [Boulle1980] draws from the scan line on which state 2 began to the last one on which
/// it held, so strokes end at scan lines. Here the tracker keeps the face that a span shows in front of an edge, and the
/// exact operation (common/hidden_interval.hpp) computes the part of the edge that it hides. Strokes therefore have exact
/// ends; the scan lines only limit which faces are found.
///
/// An edge is compared with the faces of all spans that it may pass between the preceding and the following scan line; a
/// flat edge passes many. An edge that no scan line meets, horizontal or between two scan lines, is compared with the spans
/// of both.
struct TrackCounts {
  std::uint64_t positions = 0;                          ///< edges examined on studied lines
  std::uint64_t became_visible = 0, became_hidden = 0;  ///< changes of state
  std::uint64_t facet_tests = 0;
  void operator+=(const TrackCounts& o) { add_counts(*this, o); }
};

class EdgeTracker final : public LineListener {
 public:
  EdgeTracker(const std::vector<ProjectedVertex>& vertices, const std::vector<Facet>& facets, const ScanScene& scene,
              std::span<const SweepLine> lines, double coincidence_steps)
      : vertices_(vertices), facets_(facets), scene_(scene), lines_(lines), coincidence_steps_(coincidence_steps) {}

  void line(const LineScan& scan, std::uint32_t line, bool studied) override;
  void ended(const LineScan& scan, std::uint32_t slot) override;
  void hidden_point(const LineScan& scan, std::uint32_t slot, std::uint32_t face) override;

  const std::vector<Finding>& findings() const { return findings_; }
  const TrackCounts& counts() const { return counts_; }

 private:
  enum class State : std::uint8_t { unknown, hidden, visible };
  struct Track {
    std::vector<std::uint32_t> tested;  ///< faces
    std::vector<HiddenInterval> hidden;
    State state = State::unknown;
    double t = 0;  ///< parameter at the last examined scan line
  };
  /// The tracks of the lines of one active edge.
  struct Tracks {
    std::vector<Track> of_line;
    std::size_t used = 0;
  };

  Tracks& tracks_of(const LineScan& scan, std::uint32_t slot);
  void look(const LineScan& scan, std::uint32_t slot, std::uint32_t line);
  void between_lines(const LineScan& scan, std::uint32_t line);
  void hold_part(const LineScan& scan, const ScanEdge& edge, double u0, double u1);
  void hold_against(std::uint32_t index, Track& track, std::uint32_t face);
  template <class Visit>
  void for_each_span(const LineScan& scan, double low, double high, Visit visit) const;

  const std::vector<ProjectedVertex>& vertices_;
  const std::vector<Facet>& facets_;
  const ScanScene& scene_;
  std::span<const SweepLine> lines_;
  double coincidence_steps_;
  std::vector<Tracks> tracks_;  ///< by slot
  std::vector<Finding> findings_;
  TrackCounts counts_;
};

}  // namespace ligne::watkins
