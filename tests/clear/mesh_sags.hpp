#pragma once
/// How far the smooth surface that a mesh stands for may lie from the mesh, on the page.

#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/point.hpp"
#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"
#include "view/view.hpp"

namespace ligne::test {

/// The sag of each face: the sum over its smooth edges of w/2 tan(t/4), where t is the angle to the neighbour there and w
/// the width of the face across the edge, or the neighbour's where that is less than a fourth of it. An arc over a chord of
/// length w that turns by t rises so high over it; half of the square of a surface that bends both ways has the sum of two,
/// and the middle of a triangle less than the sum of three.
class MeshSags {
 public:
  /// The view is a parallel one. Edges that bend by more than `most_degrees` are not smooth.
  MeshSags(const Scene& scene, const Topology& topology, const View& view, double most_degrees);

  /// The largest sag of the faces that come as near to a point of the page as their sag and `within_mm`, mm of the page;
  /// nothing if there are none: the point lies outside the body.
  std::optional<double> at(Point2 p, double within_mm) const;

 private:
  struct PageTriangle {
    Point2 a, b, c;
    double sag = 0;
  };
  std::vector<PageTriangle> triangles_;
  Rect bounds_{};
  double largest_sag_ = 0;
  int columns_ = 1, rows_ = 1;
  std::vector<std::uint32_t> cell_begin_, cell_items_;
};

}  // namespace ligne::test
