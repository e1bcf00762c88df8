#pragma once
/// Nodes: the points where strokes end.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/parallel.hpp"
#include "linework/node_pairs.hpp"
#include "linework/stroke.hpp"

namespace ligne {

/// End 2 i is the `from` of stroke members[i], end 2 i + 1 its `to`.
struct StrokeEnd {
  LatticePoint p;
  std::uint32_t end;
};

/// Calls visit(ends) for each point where strokes of `members` end, with all ends there in ascending order. Calls come
/// from several threads, in no particular order. O(n).
///
/// Distributes the ends over buckets by their position, so that a bucket fits into the cache. In each bucket a small
/// hash table numbers the positions, and a counting sort groups the ends of each position.
void for_each_node(const std::vector<Stroke>& strokes, std::span<const std::uint32_t> members,
                   FunctionRef<void(std::span<const StrokeEnd>)> visit);

/// Arms of one node. A few arms, the common case, need no memory allocation.
class NodeArms {
 public:
  NodeArms() = default;
  /// The arms of the ends at one node, in their order.
  NodeArms(const std::vector<Stroke>& strokes, std::span<const std::uint32_t> members, std::span<const StrokeEnd> ends) {
    for (const auto& [p, end] : ends) {
      const Stroke& s = strokes[members[end / 2]];
      const LatticePoint far = end % 2 == 0 ? s.to : s.from;
      add({{far.x - p.x, far.y - p.y}, end});
    }
  }

  void add(const NodeArm& arm) {
    if (count_ == few_.size()) many_.assign(few_.begin(), few_.end());
    if (count_ < few_.size())
      few_[count_] = arm;
    else
      many_.push_back(arm);
    ++count_;
  }
  void clear() { count_ = 0; }
  std::span<const NodeArm> all() const { return {count_ <= few_.size() ? few_.data() : many_.data(), count_}; }

 private:
  std::array<NodeArm, kFewArms> few_;
  std::vector<NodeArm> many_;
  std::size_t count_ = 0;
};

}  // namespace ligne
