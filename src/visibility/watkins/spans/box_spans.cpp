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
//
// Method `remembered` begins with the divisions of the line before that bound a visible run, as [Boulle1980] proposes. They
// are moved to where the same segments end, or cross, on this line, and divide it without an analysis; the parts between
// them are studied as by `box`. A division whose segments are gone is forgotten.

namespace ligne::watkins {
namespace {

template <class X>
class BoxMethod final : public SpanMethod<X> {
 public:
  explicit BoxMethod(bool remembers) : remembers_(remembers) {}

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
    if (lists_.empty()) return memory_.clear();
    if (!remembers_) return study_part(from, to, 0, lists_.size(), out);
    update_divisions(from, to);
    made_.clear();
    study_known(from, to, memory_, 0, lists_.size(), out);
    keep_divisions(out);
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

  /// A division of the line: the end of a segment, or the place where two cross. Segments are known by their keys.
  struct Division {
    double x;
    std::uint32_t key, other;  ///< of the segments; `other` is kNobody at an end
    bool at_left_end;
  };

  /// Moves the divisions of the line before to their places between `from` and `to` on this one, in order.
  void update_divisions(double from, double to) {
    std::uint32_t last_key = 0;
    for (const std::uint32_t i : lists_) last_key = std::max(last_key, segments_[i].key);
    if (index_of_.size() <= last_key) index_of_.resize(last_key + 1, kNobody);
    for (const std::uint32_t i : lists_) index_of_[segments_[i].key] = i;
    const auto segment_of = [&](std::uint32_t key) { return key < index_of_.size() ? index_of_[key] : kNobody; };
    std::erase_if(memory_, [&](Division& d) {
      const std::uint32_t i = segment_of(d.key);
      if (i == kNobody) return true;
      const ScanSegment<X>& s = segments_[i];
      d.x = double(d.at_left_end ? s.x0 : s.x1);
      if (d.other != kNobody) {
        const std::uint32_t k = segment_of(d.other);
        if (k == kNobody) return true;
        const ScanSegment<X>& t = segments_[k];
        const double x0 = std::max(double(s.x0), double(t.x0)), x1 = std::min(double(s.x1), double(t.x1));
        if (!(x0 < x1)) return true;
        const DepthComparison seen = compare_depths(s, t, x0, x1, this->counts_, this->pairs_);
        if (seen.order != DepthOrder::crossing) return true;
        d.x = seen.x;
      }
      return !(d.x > from && d.x < to);
    });
    for (const std::uint32_t i : lists_) index_of_[segments_[i].key] = kNobody;
    std::sort(memory_.begin(), memory_.end(), [this](const Division& a, const Division& b) {
      ++this->counts_.comparisons;
      return a.x < b.x;
    });
    const auto same = [](const Division& a, const Division& b) { return a.x == b.x; };
    memory_.erase(std::unique(memory_.begin(), memory_.end(), same), memory_.end());
    this->counts_.remembered += memory_.size();
  }

  /// Control of [a, b] where the divisions `known` lie inside it: the middle one divides it. Its segments are only told
  /// apart by their places.
  void study_known(double a, double b, std::span<const Division> known, std::size_t begin, std::size_t end,
                   std::vector<VisibleSpan>& out) {
    if (known.empty()) return study_part(a, b, begin, end, out);
    const std::size_t middle = known.size() / 2, kept = lists_.size();
    const double x = known[middle].x;
    made_.push_back(known[middle]);
    this->note_bar(a, b, depth_, kDivided);
    ++depth_;
    this->counts_.comparisons += 2 * (end - begin);
    for (std::size_t i = begin; i < end; ++i) {
      if (double(segments_[lists_[i]].x0) < x) lists_.push_back(lists_[i]);
    }
    study_known(a, x, known.first(middle), kept, lists_.size(), out);
    lists_.resize(kept);
    for (std::size_t i = begin; i < end; ++i) {
      if (double(segments_[lists_[i]].x1) > x) lists_.push_back(lists_[i]);
    }
    study_known(x, b, known.subspan(middle + 1), kept, lists_.size(), out);
    lists_.resize(kept);
    --depth_;
  }

  /// Keeps for the next line the divisions at which a visible run begins or ends.
  void keep_divisions(const std::vector<VisibleSpan>& out) {
    memory_.clear();
    for (const Division& d : made_) {
      const auto run = std::partition_point(out.begin(), out.end(), [&](const VisibleSpan& s) { return s.x1 < d.x; });
      if (run != out.end() && (run->x0 == d.x || run->x1 == d.x)) memory_.push_back(d);
    }
  }

  /// Notes a division at `x`, if a segment of the part ends there.
  void note_end(double x, std::size_t begin) {
    for (std::size_t i = begin; i < lists_.size(); ++i) {
      const ScanSegment<X>& s = segments_[lists_[i]];
      if (double(s.x0) != x && double(s.x1) != x) continue;
      made_.push_back({x, s.key, kNobody, double(s.x0) == x});
      return;
    }
  }

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
      if (remembers_) made_.push_back({box.cut, segments_[box.segment].key, segments_[box.other].key, false});
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
    if (remembers_) note_end(cut, kept_begin);
    const std::size_t kept_end = lists_.size();
    ++depth_;
    study_part(a, cut, kept_begin, kept_end, out);
    study_part(cut, b, kept_begin, kept_end, out);
    --depth_;
  }

  static constexpr std::uint32_t kDivided = 0xffffffffu;  ///< SpanTrace::Bar::segment
  static constexpr std::uint32_t kNobody = 0xffffffffu;

  bool remembers_;
  std::vector<Division> memory_, made_;  ///< divisions of the line before; those made on this line
  std::vector<std::uint32_t> index_of_;  ///< by key: a segment of the line at hand; kNobody between studies
  std::span<const ScanSegment<X>> segments_;
  unsigned depth_ = 0;                ///< depth of division
  std::vector<std::uint32_t> lists_;  ///< stack of lists: the segments of a part lie above those of its parent
};

}  // namespace

template <class X>
std::unique_ptr<SpanMethod<X>> make_box_method(bool remembers) {
  return std::make_unique<BoxMethod<X>>(remembers);
}

template std::unique_ptr<SpanMethod<double>> make_box_method<double>(bool);
template std::unique_ptr<SpanMethod<std::int32_t>> make_box_method<std::int32_t>(bool);

}  // namespace ligne::watkins
