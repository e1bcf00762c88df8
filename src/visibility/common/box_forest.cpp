#include "visibility/common/box_forest.hpp"

#include <utility>

#include "geometry/morton.hpp"

namespace ligne {

std::uint32_t BoxForest::add_tree(std::span<const DepthBox> boxes) {
  std::vector<std::pair<std::uint64_t, std::uint32_t>> keys;
  keys.reserve(boxes.size());
  for (std::uint32_t i = 0; i < boxes.size(); ++i) {
    const DepthBox& b = boxes[i];
    keys.emplace_back(morton_key({b.left + (b.right - b.left) / 2, b.top + (b.bottom - b.top) / 2}), i);
  }
  std::sort(keys.begin(), keys.end());
  std::vector<std::uint32_t> items;
  items.reserve(keys.size());
  for (const auto& [key, item] : keys) items.push_back(item);
  const auto root = static_cast<std::uint32_t>(nodes_.size());
  nodes_.emplace_back();  // without boxes the root stays empty, and no line meets it
  if (!items.empty()) fill(root, boxes, items);
  return root;
}

void BoxForest::fill(std::uint32_t node, std::span<const DepthBox> boxes, std::span<const std::uint32_t> items) {
  if (items.size() == 1) {
    nodes_[node].box = boxes[items[0]];
    nodes_[node].item = items[0];
    return;
  }
  const auto children = static_cast<std::uint32_t>(nodes_.size());
  nodes_.resize(nodes_.size() + 2);
  const std::size_t half = items.size() / 2;
  fill(children, boxes, items.first(half));
  fill(children + 1, boxes, items.subspan(half));
  nodes_[node].children = children;
  nodes_[node].box = nodes_[children].box;
  nodes_[node].box.extend(nodes_[children + 1].box);
}

}  // namespace ligne
