#pragma once
/// The smooth surface through the vertices of a mesh, to the third order round each of them.
///
/// A mean of the normals of faces is exact on spheres; where a surface bends differently in different directions it is as
/// wrong as the triangles round the vertex are uneven. A polynomial of degree three through the vertices of two rings knows
/// the normal to the third order of their distance, and how it turns [CazalsPouget2005].

#include <array>
#include <cstdint>
#include <span>

#include "geometry/point.hpp"

namespace ligne {

/// A symmetric matrix (xx, xy, xz, yy, yz, zz): the normal changes by its product with the way along the surface.
using NormalTurn = std::array<double, 6>;

Point3 turned(const NormalTurn& turn, const Point3& way);

struct SurfaceFit {
  Point3 normal{0, 0, 0};
  NormalTurn turn{};
};

/// The surface through `at` that comes nearest to the points round it, which may be reordered; `normal`: an estimate of unit
/// length. False where they do not lie on such a surface, or do not say which.
bool fit_surface(const Point3& at, const Point3& normal, std::span<const Point3> points, SurfaceFit& fit);

}  // namespace ligne
