#include "geometry/polygons/sweep_order.hpp"

namespace ligne {

SweepOrder::Node SweepOrder::new_node() {
  // Marsaglia's xorshift generator.
  random_ ^= random_ << 13;
  random_ ^= random_ >> 17;
  random_ ^= random_ << 5;
  Node n = static_cast<Node>(links_.size());
  if (erased_.empty()) {
    links_.emplace_back();
  } else {
    n = erased_.back();
    erased_.pop_back();
    links_[n] = {};
  }
  links_[n].priority = random_;
  return n;
}

SweepOrder::Node SweepOrder::insert_after(Node before) {
  const Node n = new_node();
  const Node after = before == kNone ? first_ : links_[before].next;
  links_[n].previous = before;
  links_[n].next = after;
  if (after != kNone) links_[after].previous = n;
  (before == kNone ? first_ : links_[before].next) = n;
  // One of two neighbours has no child on the side facing the other.
  if (before != kNone && links_[before].right == kNone) {
    links_[before].right = n;
    links_[n].parent = before;
  } else if (after != kNone) {
    links_[after].left = n;
    links_[n].parent = after;
  } else {
    root_ = n;
  }
  while (links_[n].parent != kNone && links_[links_[n].parent].priority < links_[n].priority) rotate_up(n);
  return n;
}

void SweepOrder::erase(Node n) {
  while (links_[n].left != kNone && links_[n].right != kNone) {
    const Node left = links_[n].left, right = links_[n].right;
    rotate_up(links_[left].priority > links_[right].priority ? left : right);
  }
  replace(n, links_[n].left != kNone ? links_[n].left : links_[n].right);
  const Node before = links_[n].previous, after = links_[n].next;
  (before == kNone ? first_ : links_[before].next) = after;
  if (after != kNone) links_[after].previous = before;
  erased_.push_back(n);
}

void SweepOrder::replace(Node n, Node child) {
  const Node parent = links_[n].parent;
  if (parent == kNone) {
    root_ = child;
  } else {
    (links_[parent].left == n ? links_[parent].left : links_[parent].right) = child;
  }
  if (child != kNone) links_[child].parent = parent;
}

void SweepOrder::rotate_up(Node n) {
  const Node parent = links_[n].parent;
  const bool is_left = links_[parent].left == n;
  const Node inner = is_left ? links_[n].right : links_[n].left;
  replace(parent, n);
  (is_left ? links_[parent].left : links_[parent].right) = inner;
  if (inner != kNone) links_[inner].parent = parent;
  (is_left ? links_[n].right : links_[n].left) = parent;
  links_[parent].parent = n;
}

}  // namespace ligne
