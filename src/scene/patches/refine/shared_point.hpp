#pragma once
/// Points on the common border of two surfaces.

#include <optional>

#include "scene/patches/find_patches.hpp"

namespace ligne {

/// The surface on one side of an edge: a recognised surface, or a plane.
struct SideSurface {
  const PatchSurface* surface = nullptr;  ///< null: the plane
  Point3 at{0, 0, 0}, normal{0, 0, 1};    ///< a point of the plane and its unit normal

  /// Signed distance of a point, positive on the side of the normal.
  double distance(const Point3& p) const;
  /// Unit normal at the nearest point.
  Point3 normal_at(const Point3& p) const;
};

/// A point of both surfaces beside the middle of an edge from p to q, whose ends lie on both. If the surfaces join
/// smoothly at the ends, it lies on the line along which they touch. Returns nothing if it is not found within half of
/// the length of the edge.
std::optional<Point3> shared_point(const SideSurface& a, const SideSurface& b, const Point3& p, const Point3& q);

}  // namespace ligne
