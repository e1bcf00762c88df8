#pragma once
/// Forms contours from the boundary edges of a planar region, and removes their needless vertices.

#include <cstdint>
#include <vector>

#include "geometry/point.hpp"
#include "scene/model/scene.hpp"

namespace ligne {

/// An edge of the boundary of a region; the region lies to its left.
struct BoundaryEdge {
  std::uint32_t from = 0, to = 0;
  std::uint8_t flags = 0;  ///< CornerFlag
};

/// A closed contour: vertices, and the flags of the edge from each to the next.
struct Contour {
  std::vector<std::uint32_t> corners;
  std::vector<std::uint8_t> flags;
};

/// A face of contours, the first outer, the others holes.
struct MergedFace {
  std::uint32_t material = 0;
  bool merged = false;  ///< made from several faces
  std::vector<Contour> contours{};
  std::uint32_t source = 0;  ///< Scene::face_source of its first face
};

/// The two model axes in which a plane is drawn so that its normal points at the viewer.
struct PlaneAxes {
  int right = 0, up = 1;
  static PlaneAxes facing(const Point3& normal);
  Point2 operator()(const Point3& p) const { return {p[right], p[up]}; }
};

/// Walks the boundary of a region into contours that visit no vertex twice, and assigns holes to the outer contours
/// around them. Equally many edges must leave and reach each vertex. Pairs of opposite edges vanish.
std::vector<MergedFace> faces_of_boundary(const std::vector<Point3>& vertices, const PlaneAxes& axes,
                                          std::vector<BoundaryEdge> edges);

/// Whether a point lies inside a contour (even-odd rule).
bool is_inside(const std::vector<Point3>& vertices, const PlaneAxes& axes, const Contour& contour, Point2 p);

/// Removes a vertex from merged faces if every contour that uses it runs straight through it between the same two
/// neighbours. `object` owns the vertices of `faces`.
void straighten(const std::vector<Point3>& vertices, const Object& object, std::vector<MergedFace>& faces);

}  // namespace ligne
