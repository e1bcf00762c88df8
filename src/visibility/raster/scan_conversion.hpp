#pragma once
/// Scan conversion of any polygon, with holes ([Boulle1980] 2.3.2.2 and 2.3.2.4; lecture, 5.1).
///
/// Notation: grid units. Scan line i is v = i; u is measured in the same unit along the line. The lines with v_top <= i
/// < v_bottom meet an edge. So where two edges join at a point on a line, the line counts one of them, or at a peak two
/// or none, and parity is right at every vertex. Edges that no line meets, such as horizontal ones, bound nothing.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/lattice.hpp"

namespace ligne {

/// The scan lines on the page. If `whole`, points are first rounded to the grid in both directions.
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

/// An edge as the lines meet it, updated by two additions per line. The accumulators are real for whole coordinates,
/// too: a whole u with a rounded step would stand still on a steep edge ([Boulle1980] figure 2.38).
struct EdgeTrack {
  double u = 0, z = 0;                ///< on the current line
  double du = 0, dz = 0;              ///< change from line to line
  std::uint32_t first = 0, last = 0;  ///< lines [first, last) meet the edge

  /// An edge that no line meets has first == last, and du, dz go from its upper end to its lower one.
  static EdgeTrack between(GridPoint a, GridPoint b, std::uint32_t line_count);

  void advance() {
    u += du;
    z += dz;
  }
  /// The edge on a line that meets it, to begin between its ends.
  EdgeTrack on(std::uint32_t line) const;
};

/// A polygon's run on one line.
struct PolygonRun {
  std::uint32_t line;
  double u0, u1;  ///< u0 <= u1
  double z0, z1;
};

/// Converts polygons one after the other. It keeps its working memory.
class PolygonScan {
 public:
  /// Begins a polygon, on the lines [first, end).
  void begin(std::uint32_t first, std::uint32_t end) {
    first_ = first;
    end_ = end;
    table_.clear();
  }

  /// Adds a side of a contour, in any direction and order. Two contours with a common side get equal places on it, to
  /// the last bit, so each point belongs to exactly one of two neighbours.
  void add(const GridPoint& a, const GridPoint& b);

  /// Calls run(PolygonRun) for all runs, line by line from the top and left to right, by the rule of parity.
  template <class Run>
  void scan(Run run);

 private:
  void take_active(std::uint32_t line, std::size_t& next);

  std::uint32_t first_ = 0, end_ = 0;
  std::vector<EdgeTrack> table_;   ///< sides, sorted by their first line
  std::vector<EdgeTrack> active_;  ///< sides that the current line meets, from left to right
};

/// All runs of a polygon. `contour_end[i]` is one past the last corner of contour i. Contours may have any winding and
/// may cross. Runs of length zero are included, so that no vertex on a line is lost.
std::vector<PolygonRun> scan_polygon(std::span<const GridPoint> corners, std::span<const std::uint32_t> contour_end,
                                     std::uint32_t line_count);

template <class Run>
void PolygonScan::scan(Run run) {
  if (table_.empty()) return;
  // One sort of the sides by their first line replaces the buckets.
  std::stable_sort(table_.begin(), table_.end(), [](const EdgeTrack& a, const EdgeTrack& b) { return a.first < b.first; });
  active_.clear();
  std::size_t next = 0;
  for (std::uint32_t line = table_.front().first; next < table_.size() || !active_.empty(); ++line) {
    take_active(line, next);
    for (std::size_t i = 0; i + 1 < active_.size(); i += 2) {
      run(PolygonRun{line, active_[i].u, active_[i + 1].u, active_[i].z, active_[i + 1].z});
    }
    if (active_.empty() && next < table_.size()) line = table_[next].first - 1;
  }
}

}  // namespace ligne
