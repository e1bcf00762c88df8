#pragma once
/// The triangles of a projected scene, prepared for tests against lines and cells.
///
/// Notation: a facet has corners p0, p1, p2 on the lattice, turned so that orientation(p0, p1, p2) > 0. Its side i runs from
/// p_i to p_(i+1); E_i(q) = orientation(p_i, p_(i+1), q) is positive inside. Depth over its plane is
/// z(q) = (E_1(q) z_0 + E_2(q) z_1 + E_0(q) z_2) / area, with area = orientation(p0, p1, p2).

#include <cstdint>
#include <vector>

#include "view/projected_scene.hpp"

namespace ligne {

/// Order in depth of two surfaces where they overlap on the page.
enum class DepthOrder : std::uint8_t {
  apart,     ///< they have no part of the page in common
  first,     ///< the first is in front
  second,    ///< the second is in front
  level,     ///< within the depth tolerance of each other all over
  crossing,  ///< the first is in front in one part, the second in another
};

/// A triangle that hides.
struct Facet {
  std::uint32_t v[3];     ///< projected vertices, positively turned
  std::uint32_t face;     ///< face of the scene
  float z_near, z_far;    ///< bounds of its depth, rounded outwards
  float depth_tolerance;  ///< surfaces within this depth of it touch it; see depth_tolerance_mm()
  float size;             ///< largest |dx| + |dy| of its sides, rounded up
};

/// Distance in depth, in mm, within which an object touches a facet. `gradient` is its depth gradient, as the sum of
/// absolute values in mm per step. The lattice moves a facet and an edge by at most half a step each in x and in y; the
/// input's own error moves both too. See docs/numerics.md, "Touching".
double depth_tolerance_mm(const ProjectedScene& scene, double gradient, double z_near);

/// Facets are made of the triangles with area on the lattice, except those of faces seen edge on. A face is thin if one
/// of its triangles is at most `thin_steps` lattice steps high on the page, so that its edges lie on each other.
struct Facets {
  std::vector<Facet> facets;
  std::vector<std::uint8_t> face_is_thin;
  std::vector<std::uint8_t> joined{};  ///< joined_facets(), or empty
};
Facets make_facets(const ProjectedScene& scene, double thin_steps);

/// Rounds a double to a float towards minus or plus infinity.
float round_down(double v);
float round_up(double v);

/// Number of vertices that two facets have in common.
template <class AnyFacet>
int common_corners(const AnyFacet& a, const AnyFacet& b) {
  int n = 0;
  for (const std::uint32_t v : a.v) n += v == b.v[0] || v == b.v[1] || v == b.v[2];
  return n;
}

/// The sides and the depth of a facet as linear functions over the page:
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
