#pragma once
/// A tree of boxes over points, to find whether a point lies below a plane.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "base/no_index.hpp"
#include "visibility/order/model_pieces.hpp"

namespace ligne {

class PointBoxes {
 public:
  explicit PointBoxes(std::vector<Point3> points) : points_(std::move(points)) { build(); }

  /// Whether the height of some point over the plane is below -tolerance. Boxes wholly above are skipped.
  bool any_below(const ModelPlane& plane, double tolerance) const {
    if (points_.empty()) return false;
    std::vector<std::uint32_t> open{0};
    while (!open.empty()) {
      const Box& box = boxes_[open.back()];
      open.pop_back();
      const Point3 lowest{plane.normal.x > 0 ? box.low.x : box.high.x, plane.normal.y > 0 ? box.low.y : box.high.y,
                          plane.normal.z > 0 ? box.low.z : box.high.z};
      if (plane.height(lowest) >= -tolerance) continue;
      if (box.child == kNone) {
        for (std::uint32_t i = box.begin; i < box.end; ++i) {
          if (plane.height(points_[i]) < -tolerance) return true;
        }
      } else {
        open.push_back(box.child);
        open.push_back(box.child + 1);
      }
    }
    return false;
  }

 private:
  static constexpr std::uint32_t kInLeaf = 48;
  struct Box {
    Point3 low, high;
    std::uint32_t begin, end, child = kNone;  ///< the first of two consecutive children, or kNone
  };

  void build() {
    boxes_.push_back(box_of(0, static_cast<std::uint32_t>(points_.size())));
    for (std::size_t b = 0; b < boxes_.size(); ++b) {
      const auto [begin, end] = std::pair(boxes_[b].begin, boxes_[b].end);
      if (end - begin <= kInLeaf) continue;
      const Point3 size = boxes_[b].high - boxes_[b].low;
      const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
      const std::uint32_t middle = begin + (end - begin) / 2;
      std::nth_element(points_.begin() + begin, points_.begin() + middle, points_.begin() + end,
                       [axis](const Point3& p, const Point3& q) { return p[axis] < q[axis]; });
      boxes_[b].child = static_cast<std::uint32_t>(boxes_.size());
      boxes_.push_back(box_of(begin, middle));
      boxes_.push_back(box_of(middle, end));
    }
  }

  Box box_of(std::uint32_t begin, std::uint32_t end) const {
    Box box{Point3(1e300), Point3(-1e300), begin, end};
    for (std::uint32_t i = begin; i < end; ++i) {
      box.low = glm::min(box.low, points_[i]);
      box.high = glm::max(box.high, points_[i]);
    }
    return box;
  }

  std::vector<Point3> points_;
  std::vector<Box> boxes_;
};

}  // namespace ligne
