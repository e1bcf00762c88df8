#pragma once
/// The edges that a sweep line crosses, in order.

#include <cstdint>
#include <vector>

#include "base/no_index.hpp"

namespace ligne {

/// A sequence of nodes with search by place: a treap whose nodes also know their neighbours. It compares nothing
/// itself; the caller says where to insert. Priorities follow from the order of insertion, so that a sweep is
/// reproducible. Expected time of a search, an insertion or an erasure: log n.
class SweepOrder {
 public:
  using Node = std::uint32_t;

  Node first() const { return first_; }
  Node next(Node n) const { return links_[n].next; }
  Node previous(Node n) const { return links_[n].previous; }

  /// A new node behind `before`, or at the beginning for kNone. Numbers of erased nodes are used again.
  Node insert_after(Node before);
  void erase(Node n);

  /// The first node for which `reached` is true. It must be true for all nodes behind that one and false for all before
  /// it.
  template <class Reached>
  Node find_first(Reached reached) const {
    Node found = kNone;
    for (Node n = root_; n != kNone;) {
      if (reached(n)) {
        found = n;
        n = links_[n].left;
      } else {
        n = links_[n].right;
      }
    }
    return found;
  }

 private:
  struct Links {
    Node left = kNone, right = kNone, parent = kNone;
    Node previous = kNone, next = kNone;
    std::uint32_t priority = 0;
  };

  Node new_node();
  /// Puts `child` in the place of `n`.
  void replace(Node n, Node child);
  /// Lifts n above its parent.
  void rotate_up(Node n);

  std::vector<Links> links_;
  std::vector<Node> erased_;
  Node root_ = kNone, first_ = kNone;
  std::uint32_t random_ = 2463534242u;  ///< any number but 0
};

}  // namespace ligne
