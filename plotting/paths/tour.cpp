/// Improves tours by 2-opt and or-opt over lists of near ends.
///
/// A gap joins the exit of one stroke to the entry of the next. Take an end p with its gap partner p', and a near end c
/// of the same kind (both exits or both entries) with its partner c'. 2-opt reverses the strokes between the gaps: p p'
/// and c c' become p c and p' c'. Or-opt moves one to three strokes that begin or end with p, in either direction, into
/// the gap at c that brings p beside c. Either can gain only if p c is shorter than p p', or than the gap on the other
/// side, so the search stops early in the list of near ends.
///
/// Strokes whose neighbours changed wait in a queue. For each stroke taken from it, all moves are tried, and the first
/// that gains is made. One thread does this in a fixed order, and stops after a fixed amount of work, not of time.

#include "plotting/paths/tour.hpp"

#include <algorithm>
#include <deque>

#include <glm/geometric.hpp>

#include "base/parallel.hpp"
#include "geometry/search/nearest_points.hpp"

namespace ligne {
namespace {

// Adjustable: near ends that are tried, strokes that or-opt moves together, strokes that one move may shift.
constexpr std::size_t kNear = 10;
constexpr std::uint32_t kTogether = 3;
constexpr std::uint32_t kMostShifted = 10'000;

/// Smallest gain of a move, mm: less than a picometre is rounding, and could be gained for ever.
constexpr double kLeastGainMm = 1e-9;

class Improver {
 public:
  Improver(Tour& tour, std::span<const Point2> ends, bool returns, std::uint64_t& work)
      : at_(tour),
        ends_(ends),
        count_(static_cast<std::uint32_t>(tour.size())),
        last_(returns ? count_ - 1 : count_),
        work_(work),
        place_(ends.size() / 2),
        waits_(ends.size() / 2, 0),
        near_(ends.size() * kNear) {
    for (std::uint32_t p = 0; p < count_; ++p) place_[at_[p] / 2] = p;
    find_near();
  }

  void run() {
    for (std::uint32_t p = 1; p < last_; ++p) wait(p);
    while (!queue_.empty() && work_ > 0) {
      const std::uint32_t stroke = queue_.front();
      queue_.pop_front();
      waits_[stroke] = 0;
      while (work_ > 0 && try_stroke(stroke)) {
      }
    }
  }

 private:
  std::uint32_t entry(std::uint32_t place) const { return at_[place]; }
  std::uint32_t exit(std::uint32_t place) const { return at_[place] ^ 1; }
  bool is_entry(std::uint32_t end) const { return at_[place_[end / 2]] == end; }
  double distance(std::uint32_t a, std::uint32_t b) const { return glm::distance(ends_[a], ends_[b]); }
  /// Length of the gap before the stroke at the place; 0 after the last stroke.
  double gap(std::uint32_t place) const { return place < count_ ? distance(exit(place - 1), entry(place)) : 0; }
  /// Distance from an end to the entry at the place; 0 after the last stroke.
  double to_entry(std::uint32_t end, std::uint32_t place) const { return place < count_ ? distance(end, entry(place)) : 0; }

  void find_near() {
    const NearestPoints tree(ends_);
    parallel_blocks(ends_.size(), kSearchBlock, [&](std::size_t first, std::size_t last) {
      std::vector<NearestPoints::Neighbour> found;
      for (std::size_t e = first; e < last; ++e) {
        tree.nearest(ends_[e], kNear + 2, found);
        std::size_t n = 0;
        for (const NearestPoints::Neighbour& f : found) {
          if (f.point / 2 != e / 2 && n < kNear) near_[e * kNear + n++] = f.point;
        }
        for (; n < kNear; ++n) near_[e * kNear + n] = static_cast<std::uint32_t>(e);
      }
    });
  }

  void wait(std::uint32_t place) {
    if (place >= count_ || waits_[at_[place] / 2]) return;
    waits_[at_[place] / 2] = 1;
    queue_.push_back(at_[place] / 2);
  }
  void spend(std::uint64_t amount) { work_ -= std::min(work_, amount); }
  /// Tries the near ends that are nearer than `most`, until attempt(end, distance) returns true.
  template <class Attempt>
  bool any_near(std::uint32_t end, double most, const Attempt& attempt) {
    for (std::size_t k = 0; k < kNear; ++k) {
      const std::uint32_t near = near_[end * kNear + k];
      const double away = distance(end, near);
      if (near == end || away >= most) return false;
      spend(1);
      if (attempt(near, away)) return true;
    }
    return false;
  }

