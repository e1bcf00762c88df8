#pragma once
/// Fits a polynomial surface to the vertices around a vertex of a mesh, for its normal and curvature.
///
/// A mean of face normals is exact on spheres. Where the curvature depends on the direction, its error grows with the
/// unevenness of the triangles around the vertex. A polynomial of degree three through the vertices of two rings gives
/// the normal with an error of third order in their distance, and the derivative of the normal [CazalsPouget2005].

#include <array>
#include <optional>
#include <span>

#include "geometry/point.hpp"

namespace ligne {

/// The derivative of the unit normal along the surface (shape operator), as a symmetric matrix (xx, xy, xz, yy, yz,
/// zz).
using NormalTurn = std::array<double, 6>;

/// The change of the normal for the displacement `way` along the surface: the product of matrix and vector.
Point3 turned(const NormalTurn& turn, const Point3& way);

/// The input of a fit: the surface passes through `at` and approximates the points around it.
struct PointsRound {
  Point3 at{0, 0, 0};
  Point3 normal{0, 0, 1};  ///< estimate of the normal, unit length
  std::span<const Point3> points{};
};

struct SurfaceFit {
  Point3 normal{0, 0, 0};  ///< of unit length
  NormalTurn turn{};       ///< derivative of the normal
};

/// Fits surfaces at two places at once (SIMD), which takes hardly longer than one fit. A result is nothing if the
/// points do not lie on such a surface or do not determine it. The two results do not depend on each other.
std::array<std::optional<SurfaceFit>, 2> fit_two_surfaces(const std::array<PointsRound, 2>& fits);

/// Fits the surface at one place. Returns false if there is none.
bool fit_surface(const Point3& at, const Point3& normal, std::span<const Point3> points, SurfaceFit& fit);

}  // namespace ligne
