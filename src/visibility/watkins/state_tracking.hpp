#pragma once
/// Edges tracked from line to line by their states, as [Boulle1980] 2.3.4 describes it: 2 visible on this line, 1 visible
/// on the line before, 0 invisible. A part begins on the line on which its edge becomes visible. So the ends of strokes are
/// imprecise by up to one line (figure 2.57), and edges that no line meets are missing. EdgeTracker has the exact ends.

#include <cstdint>
#include <span>
#include <vector>

#include "visibility/common/open_parts.hpp"
#include "visibility/penetration/penetration.hpp"
#include "visibility/watkins/line_scan.hpp"

namespace ligne::watkins {

/// Where the part of an edge ends that is hidden from some line on: on the last line on which it was visible, or on the
/// first one on which it is hidden, so that it crosses the edge that hides it.
enum class PartEnd : std::uint8_t { last_visible, first_hidden };

/// A visible part of a line: where it is on its first and on its last scan line, as parameters on the line.
struct TrackedPart {
  std::uint32_t line;         ///< index of the SweepLine
  std::uint32_t first, last;  ///< scan lines on which it is visible
  double from, to;            ///< on these lines
  double beyond;              ///< on the first line on which it is hidden; `to` where the edge ends before it
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
  void ended(const LineScan&, std::uint32_t) override {}
  void hidden_point(const LineScan&, std::uint32_t, std::uint32_t) override {}

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

/// The visible parts of all lines, joined over the seams of groups.
class TrackedParts {
 public:
  TrackedParts() = default;
  /// `parts` by group, from the top.
  TrackedParts(const std::vector<std::vector<TrackedPart>>& parts, std::size_t line_count);

  /// The parts of a line, ascending; parts that are a point on one line have no length.
  std::vector<LinePart> visible_parts(std::size_t line, PartEnd end) const;
  std::size_t points() const;  ///< parts that are visible on one line only

 private:
  std::vector<std::uint32_t> first_;
  std::vector<TrackedPart> parts_;
};

/// The curves along which skew faces penetrate others: a straight piece from each line to the next. A piece is left out
/// where the two faces have more points on one line than on the next.
std::vector<Intersection> curves_of_points(std::vector<PenetrationPoint> points, const ScanScene& scene);

/// The points as marks on the page, one cell wide, so that each of them can be drawn.
std::vector<Intersection> marks_of_points(const std::vector<PenetrationPoint>& points, const ScanScene& scene);

}  // namespace ligne::watkins
