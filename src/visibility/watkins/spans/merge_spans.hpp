#pragma once
/// Span method `merge` ([Boulle1980] 2.3.3.1, Fusion, after Lucas 1977). Invariant: the visible list, sorted by x, contains
/// the nearest of the segments taken so far. Its pieces touch or leave gaps (the background), but never overlap. Each new
/// segment is compared with the pieces that it overlaps: test IS cuts both to the common run, test PRO decides which is
/// visible there.

#include <algorithm>

#include "visibility/watkins/spans/span_method.hpp"

namespace ligne::watkins {

template <class X>
class MergeMethod final : public SpanMethod<X> {
 public:
  void study(std::span<const ScanSegment<X>> segments, std::vector<VisibleSpan>& out) override {
    segments_ = segments;
    pieces_.clear();
    head_ = passed_ = kEnd;
    for (std::uint32_t i = 0; i < segments.size(); ++i) {
      if (segments[i].x0 < segments[i].x1) merge(i);
      if (this->trace_) note_list(i);
    }
    out.clear();
    for (std::uint32_t p = head_; p != kEnd; p = pieces_[p].next)
      this->give(pieces_[p].x0, pieces_[p].x1, pieces_[p].segment, out);
  }

 private:
  static constexpr std::uint32_t kEnd = 0xffffffffu;

  struct Piece {
    double x0, x1;
    std::uint32_t segment, next;
  };

  void note_list(std::uint32_t row) {
    for (std::uint32_t p = head_; p != kEnd; p = pieces_[p].next)
      this->note_bar(pieces_[p].x0, pieces_[p].x1, row, pieces_[p].segment);
  }

  /// Inserts a piece behind `before` (or first), or extends `before` if the piece continues it.
  std::uint32_t insert(std::uint32_t before, double x0, double x1, std::uint32_t segment) {
    if (!(x0 < x1)) return before;
    if (before != kEnd && pieces_[before].segment == segment && pieces_[before].x1 == x0) {
      pieces_[before].x1 = x1;
      return before;
    }
    ++this->counts_.insertions;
    const auto piece = static_cast<std::uint32_t>(pieces_.size());
    pieces_.push_back({x0, x1, segment, before == kEnd ? head_ : pieces_[before].next});
    (before == kEnd ? head_ : pieces_[before].next) = piece;
    return piece;
  }

  void merge(std::uint32_t index) {
    const ScanSegment<X>& segment = segments_[index];
    double x = double(segment.x0);
    const double end = double(segment.x1);
    // Skips pieces wholly to the left. Pieces left of one segment are left of all segments that begin farther right: sorted
    // segments continue from there, others begin anew.
    ++this->counts_.comparisons;
    const bool continues = passed_ != kEnd && pieces_[passed_].x1 <= x;
    std::uint32_t before = continues ? passed_ : kEnd, piece = continues ? pieces_[passed_].next : head_;
    while (piece != kEnd && (++this->counts_.comparisons, pieces_[piece].x1 <= x)) {
      before = piece;
      piece = pieces_[piece].next;
    }
    passed_ = before;
    while (x < end) {
      ++this->counts_.comparisons;
      if (piece == kEnd || pieces_[piece].x0 >= end) {
        insert(before, x, end, index);
        return;
      }
      if (pieces_[piece].x0 > x) {  // a gap in front of the piece
        before = insert(before, x, pieces_[piece].x0, index);
        x = pieces_[piece].x0;
        continue;
      }
      const Piece old = pieces_[piece];
      const double to = std::min(end, old.x1);
      const DepthComparison seen = compare_depths(segments_[old.segment], segment, x, to, this->counts_, this->pairs_);
      if (seen.order == DepthOrder::first) {  // the new segment is hidden here
        if (old.x1 > end) return;
        before = piece;
        piece = old.next;
        x = to;
        continue;
      }
      // Replaces the piece by its part left of x, the common run, and its part right of it.
      (before == kEnd ? head_ : pieces_[before].next) = old.next;
      before = insert(before, old.x0, x, old.segment);
      if (seen.order == DepthOrder::second) {
        before = insert(before, x, to, index);
      } else {
        const bool old_first = seen.first_begins;
        before = insert(before, x, seen.x, old_first ? old.segment : index);
        before = insert(before, seen.x, to, old_first ? index : old.segment);
      }
      if (to < old.x1) insert(before, to, old.x1, old.segment);
      piece = old.next;
      x = to;
    }
  }

  std::span<const ScanSegment<X>> segments_;
  std::vector<Piece> pieces_;
  std::uint32_t head_ = kEnd;
  std::uint32_t passed_ = kEnd;  ///< last listed piece left of the current segment: only pieces right of it are replaced
};

}  // namespace ligne::watkins
