#pragma once
/// Faces that are not planar, and their triangles.

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/point.hpp"

namespace ligne {

/// A face that stands by itself: the corners of its contours, one contour after the other.
struct LooseFace {
  std::vector<std::uint32_t> corners;      ///< vertex indices
  std::vector<std::uint8_t> flags;         ///< CornerFlag per corner
  std::vector<std::uint32_t> contour_end;  ///< one past the last corner of each contour; the first contour is outer
};

struct CutTriangle {
  std::array<std::uint32_t, 3> vertices;
  std::array<std::uint8_t, 3> flags;
};

/// Whether every corner lies as near to the plane of the corners as the precision of the coordinates allows
/// (planarity_tolerance()). A triangle always does.
bool is_planar(const std::vector<Point3>& vertices, const LooseFace& face, double precision);

/// Whether the triangles of a planar face cover all of it: false when its contours cross so that a part is lost.
bool is_covered(const std::vector<Point3>& vertices, const LooseFace& face);

/// Cuts the face into triangles, wound as its outer contour is, in its projection along the dominant axis of its area
/// vector. Edges that the face did not have carry kCornerInner. Nothing comes back when the projection has no area.
/// `covered` says whether the triangles cover all of the projection, as is_covered() does.
std::vector<CutTriangle> cut_into_triangles(const std::vector<Point3>& vertices, const LooseFace& face, bool& covered);

}  // namespace ligne
