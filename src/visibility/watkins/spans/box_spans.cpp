#include <algorithm>
#include <cmath>
#include <limits>

#include "visibility/watkins/spans/span_method.hpp"

// Span method `box` ([Boulle1980] 2.3.3.3, Boîte, after Romney, Watkins and Evans 1969): Warnock's division on a line. A
// part of the line is compared with a box round the segments met so far. If the situation is understood, it is shown;
// otherwise the part is divided at an end of a segment, at a penetration, or in the middle. The three modules are those of
// [Boulle1980]: analysis, decision, control.
//
// The end nearest to the middle divides a part, so that n segments side by side take O(n log n). Segments found hidden by
// the analysis are not passed on.

namespace ligne::watkins {
namespace {

template <class X>
class BoxMethod final : public SpanMethod<X> {
 public:
  void study(std::span<const ScanSegment<X>> segments, std::vector<VisibleSpan>& out) override {
    segments_ = segments;
    out.clear();
    lists_.clear();
    double from = kFar, to = -kFar;
    for (std::uint32_t i = 0; i < segments.size(); ++i) {
      if (!(segments[i].x0 < segments[i].x1)) continue;
      lists_.push_back(i);
      from = std::min(from, double(segments[i].x0));
      to = std::max(to, double(segments[i].x1));
    }
    if (!lists_.empty()) study_part(from, to, 0, lists_.size(), out);
  }

 private:
  static constexpr double kFar = std::numeric_limits<double>::infinity();

  /// The result of analysing a part: the box round the segments that may be visible in it.
  struct Box {
    unsigned count = 0;
    double x0 = 0, x1 = 0;      ///< extent along the line
    double near = 0;            ///< nearest depth that touches a segment
    std::uint32_t segment = 0;  ///< the only segment (count 1), or the first of two that cross
    std::uint32_t other = 0;    ///< if crossing: the second
    bool crossing = false;      ///< two segments spanning the part cross at `cut`, and nothing else is there
    double cut = -kFar;         ///< an end or a crossing strictly inside the part
    bool cut_at_end = false;    ///< `cut` is an end
  };

  /// Analysis, decision and control of [a, b] with the segments lists_[begin, end).
  void study_part(double a, double b, std::size_t begin, std::size_t end, std::vector<VisibleSpan>& out) {
    ++this->counts_.boxes;
    const std::size_t kept_begin = lists_.size();
    Box box;
    for (std::size_t i = begin; i < end; ++i) analyse(lists_[i], a, b, kept_begin, box);
    decide(box, a, b, kept_begin, out);
    lists_.resize(kept_begin);
  }

  void analyse(std::uint32_t index, double a, double b, std::size_t kept_begin, Box& box) {
    const ScanSegment<X>& s = segments_[index];
    ++this->counts_.comparisons;
    if (double(s.x1) <= a || double(s.x0) >= b) return;
    const double l = std::max(double(s.x0), a), r = std::min(double(s.x1), b);
    const double zl = s.z(l), zr = s.z(r);
    if (box.count == 0) {
      lists_.push_back(index);
      start(box, index, l, r, zl, zr);
      return;
    }
    this->counts_.comparisons += 2;
    const bool covers = l <= box.x0 && r >= box.x1;
    if (box.count == 1) {
      const ScanSegment<X>& t = segments_[box.segment];
      if (covers || (l >= box.x0 && r <= box.x1)) {
        const double c0 = std::max(l, box.x0), c1 = std::min(r, box.x1);
        const DepthComparison seen = compare_depths(t, s, c0, c1, this->counts_, this->pairs_);
        if (seen.order == DepthOrder::first && !(covers && (l < box.x0 || r > box.x1))) return;  // hidden by the box
        if (seen.order == DepthOrder::second && covers) {
          lists_.resize(kept_begin);
          lists_.push_back(index);
          start(box, index, l, r, zl, zr);
          return;
        }
        if (seen.order == DepthOrder::crossing) {
          box.cut = seen.x;
          if (c0 == a && c1 == b) {
            box.crossing = true;
            const bool t_first = seen.first_begins;
            box.other = t_first ? index : box.segment;
            box.segment = t_first ? box.segment : index;
          }
        }
      }
    } else {
      ++this->counts_.depth_tests;
      if (covers && std::max(s.z(box.x0), s.z(box.x1)) + s.depth_tolerance <= box.near) {
        lists_.resize(kept_begin);
        lists_.push_back(index);
        start(box, index, l, r, zl, zr);
        return;
      }
      box.crossing = false;
    }
    lists_.push_back(index);
    ++box.count;
    if (!box.crossing) {
      this->counts_.comparisons += 2;
      for (const double x : {l, r, box.x0, box.x1}) {
        if (x > a && x < b && (!box.cut_at_end || std::abs(2 * x - a - b) < std::abs(2 * box.cut - a - b))) {
          box.cut = x;
          box.cut_at_end = true;
        }
      }
    }
    box.x0 = std::min(box.x0, l);
    box.x1 = std::max(box.x1, r);
    box.near = std::min(box.near, std::min(zl, zr) - s.depth_tolerance);
  }

  void start(Box& box, std::uint32_t index, double l, double r, double zl, double zr) {
    box = Box{};
    box.count = 1;
    box.segment = index;
    box.x0 = l;
    box.x1 = r;
    box.near = std::min(zl, zr) - segments_[index].depth_tolerance;
  }

  void decide(const Box& box, double a, double b, std::size_t kept_begin, std::vector<VisibleSpan>& out) {
    if (box.count == 0) return;
    if (box.count == 1) {
      this->note_bar(box.x0, box.x1, depth_, box.segment);
      this->give(box.x0, box.x1, box.segment, out);
      return;
    }
    if (box.crossing) {
      this->note_bar(a, box.cut, depth_, box.segment);
      this->note_bar(box.cut, b, depth_, box.other);
      this->give(a, box.cut, box.segment, out);
      this->give(box.cut, b, box.other, out);
      return;
    }
    const double cut = box.cut > a && box.cut < b ? box.cut : a + (b - a) / 2;
    if (!(cut > a && cut < b)) {  // no number lies between a and b: only rounding separates the segments
      const auto first = lists_.begin() + static_cast<std::ptrdiff_t>(kept_begin);
      const auto nearest = std::min_element(
          first, lists_.end(), [&](std::uint32_t i, std::uint32_t k) { return segments_[i].z(a) < segments_[k].z(a); });
      this->note_bar(a, b, depth_, *nearest);
      this->give(a, b, *nearest, out);
      return;
    }
    this->note_bar(a, b, depth_, kDivided);
    const std::size_t kept_end = lists_.size();
    ++depth_;
    study_part(a, cut, kept_begin, kept_end, out);
    study_part(cut, b, kept_begin, kept_end, out);
    --depth_;
  }

  static constexpr std::uint32_t kDivided = 0xffffffffu;  ///< SpanTrace::Bar::segment

  std::span<const ScanSegment<X>> segments_;
  unsigned depth_ = 0;                ///< depth of division
  std::vector<std::uint32_t> lists_;  ///< stack of lists: the segments of a part lie above those of its parent
};

}  // namespace

template <class X>
std::unique_ptr<SpanMethod<X>> make_box_method() {
  return std::make_unique<BoxMethod<X>>();
}

template std::unique_ptr<SpanMethod<double>> make_box_method<double>();
template std::unique_ptr<SpanMethod<std::int32_t>> make_box_method<std::int32_t>();

}  // namespace ligne::watkins
