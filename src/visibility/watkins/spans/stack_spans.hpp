#pragma once
/// Span method `stack` ([Boulle1980] 2.3.3.2, Pile, after Hamlin and Gear 1977). It visits the ends of segments from left to
/// right. Invariant: `current_` is the nearest segment over the next run, at least up to `turn_`. All other segments that
/// have begun and not ended are on the stack, unordered, possibly with some that have ended.
///
/// [Boulle1980] pops until it finds a segment that has not ended, which assumes a stack ordered by depth. It is not: a
/// segment that begins behind the current one is pushed on top of nearer ones. So the stack is searched for the nearest, and
/// ended segments are removed on the way. The search also finds where the current segment will be penetrated (2.3.3.2, "Cas
/// des faces pénétrantes"): two depth tests where one would suffice without penetration.

#include <algorithm>
#include <limits>

#include "visibility/watkins/spans/span_method.hpp"

namespace ligne::watkins {

template <class X>
class StackMethod final : public SpanMethod<X> {
 public:
  void study(std::span<const ScanSegment<X>> segments, std::vector<VisibleSpan>& out) override {
    segments_ = segments;
    out.clear();
    sort_ends();
    stack_.clear();
    current_ = kNobody;
    turn_ = kFar;
    double x = -kFar;
    for (const End& end : ends_) {
      const double next = double(end.x);
      advance(x, next, out);
      x = next;
      if (end.left) {
        begin(end.segment, x);
      } else if (end.segment == current_) {
        current_ = kNobody;
        choose(x);
      }
    }
  }

 private:
  static constexpr std::uint32_t kNobody = 0xffffffffu;
  static constexpr double kFar = std::numeric_limits<double>::infinity();

  struct End {
    X x;
    std::uint32_t segment;
    bool left;
  };

  /// Sorts the ends by x. At one place right ends come first, so that ended segments do not interfere. Left ends keep the
  /// order of the segments: if these are sorted by the full key, the nearest comes first, and only it needs to be compared
  /// with the current one.
  void sort_ends() {
    ends_.clear();
    for (std::uint32_t i = 0; i < segments_.size(); ++i) {
      if (!(segments_[i].x0 < segments_[i].x1)) continue;
      ends_.push_back({segments_[i].x0, i, true});
      ends_.push_back({segments_[i].x1, i, false});
    }
    std::sort(ends_.begin(), ends_.end(), [this](const End& a, const End& b) {
      ++this->counts_.comparisons;
      if (a.x != b.x) return a.x < b.x;
      if (a.left != b.left) return b.left;
      return a.segment < b.segment;
    });
  }

  /// Emits the visible segments from x to `to`, and changes segments where the current one is penetrated.
  void advance(double x, double to, std::vector<VisibleSpan>& out) {
    while (current_ != kNobody && turn_ < to) {
      note_stack(x, turn_);
      this->give(x, turn_, current_, out);
      x = turn_;
      ++this->counts_.pushes;
      stack_.push_back(current_);
      current_ = kNobody;
      const std::uint32_t follower = turned_to_;
      stack_.erase(std::find(stack_.begin(), stack_.end(), follower));
      current_ = follower;
      look_ahead(x);
    }
    if (current_ == kNobody) return;
    note_stack(x, to);
    this->give(x, to, current_, out);
  }

  void note_stack(double x, double to) {
    if (!this->trace_) return;
    this->note_bar(x, to, 0, current_);
    for (std::size_t i = 0; i < stack_.size(); ++i) this->note_bar(x, to, i + 1, stack_[i]);
  }

  void begin(std::uint32_t segment, double x) {
    ++this->counts_.comparisons;
    if (current_ == kNobody) {
      current_ = segment;
      turn_ = kFar;
      return;
    }
    const ScanSegment<X>&a = segments_[current_], &b = segments_[segment];
    const double to = std::min(double(a.x1), double(b.x1));
    const DepthComparison seen = compare_depths(a, b, x, to, this->counts_, this->pairs_);
    ++this->counts_.pushes;
    if (seen.begins_with_first()) {
      stack_.push_back(segment);
      if (seen.turns_to_second()) note(seen.x, segment);
    } else {
      stack_.push_back(current_);
      current_ = segment;
      look_ahead(x);
    }
  }

  void note(double x, std::uint32_t segment) {
    if (x < turn_) {
      turn_ = x;
      turned_to_ = segment;
    }
  }

  /// Finds where a segment of the stack first penetrates the current one.
  void look_ahead(double x) {
    turn_ = kFar;
    const ScanSegment<X>& a = segments_[current_];
    for (std::size_t i = 0; i < stack_.size();) {
      const ScanSegment<X>& b = segments_[stack_[i]];
      ++this->counts_.comparisons;
      if (double(b.x1) <= x) {
        remove(i);
        continue;
      }
      if (std::min(b.z0, b.z1) < std::max(a.z0, a.z1)) {
        const DepthComparison seen =
            compare_depths(a, b, x, std::min(double(a.x1), double(b.x1)), this->counts_, this->pairs_);
        if (seen.turns_to_second()) note(seen.x, stack_[i]);
      }
      ++i;
    }
  }

  /// Makes the nearest segment of the stack just right of x the current one.
  void choose(double x) {
    std::size_t best = 0;
    bool found = false;
    for (std::size_t i = 0; i < stack_.size();) {
      ++this->counts_.comparisons;
      if (double(segments_[stack_[i]].x1) <= x) {
        remove(i);
        continue;
      }
      if (!found || nearer(segments_[stack_[i]], segments_[stack_[best]], x)) best = i;
      found = true;
      ++i;
    }
    if (!found) return;
    current_ = stack_[best];
    remove(best);
    look_ahead(x);
  }

  bool nearer(const ScanSegment<X>& a, const ScanSegment<X>& b, double x) {
    const DepthComparison seen = compare_depths(a, b, x, std::min(double(a.x1), double(b.x1)), this->counts_, this->pairs_);
    return seen.begins_with_first();
  }

  /// The last segment takes the free place. During a search `best` is below i, so it stays valid.
  void remove(std::size_t i) {
    ++this->counts_.pops;
    stack_[i] = stack_.back();
    stack_.pop_back();
  }

  std::span<const ScanSegment<X>> segments_;
  std::vector<End> ends_;
  std::vector<std::uint32_t> stack_;
  std::uint32_t current_ = kNobody, turned_to_ = kNobody;
  double turn_ = kFar;  ///< place where the current segment is penetrated next
};

}  // namespace ligne::watkins
