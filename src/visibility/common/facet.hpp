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

}  // namespace ligne
