#pragma once
/// Span method `point` ([Boulle1980] 2.3.2.6, point par point, after Lucas 1977): every cell of the line stores depth and
/// segment, and every segment is compared with all cells that it covers. With integer coordinates a cell is the run between
/// adjacent integers, and depths are compared at its middle, so penetrations are rounded to cells. With real coordinates the
/// cells are the runs between adjacent ends of segments, and a cell is cut where the depth order changes inside it.

#include <algorithm>
#include <limits>
#include <type_traits>

#include "visibility/watkins/spans/span_method.hpp"

namespace ligne::watkins {

template <class X>
class PointMethod final : public SpanMethod<X> {
 public:
  void study(std::span<const ScanSegment<X>> segments, std::vector<VisibleSpan>& out) override {
    segments_ = segments;
    out.clear();
    if constexpr (std::is_integral_v<X>) {
      study_cells(out);
    } else {
      study_runs(out);
    }
  }

 private:
  static constexpr std::uint32_t kNobody = 0xffffffffu;

  void study_cells(std::vector<VisibleSpan>& out) {
    std::int64_t from = std::numeric_limits<std::int64_t>::max(), to = std::numeric_limits<std::int64_t>::min();
    for (const ScanSegment<X>& s : segments_) {
      if (!(s.x0 < s.x1)) continue;
      from = std::min<std::int64_t>(from, s.x0);
      to = std::max<std::int64_t>(to, s.x1);
    }
    if (from >= to) return;
    const auto n = static_cast<std::size_t>(to - from);
    depth_.assign(n, std::numeric_limits<double>::infinity());
    seen_.assign(n, kNobody);
    for (std::uint32_t i = 0; i < segments_.size(); ++i) {
      const ScanSegment<X>& s = segments_[i];
      for (std::int64_t x = s.x0; x < s.x1; ++x) {
        const auto cell = static_cast<std::size_t>(x - from);
        ++this->counts_.points;
        ++this->counts_.depth_tests;
        const double z = s.z(double(x) + 0.5);
        if (z < depth_[cell]) {
          depth_[cell] = z;
          seen_[cell] = i;
        }
      }
    }
    for (std::size_t cell = 0; cell < n; ++cell) {
      if (seen_[cell] == kNobody) continue;
      const double x = double(from) + double(cell);
      this->note_bar(x, x + 1, 0, seen_[cell]);
      this->give(x, x + 1, seen_[cell], out);
    }
  }

  void study_runs(std::vector<VisibleSpan>& out) {
    ends_.clear();
    for (const ScanSegment<X>& s : segments_) {
      if (s.x0 < s.x1) ends_.insert(ends_.end(), {double(s.x0), double(s.x1)});
    }
    std::sort(ends_.begin(), ends_.end(), [this](double a, double b) {
      ++this->counts_.comparisons;
      return a < b;
    });
    ends_.erase(std::unique(ends_.begin(), ends_.end()), ends_.end());
    for (std::size_t k = 0; k + 1 < ends_.size(); ++k) study_run(ends_[k], ends_[k + 1], out);
  }

  /// Studies [a, b], which contains no end of a segment.
  void study_run(double a, double b, std::vector<VisibleSpan>& out) {
    double x = a;
    while (x < b) {
      // The nearest segment just right of x, and where it stops being the nearest.
      std::uint32_t best = kNobody;
      double turn = b;
      for (std::uint32_t i = 0; i < segments_.size(); ++i) {
        const ScanSegment<X>& s = segments_[i];
        ++this->counts_.comparisons;
        if (double(s.x0) > a || double(s.x1) < b) continue;
        ++this->counts_.points;
        if (best == kNobody) {
          best = i;
          continue;
        }
        const DepthComparison seen = compare_depths(segments_[best], s, x, b, this->counts_, this->pairs_);
        if (!seen.begins_with_first()) best = i;
      }
      if (best == kNobody) return;
      for (std::uint32_t i = 0; i < segments_.size(); ++i) {
        const ScanSegment<X>& s = segments_[i];
        if (i == best || double(s.x0) > a || double(s.x1) < b) continue;
        const DepthComparison seen = compare_depths(segments_[best], s, x, b, this->counts_, this->pairs_);
        if (seen.turns_to_second()) turn = std::min(turn, seen.x);
      }
      this->note_bar(x, turn, 0, best);
      this->give(x, turn, best, out);
      x = turn;
    }
  }

  std::span<const ScanSegment<X>> segments_;
  std::vector<double> depth_, ends_;
  std::vector<std::uint32_t> seen_;
};

}  // namespace ligne::watkins
