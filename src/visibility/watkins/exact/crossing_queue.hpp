#pragma once
/// The crossings that the exact scan still has to come to, in its order.
///
/// Most crossings lie far below the scan when they are found, and many are no longer to come when it gets there. So they are
/// put into buckets by their place, and only the bucket at hand is a heap: a small one, of crossings that are still good.

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/lattice.hpp"

namespace ligne::watkins {

struct Crossing {
  double y, x;
  std::uint32_t left, right;  ///< nodes of the active list
  std::uint32_t left_generation, right_generation;

  bool before(double other_y, double other_x) const { return y != other_y ? y < other_y : x < other_x; }
};

/// Invariant: every crossing before the first fence not yet passed is in the heap; behind the last fence nothing is kept.
class CrossingQueue {
 public:
  /// Fences ascend in scan order. `open_end`: what lies behind the last one is kept too.
  void reset(std::vector<LatticePoint> fences, bool open_end);
  void put(const Crossing& crossing);
  /// The next one before the place, taken out.
  std::optional<Crossing> take_before(double y, double x);

  /// When all crossings before the next fence have been taken: those that are good(crossing) of the bucket behind it.
  template <class Good>
  void pass_fence(Good good) {
    ++bucket_;
    heap_.swap(buckets_[bucket_]);
    buckets_[bucket_] = {};
    std::erase_if(heap_, [&](const Crossing& c) { return !good(c); });
    std::make_heap(heap_.begin(), heap_.end(), Later{});
  }

 private:
  /// No two are equal but for copies: ties are broken by the nodes.
  struct Later {
    bool operator()(const Crossing& a, const Crossing& b) const {
      if (a.y != b.y) return a.y > b.y;
      if (a.x != b.x) return a.x > b.x;
      if (a.left != b.left) return a.left > b.left;
      return a.right > b.right;
    }
  };

  std::vector<LatticePoint> fences_;
  std::vector<std::vector<Crossing>> buckets_;
  std::vector<Crossing> heap_;
  std::size_t bucket_ = 0;
};

}  // namespace ligne::watkins
