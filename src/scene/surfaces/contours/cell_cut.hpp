#pragma once
/// Cuts one cell of CellContours.

#include <optional>
#include <vector>

#include "scene/surfaces/contours/cell_contours.hpp"

namespace ligne {

class CellCut {
 public:
  CellCut(const CellContours& grid, std::size_t i, std::size_t j, LineBreaks& breaks, CellContours::Found& found)
      : grid_(grid), i_(i), j_(j), breaks_(breaks), found_(found) {}

  /// Adds the triangles of the cell.
  void run();

 private:
  using Corner = CellContours::Corner;
  struct Arc {
    std::vector<Corner> corners;
    bool closed = false;
  };

  bool is_whole() const;
  void add_whole();
  std::vector<Arc> arcs() const;
  void add_polygons(const std::vector<Arc>& arcs);
  void add_polygon(const std::vector<Corner>& polygon);
  void add_torn(const std::vector<Corner>& polygon);
  void add(const Corner& a, const Corner& b, const Corner& c);

  void append_border(Corner from, Corner to, std::uint32_t inner, std::vector<Corner>& polygon);
  std::optional<Point3> border_between(const Point3& from, const Point3& to, const Point3& inner);
  bool connected(std::uint32_t a, std::uint32_t b);
  std::uint32_t inner_of(const Arc& arc) const;
  std::uint8_t rim_flag() const;

  Point3 point(std::uint32_t vertex) const;
  std::uint32_t sample(std::size_t di, std::size_t dj) const;
  /// Coordinates of a point in the cell, from 0 to 1 on both axes.
  Point2 in_cell(const Point3& p) const;
  Point2 in_plane(Point2 cell) const;

  const CellContours& grid_;
  std::size_t i_, j_;
  LineBreaks& breaks_;
  CellContours::Found& found_;
};

}  // namespace ligne
