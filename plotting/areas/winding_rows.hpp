#pragma once
/// How often contours wind round places on lines across the page. Private to plotting.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "areas/edge_tree.hpp"
#include "areas/steps.hpp"

namespace ligne::svg {

/// A place on the line of a stroke, at this fraction of it, and how often contours wind round it.
struct Anchor {
  double at = 0;
  std::int32_t winding = 0;
};

/// Rows and columns across the contours, with the edges that cross each, in order, and the sums of their windings. A row is
/// as high as the edges are on the average, so that a stroke finds one near its begin, and that each edge crosses about one.
///
/// All edges lie farther than kClear steps from an anchor. So the windings there are the same for both sides of
/// the stroke, and do not change when vertices that lie on the stroke's line up to rounding are moved to one side of it.
class WindingRows {
 public:
  /// Time: n log n. `windings`: of contours along each edge.
  WindingRows(std::span<const StepSegment> edges, std::span<const std::int32_t> windings, const StepBox& box);

  /// A place before the begin of the stroke; nothing where edges lie too near to all places at hand. Time: log n.
  std::optional<Anchor> find_before(const StepSegment& stroke) const;

 private:
  /// The part of an edge that lies near a line across: where it begins and ends along the line.
  struct NearPart {
    std::uint32_t line;
    double low, high;
    std::int32_t winding;  ///< what a walk along the line gains there
  };
  /// Lines across at equal distances: rows for axis 1, columns for axis 0.
  struct Lines {
    double first = 0, distance = 1;
    std::size_t count = 0;
    std::vector<std::uint32_t> begin;    ///< of each line, in the lists that follow
    std::vector<double> lows;            ///< ascending within a line
    std::vector<double> highs;           ///< ascending within a line
    std::vector<std::int32_t> windings;  ///< behind each of `highs`
  };

  static Lines make_lines(int axis, std::span<const StepSegment> edges, std::span<const std::int32_t> windings,
                          const StepBox& box);
  static void add_near_parts(int axis, const Lines& lines, const StepSegment& edge, std::int32_t winding,
                             std::vector<NearPart>& parts);
  static std::optional<std::int32_t> winding_at(const Lines& lines, std::size_t line, double place);

  std::array<Lines, 2> lines_;  ///< by axis
};

}  // namespace ligne::svg
