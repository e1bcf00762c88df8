#pragma once
/// From the broken edges of a grid of samples to triangles that end on the true border.
///
/// Round a cell run, counter-clockwise, the pieces of its four edges that the surface holds. Pieces that follow each other
/// without a gap make an arc. From the end of an arc the border of the surface runs through the cell to the beginning of
/// an arc: of the next one where the surface goes on between the two, else of its own.
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
  /// Numbers of vertices that a row of cells has made itself.
  static constexpr std::uint32_t kOwn = 0x80000000u;
  struct Found {
    std::vector<Point3> points;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<std::array<std::uint8_t, 3>> flags;
  };

  /// `range`: of the heights that count. `vertices` are the samples; the ends of the pieces are added to them.
  CellContours(const SurfacePoints& surface, const HeightWindow& window, double range, const std::vector<BrokenEdge>& broken,
               std::vector<Point3>& vertices);

  /// The triangles of the cells between rows j and j + 1. From several threads at a time.
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
    std::vector<std::uint32_t> vertices;  ///< without the samples at the edge's ends
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
  double heights_to_cells_;  ///< the range of heights becomes half of the ground, whose cells have sides of 1
  std::unordered_map<std::size_t, std::vector<Piece>> pieces_;
};

}  // namespace ligne
