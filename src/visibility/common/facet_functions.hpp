#pragma once
/// A facet's sides and depth as linear functions over the page.

#include "visibility/common/facet.hpp"

namespace ligne {

/// E_i(x, y) = ex x + ey y + e, and depth z(x, y) = zx x + zy y + z. The arithmetic is rounded: for searches, not for
/// decisions.
struct FacetFunctions {
  double ex[3] = {}, ey[3] = {}, e[3] = {};
  double zx = 0, zy = 0, z = 0;
  double slack = 0;  ///< depth tolerance of the facet, which bounds the error of depths computed here

  double depth(double x, double y) const { return zx * x + zy * y + z; }

  FacetFunctions() = default;
  FacetFunctions(const Facet& f, const ProjectedVertex* vertices) {
    const ProjectedVertex* p[3] = {&vertices[f.v[0]], &vertices[f.v[1]], &vertices[f.v[2]]};
    for (int i = 0; i < 3; ++i) {
      const LatticePoint a = p[i]->p, b = p[(i + 1) % 3]->p;
      ex[i] = -(double(b.y) - a.y);
      ey[i] = double(b.x) - a.x;
      e[i] = -(ex[i] * a.x + ey[i] * a.y);
    }
    const double area = orientation(p[0]->p, p[1]->p, p[2]->p);
    const double dz1 = p[1]->z - p[0]->z, dz2 = p[2]->z - p[0]->z;
    // side 0 runs p0 -> p1, side 2 runs p2 -> p0
    zx = (ex[2] * dz1 + ex[0] * dz2) / area;
    zy = (ey[2] * dz1 + ey[0] * dz2) / area;
    z = p[0]->z - zx * p[0]->p.x - zy * p[0]->p.y;
    slack = f.depth_tolerance;
  }
};

}  // namespace ligne
