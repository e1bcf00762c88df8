#pragma once
/// Triangulates faces that are not planar.

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/point.hpp"

namespace ligne {

/// A face outside a scene: the corners of its contours, one contour after the other.
struct DetachedFace {
  std::vector<std::uint32_t> corners;      ///< vertex indices
  std::vector<std::uint8_t> flags;         ///< CornerFlag per corner
  std::vector<std::uint32_t> contour_end;  ///< one past the last corner of each contour; the first contour is outer
};

struct CutTriangle {
  std::array<std::uint32_t, 3> vertices;
  std::array<std::uint8_t, 3> flags;
};

/// Whether the distance of every corner from the plane of the corners is within the precision of the coordinates
/// (planarity_tolerance()). Always true for a triangle.
bool is_planar(const std::vector<Point3>& vertices, const DetachedFace& face, double precision);

/// Whether the triangles of a planar face cover all of it: false if its contours cross so that a part is lost.
bool is_covered(const std::vector<Point3>& vertices, const DetachedFace& face);

/// Cuts the face into triangles, wound like its outer contour, in the projection along the dominant axis of its area
/// vector. New edges carry kCornerInner. Returns nothing if the projection has no area. `covered` is set to whether the
/// triangles cover the whole projection, as is_covered() does.
std::vector<CutTriangle> cut_into_triangles(const std::vector<Point3>& vertices, const DetachedFace& face, bool& covered);

}  // namespace ligne
