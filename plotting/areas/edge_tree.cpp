#include "areas/edge_tree.hpp"

#include <algorithm>

namespace ligne::svg {

void StepBox::extend(StepPoint p) {
  const auto x = static_cast<double>(p.x), y = static_cast<double>(p.y);
  extend(StepBox{x, y, x, y});
}

void StepBox::extend(const StepBox& other) {
  low_x = std::min(low_x, other.low_x);
  low_y = std::min(low_y, other.low_y);
  high_x = std::max(high_x, other.high_x);
  high_y = std::max(high_y, other.high_y);
}

StepBox box_of(const StepSegment& s) {
  StepBox box;
  box.extend(s.a);
  box.extend(s.b);
  return box;
}

EdgeTree::EdgeTree(std::span<const StepSegment> edges) : count_(edges.size()) {
  if (edges.empty()) return;
  levels_.emplace_back((edges.size() + kLeaf - 1) / kLeaf);
  for (std::size_t i = 0; i < edges.size(); ++i) levels_[0][i / kLeaf].extend(box_of(edges[i]));
  while (levels_.back().size() > 1) {
    const std::vector<StepBox>& below = levels_.back();
    std::vector<StepBox> above((below.size() + kChildren - 1) / kChildren);
    for (std::size_t i = 0; i < below.size(); ++i) above[i / kChildren].extend(below[i]);
    levels_.push_back(std::move(above));
  }
  box_ = levels_.back()[0];
}

}  // namespace ligne::svg
