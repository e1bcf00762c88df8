#pragma once
/// The edges of contours between numbered positions.

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/point.hpp"
#include "geometry/polygons/contour_sweep.hpp"

namespace ligne {

/// The corners of a polygon as positions: equal points share one position. Positions are numbered in lexicographic
/// order (x first), so the positions on an edge have numbers between those of its ends, in the order in which the edge
/// meets them.
struct ContourEdges {
  std::vector<Point2> positions;
  std::vector<std::uint32_t> source;  ///< per position: the lowest index of an input point at it
  std::vector<SweepEdge> edges;       ///< of the outer contour taken counter-clockwise and the holes taken clockwise
};

/// `points` and `contour_end` as in triangulate().
ContourEdges number_contour_edges(std::span<const Point2> points, std::span<const std::uint32_t> contour_end);

/// Appends the pieces of the edge between the positions that lie on it. Takes time proportional to the number of
/// positions between the edge's ends.
void append_pieces(const std::vector<Point2>& positions, const SweepEdge& edge, std::vector<SweepEdge>& pieces);

/// Cuts edges as append_pieces() does, faster for many edges: O(sqrt(n)) for an edge with n positions between its ends.
/// Positions are grouped in blocks, and each block is searched by the height at which the edge passes it.
class EdgeCutter {
 public:
  /// `positions` must outlive the cutter.
  explicit EdgeCutter(const std::vector<Point2>& positions);
  void append_pieces(const SweepEdge& edge, std::vector<SweepEdge>& pieces);

 private:
  void find_near(const SweepEdge& edge, std::size_t block);

  const std::vector<Point2>& positions_;
  std::size_t block_size_;
  std::vector<std::uint32_t> by_height_;  ///< positions, sorted by y within each block
  std::vector<std::uint32_t> near_;       ///< scratch: positions that may lie on the edge, ascending
};

/// +1 when the closed contour has its inside on the left, -1 when on the right, 0 when it has no area.
int contour_sign(std::span<const Point2> contour);

/// Sign of the turn at the lexicographically smallest corner of a contour; -1 if any pass of the contour through that
/// corner turns so.
int sign_at_smallest_corner(std::span<const Point2> contour);

}  // namespace ligne
