#pragma once
/// Edges and triangles in the order in which the sweep asks about them, and adds them to the horizons.

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <vector>

#include "visibility/horizon/curve_tracker.hpp"
#include "visibility/horizon/envelope.hpp"
#include "visibility/horizon/eye.hpp"
#include "visibility/horizon/sight_line.hpp"

namespace ligne::horizon {

/// A segment is upright on the drawing plane when its ends are no farther apart across it than this part of the picture.
inline constexpr double kUprightPart = 0x1p-42;

/// Where a segment can be seen: above all that is nearer, below it, or either. A surface that rises in the picture behind
/// the line of sight shows itself above its nearer parts only.
enum class Against : std::uint8_t { upper, lower, both };

/// Which sides of an upright line are looked at. It is hidden where all of them are covered; curves that hide have no sides.
enum class LineSides : std::uint8_t { left, right, both, none };

/// The use of the seen parts of an edge; `nothing`: nobody asks. An interruption is no edge, but the end of a curve's
/// stretch.
enum class Goal : std::uint8_t {
  nothing,
  curve,
  underside,
  outline,
  border,
  contour,
  base_contour,
  back_line,
  interruption
};

struct SightEdge {
  SightLine line;
  double from = 0, to = 1;                  ///< of the segment from a to b, what the line is
  const Sample *a = nullptr, *b = nullptr;  ///< placed; of edges that are asked for
  CurveTracker* curve = nullptr;            ///< that it is a segment of
  std::uint32_t number = 0;                 ///< of the contour's height, or of the line off the surface
  std::uint16_t first_band = 0, last_band = 0;
  Goal goal = Goal::nothing;
  Against against = Against::both;
  LineSides sides = LineSides::both;
  bool upper = false, lower = false;  ///< it then becomes part of the upper, of the lower horizon
  bool open = true;                   ///< what the band found of an upright line

  bool is_asked() const { return goal != Goal::nothing && goal != Goal::interruption; }
};

using SightTriangle = std::array<SightPoint, 3>;

/// The part of an edge that a band sees.
struct SeenSpan {
  std::uint32_t edge;
  bool below;  ///< the lower horizon, where both are asked
  Span span;
};

/// The edges and triangles of a strip of the grid.
struct EdgeList {
  static constexpr std::uint32_t kTriangle = std::uint32_t{1} << 31;

  std::vector<SightEdge> edges;
  std::vector<SightTriangle> triangles;
  std::deque<Sample> samples;     ///< ends of edges that are no samples of rows, or are placed for them alone
  CurveTracker nearest_row, row;  ///< of the part's first row, and of the row behind the strip
  std::vector<std::vector<std::uint32_t>> of_band;  ///< what each band takes: numbers of edges, of triangles with kTriangle
  std::vector<std::vector<SeenSpan>> seen;          ///< by each band, in the order of the edges
  std::size_t asked = 0;                            ///< edges of the surface that are asked for

  void clear() {
    edges.clear();
    triangles.clear();
    samples.clear();
    for (auto& numbers : of_band) numbers.clear();
    for (auto& spans : seen) spans.clear();
    nearest_row = row = CurveTracker();
    asked = 0;
  }
};

}  // namespace ligne::horizon
