#pragma once
/// Converts the broken edges of a grid of samples to triangles that end on the true border.
///
/// The pieces of a cell's four edges on which the surface exists run counter-clockwise around the cell. Consecutive
/// pieces without a gap form an arc. From the end of an arc the border of the surface crosses the cell to the beginning
/// of an arc: to the next arc if the surface connects the two, else to its own.
///
///     C ------e     s---- D
///     |        .    .     |      e, s: ends of pieces; the borders e . s are found by
///     |         .    .    |      bisecting the formula across them
///     A -------- s   e -- B

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "scene/surfaces/contours/outside_cells.hpp"
#include "scene/surfaces/grids/grid_edges.hpp"
#include "scene/surfaces/surface_mesh.hpp"
#include "scene/surfaces/surface_points.hpp"

namespace ligne {

class CellContours {
 public:
  /// Flag of the numbers of vertices that a row of cells makes itself.
  static constexpr std::uint32_t kOwn = 0x80000000u;
  struct Found {
    std::vector<Point3> points;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<std::array<std::uint8_t, 3>> flags;
  };

  /// `range`: the range of the heights that count. `vertices` are the samples; the ends of the pieces are added to
  /// them.
  CellContours(const SurfacePoints& surface, const HeightWindow& window, double range, const std::vector<BrokenEdge>& broken,
               std::vector<Point3>& vertices);

  /// Makes the triangles of the cells between rows j and j + 1. Several threads may call it at a time.
  void cut_row(std::size_t j, Found& found) const;

 private:
  friend class CellCut;

  /// A vertex, and the flags of the edge from it to the next one.
  struct Corner {
    std::uint32_t vertex;
    std::uint8_t flags;
  };
  struct Piece {
    bool from_start, to_end;
    std::vector<std::uint32_t> vertices;  ///< without the samples at the ends of the edge
  };

  bool counts(std::size_t sample) const { return window_.holds(surface_.points[sample].z); }
  const std::vector<Piece>* broken(GridEdge edge) const {
    const auto place = pieces_.find(edge.key());
    return place == pieces_.end() ? nullptr : &place->second;
  }
  std::array<std::uint8_t, 4> side_flags(std::size_t i, std::size_t j) const;

  const SurfacePoints& surface_;
  HeightWindow window_;
  const std::vector<Point3>& vertices_;
  OutsideCells outside_;
  double heights_to_cells_;  ///< scales the range of heights to half of the ground, whose cells have sides of 1
  std::unordered_map<std::size_t, std::vector<Piece>> pieces_;
};

}  // namespace ligne
