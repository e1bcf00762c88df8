#include "visibility/watkins/exact/crossing_queue.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

namespace ligne::watkins {

void CrossingQueue::reset(std::vector<LatticePoint> fences, bool open_end) {
  fences_ = std::move(fences);
  assert(std::is_sorted(fences_.begin(), fences_.end(),
                        [](LatticePoint a, LatticePoint b) { return a.y != b.y ? a.y < b.y : a.x < b.x; }));
  buckets_.assign(fences_.size() + (open_end ? 1 : 0), {});
  heap_.clear();
  bucket_ = 0;
}

void CrossingQueue::put(const Crossing& crossing) {
  const auto from = fences_.begin() + static_cast<std::ptrdiff_t>(std::min(bucket_, fences_.size()));
  const auto fence = std::partition_point(from, fences_.end(), [&](LatticePoint f) { return !crossing.before(f.y, f.x); });
  const auto bucket = static_cast<std::size_t>(fence - fences_.begin());
  if (bucket > bucket_) {
    if (bucket < buckets_.size()) buckets_[bucket].push_back(crossing);
    return;
  }
  heap_.push_back(crossing);
  std::push_heap(heap_.begin(), heap_.end(), Later{});
}

std::optional<Crossing> CrossingQueue::take_before(double y, double x) {
  if (heap_.empty() || !heap_.front().before(y, x)) return std::nullopt;
  const Crossing c = heap_.front();
  std::pop_heap(heap_.begin(), heap_.end(), Later{});
  heap_.pop_back();
  return c;
}

}  // namespace ligne::watkins