  void reverse(std::uint32_t first, std::uint32_t last) {
    std::reverse(at_.begin() + first, at_.begin() + last + 1);
    for (std::uint32_t p = first; p <= last; ++p) {
      at_[p] ^= 1;
      place_[at_[p] / 2] = p;
    }
    spend(last - first + 1);
  }

  bool try_stroke(std::uint32_t stroke) {
    return try_two_opt(2 * stroke) || try_two_opt(2 * stroke + 1) || try_or_opt(2 * stroke) || try_or_opt(2 * stroke + 1);
  }

  bool try_two_opt(std::uint32_t end) {
    const std::uint32_t here = place_[end / 2];
    const bool entered = is_entry(end);
    const std::uint32_t gap_here = entered ? here : here + 1;  // the gap before this place
    if (gap_here == 0) return false;                           // nothing is before the home position
    const double own = gap(gap_here);
    return any_near(end, own, [&](std::uint32_t near, double) {
      if (is_entry(near) != entered) return false;
      const std::uint32_t gap_near = entered ? place_[near / 2] : place_[near / 2] + 1;
      const std::uint32_t low = std::min(gap_here, gap_near), high = std::max(gap_here, gap_near);
      // The move reverses the places [low, high - 1], which lie between the two gaps.
      if (low == 0 || high > last_ || high == low || high - low > kMostShifted) return false;
      const double before = gap(low) + gap(high);
      const double after = distance(exit(low - 1), exit(high - 1)) + to_entry(entry(low), high);
      if (before - after <= kLeastGainMm) return false;
      reverse(low, high - 1);
      for (const std::uint32_t place : {low - 1, low, high - 1, high}) wait(place);
      return true;
    });
  }

  bool try_or_opt(std::uint32_t end) {
    const std::uint32_t here = place_[end / 2];
    if (here == 0 || here >= last_) return false;
    const bool entered = is_entry(end);
    for (std::uint32_t n = 1; n <= kTogether; ++n) {
      // Strokes that begin with this one are moved if the pen enters at this end, else strokes that end with it.
      if (entered ? here + n > last_ : here < n) break;
      if (entered ? try_insert(end, here, here + n - 1) : try_insert(end, here - n + 1, here)) return true;
    }
    return false;
  }

  bool try_insert(std::uint32_t end, std::uint32_t first, std::uint32_t last) {
    const bool at_first = entry(first) == end;
    const std::uint32_t other = at_first ? exit(last) : entry(first);
    const double removed = gap(first) + gap(last + 1) - to_entry(exit(first - 1), last + 1);
    return any_near(end, removed, [&](std::uint32_t near, double joined) {
      const std::uint32_t place = place_[near / 2];
      if (place >= first && place <= last) return false;
      const bool before_near = is_entry(near);
      const std::uint32_t target = before_near ? place : place + 1;  // the gap before this place
      if (target == 0 || target > last_ || target == first || target == last + 1) return false;
      const std::uint32_t shifted = target > last ? target - first : last + 1 - target;
      if (shifted > kMostShifted) return false;
      const double added = before_near ? joined + distance(exit(target - 1), other) - gap(target)
                                       : joined + to_entry(other, target) - gap(target);
      if (removed - added <= kLeastGainMm) return false;
      // Beside an exit the pen enters at `end`; beside an entry it leaves there.
      move(first, last, target, before_near ? at_first : !at_first);
      return true;
    });
  }

  void move(std::uint32_t first, std::uint32_t last, std::uint32_t target, bool turned) {
    if (turned) reverse(first, last);
    const std::uint32_t length = last - first + 1;
    std::uint32_t low = first, high = target, now = target - length;
    if (target > last) {
      std::rotate(at_.begin() + first, at_.begin() + last + 1, at_.begin() + target);
    } else {
      std::rotate(at_.begin() + target, at_.begin() + first, at_.begin() + last + 1);
      low = now = target;
      high = last + 1;
    }
    for (std::uint32_t p = low; p < high; ++p) place_[at_[p] / 2] = p;
    spend(high - low);
    for (const std::uint32_t place : {low - 1, low, high - 1, high, now - 1, now, now + length - 1, now + length})
      wait(place);
  }

  Tour& at_;
  std::span<const Point2> ends_;
  std::uint32_t count_, last_;  ///< places [1, last_) may change
  std::uint64_t& work_;
  std::vector<std::uint32_t> place_;
  std::vector<char> waits_;
  std::deque<std::uint32_t> queue_;
  std::vector<std::uint32_t> near_;  ///< per end: its kNear nearest ends in order, filled up with the end itself
};
}  // namespace

void improve(Tour& tour, std::span<const Point2> ends, bool returns, std::uint64_t& work) {
  if (tour.size() < 3) return;
  Improver(tour, ends, returns, work).run();
}

}  // namespace ligne
