#pragma once
/// Scan conversion of any polygon, holes and all ([Boulle1980] 2.3.2.2 and 2.3.2.4; lecture, 5.1).
///
/// Notation: grid units. Scan line i is v = i; u is measured in the same unit along the line. An edge is met by the lines
/// with v_top <= i < v_bottom, so of two edges that meet at a point on a line one is counted, at a peak two or none, and
/// parity is right at every vertex; edges that no line meets, horizontal ones among them, bound nothing.

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/lattice.hpp"

namespace ligne::watkins {

/// The scan lines on the page. On whole coordinates points are rounded to the grid in both directions before anything else.
struct LineGrid {
  double u_origin = 0, v_origin = 0;  ///< lattice steps
  double spacing = 1;                 ///< lattice steps from line to line
  std::uint32_t count = 1;            ///< lines 0 .. count - 1
  bool whole = false;

  double u(double x) const { return rounded((x - u_origin) / spacing); }
  double v(double y) const { return rounded((y - v_origin) / spacing); }
  double x(double u) const { return u_origin + u * spacing; }

 private:
  double rounded(double w) const { return whole ? std::floor(w + 0.5) : w; }
};

/// A corner on the page in grid units, with its depth.
struct GridPoint {
  double u, v, z;
};

/// An edge as the lines meet it, updated by two additions a line. The accumulators are real whatever the coordinates: a
/// whole u that were itself updated by a rounded step would stand still where the edge is steep ([Boulle1980] figure 2.38).
struct EdgeTrack {
  double u = 0, z = 0;                ///< on the line at hand
  double du = 0, dz = 0;              ///< from line to line
  std::uint32_t first = 0, last = 0;  ///< lines [first, last) meet it

  /// An edge that no line meets has first == last, and du, dz go from its upper end to its lower one.
  static EdgeTrack between(GridPoint a, GridPoint b, std::uint32_t line_count);

  void advance() {
    u += du;
    z += dz;
  }
  /// On that line, which meets it; used to begin somewhere inside.
  EdgeTrack on(std::uint32_t line) const;
};

/// A polygon's run on one line.
struct PolygonRun {
  std::uint32_t line;
  double u0, u1;  ///< u0 <= u1
  double z0, z1;
};

/// All runs of a polygon, line by line from the top and left to right, by the rule of parity. `contour_end[i]` is one past
/// the last corner of contour i; any winding, contours may cross. Runs of length zero are given too: with them no vertex on
/// a line is lost.
std::vector<PolygonRun> scan_polygon(std::span<const GridPoint> corners, std::span<const std::uint32_t> contour_end,
                                     std::uint32_t line_count);

}  // namespace ligne::watkins
