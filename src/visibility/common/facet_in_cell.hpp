#pragma once
/// Tests of a facet against a cell of the screen grid.

#include <algorithm>
#include <cmath>

#include "visibility/common/cell_grid.hpp"
#include "visibility/common/facet.hpp"

namespace ligne {

struct PageBox {
  double left, right, top, bottom;
};

inline PageBox page_box(const Facet& f, const ProjectedVertex* vertices) {
  const LatticePoint a = vertices[f.v[0]].p, b = vertices[f.v[1]].p, c = vertices[f.v[2]].p;
  const auto [left, right] = std::minmax({a.x, b.x, c.x});
  const auto [top, bottom] = std::minmax({a.y, b.y, c.y});
  return {double(left), double(right), double(top), double(bottom)};
}

/// Approximate smallest height of a facet over a side, which limits the cells that the facet can cover.
inline double breadth(const Facet& f, const ProjectedVertex* vertices) {
  return orientation(vertices[f.v[0]].p, vertices[f.v[1]].p, vertices[f.v[2]].p) / f.size;
}

/// Child k of a split cell, row by row.
inline CellSquare child_square(const CellSquare& cell, int k) {
  const double size = cell.size / kSplitSide;
  const int column = k % kSplitSide, row = k / kSplitSide;
  return {cell.x + column * size, cell.y + row * size, size};
}

enum class Meeting { apart, meets, covers };

/// Tests the facet against the square widened by the margin. Unless they are apart, z_near and z_far bound the facet's
/// depths over the square.
inline Meeting meet(const FacetFunctions& g, const Facet& f, const CellSquare& square, double margin, double& z_near,
                    double& z_far) {
  const double half = square.size / 2, x = square.x + half, y = square.y + half, reach = half + margin;
  bool covers = true;
  for (int i = 0; i < 3; ++i) {
    const double centre = g.ex[i] * x + g.ey[i] * y + g.e[i];
    const double radius = (std::abs(g.ex[i]) + std::abs(g.ey[i])) * reach;
    if (centre + radius < 0) return Meeting::apart;
    if (centre - radius <= 0) covers = false;
  }
  const double z = g.zx * x + g.zy * y + g.z, dz = (std::abs(g.zx) + std::abs(g.zy)) * reach + g.slack;
  z_near = std::max<double>(f.z_near, z - dz);
  z_far = std::min<double>(f.z_far, z + dz);
  return covers ? Meeting::covers : Meeting::meets;
}

/// A facet that covers a cell: other facets that coincide with it there need not be listed.
struct NearestCover {
  FacetFunctions functions;
  std::size_t entry = 0;
  bool any = false;

  /// Whether another facet that covers the cell coincides with this one there, within the larger of their depth
  /// tolerances.
  bool stands_for(const FacetFunctions& other, const CellSquare& square) const {
    if (!any) return false;
    const double tolerance = std::max(functions.slack, other.slack);
    for (int corner = 0; corner < 4; ++corner) {
      const double x = square.x + (corner % 2) * square.size, y = square.y + (corner / 2) * square.size;
      if (!(std::abs(functions.depth(x, y) - other.depth(x, y)) <= tolerance)) return false;
    }
    return true;
  }
};

}  // namespace ligne
