#pragma once
/// Nodes: the points where strokes end.

#include <cstdint>
#include <span>
#include <vector>

#include "base/no_index.hpp"
#include "base/parallel.hpp"
#include "linework/stroke.hpp"

namespace ligne {

/// End 2 i is the `from` of stroke members[i], end 2 i + 1 its `to`.
struct StrokeEnd {
  LatticePoint p;
  std::uint32_t end;
};

/// Calls visit(ends) for each point where strokes of `members` end, with all ends there in ascending order. Calls come
/// from several threads, in no particular order. Distributes the ends over buckets by a hash of their points, and sorts each
/// bucket. O(n log d) for points where d ends meet.
void for_each_node(const std::vector<Stroke>& strokes, std::span<const std::uint32_t> members,
                   FunctionRef<void(std::span<const StrokeEnd>)> visit);

/// The node of each end, and the ends of each node. A node has the number of one of its ends, at first of the lowest.
/// Invariant: an end is in the list of its node, which is ascending, unless it was unlinked; the degree of a node is the
/// length of its list.
class Nodes {
 public:
  Nodes() = default;
  /// O(n).
  Nodes(const std::vector<Stroke>& strokes, std::span<const std::uint32_t> members);
  /// The nodes of all strokes.
  explicit Nodes(const std::vector<Stroke>& strokes);

  std::uint32_t end_count() const { return static_cast<std::uint32_t>(of_.size()); }
  std::uint32_t of(std::uint32_t end) const { return of_[end]; }
  std::uint32_t degree(std::uint32_t node) const { return degree_[node]; }
  /// The lowest end at a node.
  std::uint32_t first(std::uint32_t node) const { return first_[node]; }
  /// Calls visit(end) for all ends at a node, in ascending order.
  template <class Visit>
  void for_each_end(std::uint32_t node, const Visit& visit) const {
    for (std::uint32_t e = first_[node]; e != kNone; e = next_[e]) visit(e);
  }
  /// The other end at the node if exactly two strokes end there; otherwise kNone.
  std::uint32_t other(std::uint32_t end) const {
    const std::uint32_t node = of_[end];
    if (degree_[node] != 2) return kNone;
    return first_[node] == end ? next_[end] : first_[node];
  }

  /// Adds an end with a node of its own.
  void add();
  void link(std::uint32_t end, std::uint32_t node);
  void unlink(std::uint32_t end);

 private:
  std::vector<std::uint32_t> of_, next_;       ///< by end
  std::vector<std::uint32_t> first_, degree_;  ///< by node
};

}  // namespace ligne
