#pragma once
/// Binary trees of boxes on the page, each with its nearest depth, for searches along a line.

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "visibility/common/open_parts.hpp"

namespace ligne {

/// A rectangle in lattice steps, and the bounds of the depths of everything in it.
struct DepthBox {
  std::int32_t left = std::numeric_limits<std::int32_t>::max(), right = std::numeric_limits<std::int32_t>::min();
  std::int32_t top = left, bottom = right;
  float z_near = std::numeric_limits<float>::infinity(), z_far = -z_near;

  void extend(LatticePoint p) {
    left = std::min(left, p.x);
    right = std::max(right, p.x);
    top = std::min(top, p.y);
    bottom = std::max(bottom, p.y);
  }
  void extend(const DepthBox& o) {
    left = std::min(left, o.left);
    right = std::max(right, o.right);
    top = std::min(top, o.top);
    bottom = std::max(bottom, o.bottom);
    z_near = std::min(z_near, o.z_near);
    z_far = std::max(z_far, o.z_far);
  }

  /// Length of the part of [from, to] in which the line is over the box, or 0 if there is none or all of it lies in
  /// front of the box. The box is widened by one step on all sides, which exceeds the rounding here.
  double overlap(const PageLine& line, double from, double to) const {
    return clip(line.p0.x, line.dx, left, right, from, to) && clip(line.p0.y, line.dy, top, bottom, from, to) &&
                   std::max(line.z(from), line.z(to)) > z_near
               ? to - from
               : 0;
  }

  /// Whether the line may meet the box on the page and in depth.
  bool meets(const PageLine& line) const {
    double from = 0, to = 1;
    if (!clip(line.p0.x, line.dx, left, right, from, to) || !clip(line.p0.y, line.dy, top, bottom, from, to)) return false;
    const double z0 = line.z(from), z1 = line.z(to);
    return std::max(z0, z1) >= z_near && std::min(z0, z1) <= z_far;
  }

 private:
  static bool clip(double start, double change, double low, double high, double& from, double& to) {
    const double to_low = low - 1 - start, to_high = high + 1 - start;
    if (change == 0) return to_low <= 0 && to_high >= 0;
    const double a = to_low / change, b = to_high / change;
    from = std::max(from, std::min(a, b));
    to = std::min(to, std::max(a, b));
    return from < to;
  }
};

class BoxForest {
 public:
  /// Builds a tree of items, numbered from 0, and returns its root. It halves the items along a Morton curve through
  /// the centres of the boxes [Morton1966]. O(n log n).
  std::uint32_t add_tree(std::span<const DepthBox> boxes);

  /// Calls visit(item) for every item of the tree whose box may lie in front of open parts of the line. The parts that
  /// visit() takes are no longer searched. The half of the tree that overlaps more of the line comes first, as it is
  /// likely to hide more.
  template <class Visit>
  void for_each_before(std::uint32_t root, const PageLine& line, const OpenParts& open, Visit visit) const {
    std::array<std::uint32_t, kMostDepth> stack;
    std::size_t size = 0;
    stack[size++] = root;
    const auto overlap = [&](const DepthBox& box) { return box.overlap(line, open.from(), open.to()); };
    while (size > 0 && !open.empty()) {
      const Node& node = nodes_[stack[--size]];
      if (!(overlap(node.box) > 0)) continue;
      if (node.children == 0) {
        visit(node.item);
        continue;
      }
      const double first = overlap(nodes_[node.children].box), second = overlap(nodes_[node.children + 1].box);
      const std::uint32_t likelier = node.children + (second > first);
      if (std::min(first, second) > 0) stack[size++] = likelier == node.children ? node.children + 1 : node.children;
      if (std::max(first, second) > 0) stack[size++] = likelier;
    }
  }

  /// Calls visit(item) for every item of the tree whose box the line meets.
  template <class Visit>
  void for_each_met(std::uint32_t root, const PageLine& line, Visit visit) const {
    std::array<std::uint32_t, kMostDepth> stack;
    std::size_t size = 0;
    stack[size++] = root;
    while (size > 0) {
      const Node& node = nodes_[stack[--size]];
      if (!node.box.meets(line)) continue;
      if (node.children == 0) {
        visit(node.item);
      } else {
        stack[size++] = node.children;
        stack[size++] = node.children + 1;
      }
    }
  }

 private:
  /// Trees are balanced and have fewer than 2^32 items; each level leaves one node on the stack.
  static constexpr std::size_t kMostDepth = 40;

  struct Node {
    DepthBox box;
    std::uint32_t children = 0;  ///< number of the first child; the second follows it. 0: a leaf
    std::uint32_t item = 0;      ///< of a leaf
  };

  void fill(std::uint32_t node, std::span<const DepthBox> boxes, std::span<const std::uint32_t> items);

  std::vector<Node> nodes_;
};

}  // namespace ligne
