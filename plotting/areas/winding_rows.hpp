#pragma once
/// Winding numbers of places on rows and columns across the page. Private to plotting.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "areas/steps.hpp"

namespace ligne::svg {

/// A place on the supporting line of a stroke, as a fraction of the stroke, and the winding number there.
struct Anchor {
  double at = 0;
  std::int32_t winding = 0;
};

/// Rows and columns across the contours. Each has the edges that cross it, sorted, and the running sums of their
/// windings. Rows are one mean edge extent apart, so that a stroke finds one near its begin, and each edge crosses
/// about one.
///
/// All edges lie farther than kClear steps from an anchor. So the windings there are the same for both sides of
/// the stroke, and do not change when vertices that lie on the stroke's line up to rounding are moved to one side of it.
class WindingRows {
 public:
  /// `windings`: per edge, the sum over the contours along it. Time O(n log n).
  WindingRows(std::span<const StepSegment> edges, std::span<const std::int32_t> windings, const StepBox& box);

  /// An anchor before the begin of the stroke; nothing if edges lie too near to all places tried. Time O(log n).
  std::optional<Anchor> find_before(const StepSegment& stroke) const;

 private:
  /// The part of an edge that lies near a row or column: where it begins and ends along that line.
  struct NearPart {
    std::uint32_t line;
    double low, high;
    std::int32_t winding;  ///< gain of a walk along the line there
  };
  /// Parallel lines at equal distances: rows for axis 1, columns for axis 0.
  struct Lines {
    double first = 0, distance = 1;
    std::size_t count = 0;
    std::vector<std::uint32_t> begin;    ///< per line: its begin in the lists below
    std::vector<double> lows;            ///< ascending within a line
    std::vector<double> highs;           ///< ascending within a line
    std::vector<std::int32_t> windings;  ///< winding after each entry of `highs`
  };

  static Lines make_lines(int axis, std::span<const StepSegment> edges, std::span<const std::int32_t> windings,
                          const StepBox& box);
  static void add_near_parts(int axis, const Lines& lines, const StepSegment& edge, std::int32_t winding,
                             std::vector<NearPart>& parts);
  static std::optional<std::int32_t> winding_at(const Lines& lines, std::size_t line, double place);

  std::array<Lines, 2> lines_;  ///< by axis
};

}  // namespace ligne::svg
