#include "visibility/watkins/exact/crossing_queue.hpp"

namespace ligne::watkins {

std::optional<Crossing> CrossingQueue::take_before(double y, double x) {
  if (heap_.empty() || !heap_.top().before(y, x)) return std::nullopt;
  const Crossing c = heap_.top();
  heap_.pop();
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
