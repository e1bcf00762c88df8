#include "studies/operations/segment_sweep.hpp"

#include <algorithm>
#include <compare>
#include <map>
#include <numeric>
#include <set>

namespace ligne::studies {
namespace {

int sign(Int128 v) { return (v > 0) - (v < 0); }

MeetingPoint point_of(LatticePoint p) { return {p.x, p.y, 1}; }

bool left_of(LatticePoint p, LatticePoint q) { return p.x < q.x || (p.x == q.x && p.y < q.y); }

/// The segment directed from left to right; a vertical one upwards.
LatticeSegment directed(LatticeSegment s) { return left_of(s.b, s.a) ? LatticeSegment{s.b, s.a} : s; }

/// Side of the segment's line on which the point lies: +1 above it.
int side_of(const LatticeSegment& s, const MeetingPoint& p) {
  const Int128 dx = s.b.x - s.a.x, dy = s.b.y - s.a.y;
  return sign(dx * (Int128(p.y) - Int128(s.a.y) * p.w) - dy * (Int128(p.x) - Int128(s.a.x) * p.w));
}

/// Sign of the turn from the direction of s to that of t: +1 if t is steeper.
int turn_of(const LatticeSegment& s, const LatticeSegment& t) {
  return sign(Int128(s.b.x - s.a.x) * (t.b.y - t.a.y) - Int128(s.b.y - s.a.y) * (t.b.x - t.a.x));
}

bool in_box(const LatticeSegment& s, const MeetingPoint& p) {
  const auto between = [&](std::int64_t v, std::int32_t a, std::int32_t b) {
    return std::int64_t{std::min(a, b)} * p.w <= v && v <= std::int64_t{std::max(a, b)} * p.w;
  };
  return between(p.x, s.a.x, s.b.x) && between(p.y, s.a.y, s.b.y);
}

/// Calls visit(point) for the common points of two segments: one point, or the ends of an overlap.
template <class Visit>
void for_common(const LatticeSegment& s, const LatticeSegment& t, const Visit& visit) {
  const std::int64_t ux = s.b.x - s.a.x, uy = s.b.y - s.a.y, vx = t.b.x - t.a.x, vy = t.b.y - t.a.y;
  const std::int64_t det = ux * vy - uy * vx, ex = t.a.x - s.a.x, ey = t.a.y - s.a.y;
  if (det == 0) {
    if (ex * uy != ey * ux) return;
    for (const LatticePoint p : {t.a, t.b}) {
      if (in_box(s, point_of(p))) visit(point_of(p));
    }
    for (const LatticePoint p : {s.a, s.b}) {
      if (in_box(t, point_of(p))) visit(point_of(p));
    }
    return;
  }
  // s.a + u (num / det) with 0 <= num / det <= 1, and likewise on t.
  std::int64_t num = ex * vy - ey * vx, other = ex * uy - ey * ux, w = det;
  if (w < 0) {
    w = -w;
    num = -num;
    other = -other;
  }
  if (num < 0 || num > w || other < 0 || other > w) return;
  const Int128 x = Int128(s.a.x) * w + Int128(ux) * num, y = Int128(s.a.y) * w + Int128(uy) * num;
  const auto x64 = static_cast<std::int64_t>(x), y64 = static_cast<std::int64_t>(y);
  const std::int64_t d = std::gcd(std::gcd(x64, y64), w);
  visit(MeetingPoint{x64 / d, y64 / d, w / d});
}

class Sweep {
 public:
  Sweep(const std::vector<LatticeSegment>& segments, SweepWork& work) : work_(work), tree_(Order{this}) {
    for (const LatticeSegment& s : segments) segments_.push_back(directed(s));
    for (std::uint32_t i = 0; i < segments_.size(); ++i) {
      queue_[point_of(segments_[i].a)].push_back(i);
      queue_.try_emplace(point_of(segments_[i].b));
    }
  }

  std::vector<MeetingPoint> run() {
    while (!queue_.empty()) {
      const auto node = queue_.extract(queue_.begin());
      at_ = node.key();
      ++work_.events;
      stop(node.mapped());
    }
    return std::move(found_);
  }

 private:
  /// Order of the segments along the sweep line just behind the current stop. Directions order those through the stop.
  struct Order {
    using is_transparent = void;
    Sweep* sweep;
    bool operator()(std::uint32_t a, std::uint32_t b) const { return sweep->below(a, b); }
    template <class Probe>
    bool operator()(std::uint32_t i, const Probe& probe) const {
      return probe.holds(i);
    }
  };
  using Tree = std::set<std::uint32_t, Order>;

