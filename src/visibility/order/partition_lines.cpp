#include "visibility/order/partition_lines.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "view/clip.hpp"

namespace ligne {
namespace {

using Polygon = std::vector<Point3>;

/// Clips a convex polygon to the front or the back of the plane.
void keep_side(Polygon& polygon, const ModelPlane& plane, bool front) {
  const auto inside = [&](const Point3& p) { return front ? plane.height(p) : -plane.height(p); };
  Polygon kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point3 &a = polygon[i], &b = polygon[i + 1 == polygon.size() ? 0 : i + 1];
    const double at_a = inside(a), at_b = inside(b);
    if (at_a >= 0) kept.push_back(a);
    if ((at_a >= 0) != (at_b >= 0)) kept.push_back(a + (b - a) * (at_a / (at_a - at_b)));
  }
  polygon = std::move(kept);
}

struct Box {
  Point3 low, high;
};

Box box_of(const Scene& scene) {
  Box box{scene.vertices.front(), scene.vertices.front()};
  for (const Point3& p : scene.vertices) {
    box.low = glm::min(box.low, p);
    box.high = glm::max(box.high, p);
  }
  return box;
}

/// The intersection of the plane with the box.
Polygon section(const ModelPlane& plane, const Box& box) {
  const Point3 middle = (box.low + box.high) * 0.5, foot = middle - plane.normal * plane.height(middle);
  const double reach = glm::length(box.high - box.low);
  const Point3 n = glm::abs(plane.normal);
  const Point3 axis = n.x <= n.y && n.x <= n.z ? Point3{1, 0, 0} : n.y <= n.z ? Point3{0, 1, 0} : Point3{0, 0, 1};
  const Point3 u = glm::normalize(glm::cross(plane.normal, axis)) * reach, v = glm::cross(plane.normal, u);
  Polygon polygon{foot - u - v, foot + u - v, foot + u + v, foot - u + v};
  for (const Point3& side : {Point3{1, 0, 0}, Point3{0, 1, 0}, Point3{0, 0, 1}}) {
    keep_side(polygon, {side, box.low}, true);
    keep_side(polygon, {side, box.high}, false);
  }
  return polygon;
}

}  // namespace

PartitionLines partition_lines(const ProjectedScene& scene, std::span<const PartitionNode> nodes) {
  PartitionLines lines;
  std::uint32_t number = 0;
  if (scene.model->vertices.empty()) return lines;
  const Box box = box_of(*scene.model);
  const ClipVolume volume = face_volume(scene.view, scene.lattice);
  for (const PartitionNode& node : nodes) {
    if (!node.divides) continue;
    ++number;
    Polygon polygon = section(node.plane, box);
    const PartitionNode* below = &node;
    while (below->parent != kNone && polygon.size() >= 3) {
      const PartitionNode& above = nodes[below->parent];
      if (above.divides) keep_side(polygon, above.plane, below->in_front);
      below = &above;
    }
    std::vector<HomogeneousPoint> corners;
    for (const Point3& p : polygon) corners.push_back(to_homogeneous(scene.view, p));
    clip_contour(corners, volume);
    if (corners.size() < 3) continue;
    std::vector<Point2>& line = lines.outlines.emplace_back();
    Point2 sum{0, 0};
    for (const HomogeneousPoint& p : corners) sum += line.emplace_back(p.x / p.w, p.y / p.w);
    lines.numbers.push_back({sum / static_cast<double>(line.size()), number});
    line.push_back(line.front());
  }
  return lines;
}

}  // namespace ligne
