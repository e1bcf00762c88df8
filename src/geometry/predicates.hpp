#pragma once
/// Exact signs for points with double coordinates.

#include "geometry/point.hpp"

namespace ligne {

/// Sign of the area of the triangle a, b, c: +1 when a -> b -> c turns from +x towards +y, -1 when it turns the other way,
/// 0 when two points are equal or all three are collinear.
///
/// Identities: orientation_sign(a,b,c) == orientation_sign(b,c,a) == -orientation_sign(b,a,c).
/// Exact while products of coordinates neither overflow nor underflow: every coordinate is 0 or of size 2^-480 .. 2^500.
///
/// Method: the determinant in doubles is trusted if it exceeds kOrientationErrorBound times the sum of the sizes of its
/// two products. Otherwise an exact expansion adds its two products, if the differences in them are exact, or else the
/// six products of the expanded determinant (Shewchuk 1997, "Adaptive precision floating-point arithmetic and fast
/// robust geometric predicates", sections 2.2 to 2.4 and 4.2).
int orientation_sign(Point2 a, Point2 b, Point2 c);

/// Error bound of the rounded determinant, relative to the sum of the sizes of both products. Each product
/// carries three roundings of u = 2^-53 (two differences, one product) and the last difference one more, which Shewchuk
/// bounds by (3 + 16 u) u relative to the rounded sum of sizes.
inline constexpr double kOrientationErrorBound = (3.0 + 16.0 * 0x1p-53) * 0x1p-53;

}  // namespace ligne