  bool below(std::uint32_t a, std::uint32_t b) const {
    if (a == b) return false;
    ++work_.comparisons;
    const LatticeSegment &s = segments_[a], &t = segments_[b];
    // One of the two passes through the stop: the tree compares other segments only with inserted or sought ones.
    const int of_s = side_of(s, at_), of_t = side_of(t, at_);
    if (of_s != of_t) return of_s > of_t;  // the stop is above s: s is below it
    if (of_s == 0) {
      const int turn = turn_of(s, t);
      return turn != 0 ? turn > 0 : a < b;
    }
    return a < b;
  }

  void test(std::uint32_t a, std::uint32_t b) {
    ++work_.pairs;
    for_common(segments_[a], segments_[b], [&](const MeetingPoint& p) {
      if (p > at_) queue_.try_emplace(p);
    });
  }

  void stop(const std::vector<std::uint32_t>& beginning) {
    // The segments through the stop are adjacent in the tree; the first is the first one not wholly below the stop.
    const auto first = lower_bound_at_stop();
    auto last = first;
    while (last != tree_.end() && (++work_.comparisons, side_of(segments_[*last], at_) == 0)) ++last;
    std::vector<std::uint32_t> through(first, last);
    if (through.size() + beginning.size() > 1) found_.push_back(at_);
    tree_.erase(first, last);
    // Segments that continue and segments that begin are inserted in the order behind the stop.
    std::vector<std::uint32_t> going = beginning;
    for (const std::uint32_t i : through) {
      if (point_of(segments_[i].b) != at_) going.push_back(i);
    }
    for (const std::uint32_t i : going) tree_.insert(i);
    const auto above = upper_bound_at_stop();
    const bool has_above = above != tree_.end();
    if (going.empty()) {
      if (has_above && above != tree_.begin()) test(*std::prev(above), *above);
      return;
    }
    const auto lowest = lower_bound_at_stop();
    if (lowest != tree_.begin()) test(*std::prev(lowest), *lowest);
    if (has_above) test(*std::prev(above), *above);
    // The ends of overlaps of collinear segments are stops already.
  }

  /// The first segment not below the stop, and the first one above it.
  Tree::iterator lower_bound_at_stop() {
    return partition([&](std::uint32_t i) { return side_of(segments_[i], at_) > 0; });
  }
  Tree::iterator upper_bound_at_stop() {
    return partition([&](std::uint32_t i) { return side_of(segments_[i], at_) >= 0; });
  }
  template <class Before>
  Tree::iterator partition(const Before& before) {
    return tree_.lower_bound(Probe<Before>{before, work_});
  }
  template <class Before>
  struct Probe {
    const Before& before;
    SweepWork& work;
    bool holds(std::uint32_t i) const {
      ++work.comparisons;
      return before(i);
    }
  };

  SweepWork& work_;
  std::vector<LatticeSegment> segments_;
  std::map<MeetingPoint, std::vector<std::uint32_t>> queue_;  ///< stops, with the segments that begin at each
  MeetingPoint at_;
  Tree tree_;
  std::vector<MeetingPoint> found_;
};

}  // namespace

std::strong_ordering operator<=>(const MeetingPoint& a, const MeetingPoint& b) {
  if (const int x = sign(Int128(a.x) * b.w - Int128(b.x) * a.w); x != 0)
    return x < 0 ? std::strong_ordering::less : std::strong_ordering::greater;
  const int y = sign(Int128(a.y) * b.w - Int128(b.y) * a.w);
  return y < 0 ? std::strong_ordering::less : y > 0 ? std::strong_ordering::greater : std::strong_ordering::equal;
}

std::vector<MeetingPoint> meetings_by_sweep(const std::vector<LatticeSegment>& segments, SweepWork& work) {
  return Sweep(segments, work).run();
}

std::vector<MeetingPoint> meetings_by_pairs(const std::vector<LatticeSegment>& segments, SweepWork& work) {
  std::vector<MeetingPoint> found;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    for (std::size_t k = i + 1; k < segments.size(); ++k) {
      ++work.pairs;
      for_common(directed(segments[i]), directed(segments[k]), [&](const MeetingPoint& p) { found.push_back(p); });
    }
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

}  // namespace ligne::studies
