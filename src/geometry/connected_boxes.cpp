#include "geometry/connected_boxes.hpp"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "base/no_index.hpp"

namespace ligne {
namespace {

/// Open boxes as intervals [first, end) of elementary intervals of y. Closed boxes stay in the tree and are skipped.
class OpenBoxes {
 public:
  OpenBoxes(std::span<const AxisBox> boxes, std::size_t intervals, DisjointSets& sets) : boxes_(boxes), sets_(sets) {
    while (leaves_ < intervals) leaves_ *= 2;
    nodes_.resize(2 * leaves_);
  }

  void insert(std::uint32_t box, std::size_t first, std::size_t end) { insert(box, first, end, 1, 0, leaves_); }

 private:
  /// Invariant: if `joined`, all open boxes stored at this node and below it are in one set.
  struct Node {
    std::uint32_t own = kNone;   ///< the box stored here that ends last; while it is open, all open boxes stored here
                                 ///< are in its set
    std::uint32_t last = kNone;  ///< the box stored here or below that ends last
    bool joined = true;
  };

  bool later(std::uint32_t a, std::uint32_t b) const { return b == kNone || boxes_[a].x1 > boxes_[b].x1; }
  bool is_open(std::uint32_t other, std::uint32_t box) const { return other != kNone && boxes_[other].x1 > boxes_[box].x0; }
  void join(std::uint32_t other, std::uint32_t box) {
    if (is_open(other, box)) sets_.join(other, box);
  }

  void insert(std::uint32_t box, std::size_t first, std::size_t end, std::size_t n, std::size_t from, std::size_t to) {
    Node& node = nodes_[n];
    join(node.own, box);
    if (first <= from && to <= end) {
      join_below(box, n);
      if (later(box, node.own)) node.own = box;
    } else {
      const std::size_t middle = from + (to - from) / 2;
      if (first < middle) insert(box, first, end, 2 * n, from, middle);
      if (end > middle) insert(box, first, end, 2 * n + 1, middle, to);
      node.joined = false;
    }
    if (later(box, node.last)) node.last = box;
  }

  void join_below(std::uint32_t box, std::size_t n) {
    Node& node = nodes_[n];
    if (!is_open(node.last, box)) {
      node.joined = true;
      return;
    }
    if (node.joined) return sets_.join(node.last, box);
    join(node.own, box);
    if (n < leaves_) {
      join_below(box, 2 * n);
      join_below(box, 2 * n + 1);
    }
    node.joined = true;
  }

  std::span<const AxisBox> boxes_;
  DisjointSets& sets_;
  std::size_t leaves_ = 1;
  std::vector<Node> nodes_;
};

}  // namespace

DisjointSets connect_boxes(std::span<const AxisBox> boxes) {
  DisjointSets sets(boxes.size());
  std::vector<double> ys;
  std::vector<std::uint32_t> by_left;
  for (std::uint32_t i = 0; i < boxes.size(); ++i) {
    if (!(boxes[i].x0 < boxes[i].x1 && boxes[i].y0 < boxes[i].y1)) continue;
    by_left.push_back(i);
    ys.insert(ys.end(), {boxes[i].y0, boxes[i].y1});
  }
  std::sort(ys.begin(), ys.end());
  ys.erase(std::unique(ys.begin(), ys.end()), ys.end());
  std::sort(by_left.begin(), by_left.end(),
            [&](std::uint32_t a, std::uint32_t b) { return std::pair(boxes[a].x0, a) < std::pair(boxes[b].x0, b); });
  const auto interval = [&](double y) {
    return static_cast<std::size_t>(std::lower_bound(ys.begin(), ys.end(), y) - ys.begin());
  };
  OpenBoxes open(boxes, ys.size(), sets);
  for (const std::uint32_t i : by_left) open.insert(i, interval(boxes[i].y0), interval(boxes[i].y1));
  return sets;
}

}  // namespace ligne
