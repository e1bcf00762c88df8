#pragma once
/// A tree of boxes over consecutive edges, to find the edges that a line may meet. Private to plotting.

#include <cstddef>
#include <span>
#include <vector>

#include "areas/steps.hpp"

namespace ligne::svg {

/// A box in steps, as doubles: they are exact below 2^53.
struct StepBox {
  double low_x = 1e300, low_y = 1e300, high_x = -1e300, high_y = -1e300;

  void extend(StepPoint p);
  void extend(const StepBox& other);
  bool empty() const { return low_x > high_x; }
  bool meets(const StepBox& o) const {
    return low_x <= o.high_x && high_x >= o.low_x && low_y <= o.high_y && high_y >= o.low_y;
  }
  /// The box, grown by this many steps on each side.
  StepBox grown(double steps) const { return {low_x - steps, low_y - steps, high_x + steps, high_y + steps}; }
};

StepBox box_of(const StepSegment& s);

/// Largest distance, in lattice steps, by which a vertex that lies on a segment up to rounding may lie outside its box.
inline constexpr double kRoundingSteps = 2;

/// A balanced tree of bounding boxes over edges in the order of their contours: consecutive edges lie near each other.
class EdgeTree {
 public:
  EdgeTree() = default;
  explicit EdgeTree(std::span<const StepSegment> edges);

  const StepBox& box() const { return box_; }

  /// Calls visit(i) for all edges in order, except edges in boxes for which `may_intersect` is false. Returns the
  /// number of boxes and edges tested.
  template <class MayMeet, class Visit>
  std::size_t search(MayMeet may_intersect, Visit visit) const {
    std::size_t looked_at = 0;
    if (count_ > 0) search_node(levels_.size() - 1, 0, may_intersect, visit, looked_at);
    return looked_at;
  }

 private:
  /// Edges per leaf, and children per node. Adjustable.
  static constexpr std::size_t kLeaf = 4, kChildren = 4;

  template <class MayMeet, class Visit>
  void search_node(std::size_t level, std::size_t node, MayMeet& may_intersect, Visit& visit, std::size_t& looked_at) const {
    ++looked_at;
    if (!may_intersect(levels_[level][node])) return;
    const std::size_t below = level == 0 ? count_ : levels_[level - 1].size(), many = level == 0 ? kLeaf : kChildren;
    const std::size_t end = node * many + many < below ? node * many + many : below;
    for (std::size_t i = node * many; i < end; ++i) {
      if (level > 0) {
        search_node(level - 1, i, may_intersect, visit, looked_at);
      } else {
        ++looked_at;
        visit(i);
      }
    }
  }

  std::size_t count_ = 0;
  StepBox box_;
  std::vector<std::vector<StepBox>> levels_;  ///< from the leaves to the root
};

}  // namespace ligne::svg
