#pragma once
/// The smooth surface through the vertices of a mesh, to the third order round each of them.
///
/// A mean of the normals of faces is exact on spheres; where a surface bends differently in different directions it is as
/// wrong as the triangles round the vertex are uneven. A polynomial of degree three through the vertices of two rings knows
/// the normal to the third order of their distance, and how it turns [CazalsPouget2005].

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "geometry/point.hpp"

namespace ligne {

/// A symmetric matrix (xx, xy, xz, yy, yz, zz): the normal changes by its product with the way along the surface.
using NormalTurn = std::array<double, 6>;

Point3 turned(const NormalTurn& turn, const Point3& way);

/// The input of a fit: the surface passes through `at` and comes nearest to the points round it.
struct PointsRound {
  Point3 at{0, 0, 0};
  Point3 normal{0, 0, 1};  ///< an estimate, of unit length
  std::span<const Point3> points{};
};

struct SurfaceFit {
  Point3 normal{0, 0, 0};
  NormalTurn turn{};
};

/// The surfaces of two places at once, which takes hardly longer than one. None where the points do not lie on such a
/// surface, or do not say which; each is the same whatever the other is.
std::array<std::optional<SurfaceFit>, 2> fit_two_surfaces(const std::array<PointsRound, 2>& fits);

/// One of them alone; false where there is none.
bool fit_surface(const Point3& at, const Point3& normal, std::span<const Point3> points, SurfaceFit& fit);

}  // namespace ligne
