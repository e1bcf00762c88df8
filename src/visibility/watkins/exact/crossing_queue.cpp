#include "visibility/watkins/exact/crossing_queue.hpp"

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

void PairFinder::at_point(std::span<const std::uint32_t> touched, const Cover& cover) {
  for (const std::uint32_t f : touched) {
    if (effort_.spent()) return;
    if (!contains(cover, f)) continue;
    for (const std::uint32_t g : cover) test(f, g);
  }
  search_.forget_repeated();
}

void PairFinder::at_crossing(std::span<const std::uint32_t> left, std::span<const std::uint32_t> right,
                             const Cover& outside) {
  for (const std::uint32_t f : left) {
    if (effort_.spent()) return;
    if (!contains(outside, f)) continue;
    for (const std::uint32_t g : right) {
      if (!contains(outside, g)) test(f, g);
    }
  }
  search_.forget_repeated();
}

void PairFinder::test(std::uint32_t f, std::uint32_t g) {
  const Facet &a = facets_[f], &b = facets_[g];
  if (f == g || a.face == b.face || a.z_near > b.z_far || b.z_near > a.z_far) return;
  effort_.spend(kLooksPerTest);
  const auto wanted = [this](const PageSegment& s) { return !occluders_ || !occluders_->hides(s); };
  search_.test(search_.place(std::min(f, g)), search_.place(std::max(f, g)), wanted);
}

}  // namespace ligne::watkins
