#pragma once
/// The nearest segment along one scan line: the span methods of [Boulle1980] (2.3.2.6, 2.3.3) behind one interface.
///
/// Notation: a scan plane cuts every face in segments. A segment extends from (x0, z0) to (x1, z1), x0 <= x1. Depth is
/// linear along it; smaller is nearer. X is double (real coordinates) or std::int32_t (integers, as on [Boulle1980]'s
/// screen).

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "base/add_counts.hpp"
#include "drawing/statistics.hpp"
#include "visibility/common/facet.hpp"

namespace ligne::watkins {

template <class X>
struct ScanSegment {
  X x0, x1;
  double z0, z1;
  std::uint32_t face;
  std::uint32_t key = 0;       ///< stays with the face from line to line; `face` need not
  double depth_tolerance = 0;  ///< depth difference at which segments touch

  /// Depth at x. At the ends it is bitwise equal to z0 and z1.
  double z(double x) const {
    if (x <= double(x0)) return z0;
    if (x >= double(x1)) return z1;
    return z0 + (z1 - z0) * ((x - double(x0)) / (double(x1) - double(x0)));
  }
  double slope() const { return x0 < x1 ? (z1 - z0) / (double(x1) - double(x0)) : 0; }
};

/// A run on which one segment is the nearest. It ends at ends of segments, or where two penetrate (not at an integer, even
/// for integer ends).
struct VisibleSpan {
  double x0, x1;          ///< x0 < x1
  std::uint32_t segment;  ///< index in the studied segments
};

/// True if every span has positive length and none begins left of the end of its predecessor.
inline bool are_left_to_right(std::span<const VisibleSpan> spans) {
  for (std::size_t i = 0; i < spans.size(); ++i) {
    if (!(spans[i].x0 < spans[i].x1) || (i > 0 && spans[i].x0 < spans[i - 1].x1)) return false;
  }
  return true;
}

/// The cost of a study, as [Boulle1980] counts it. `total()` is the sum by which methods are compared.
struct SpanCounts {
  std::uint64_t comparisons = 0;   ///< compared abscissas
  std::uint64_t depth_tests = 0;   ///< compared depths
  std::uint64_t penetrations = 0;  ///< computed crossings of two segments
  std::uint64_t insertions = 0;    ///< pieces inserted into the visible list (merge)
  std::uint64_t pushes = 0;        ///< pushed segments (stack)
  std::uint64_t pops = 0;          ///< popped segments (stack)
  std::uint64_t boxes = 0;         ///< parts of the line studied as a box (box)
  std::uint64_t remembered = 0;    ///< divisions taken from the line before (remembered)
  std::uint64_t points = 0;        ///< cells of the line written or compared (point)
  std::uint64_t spans = 0;         ///< resulting spans
  std::uint64_t swaps = 0;         ///< exchanges of the sort

  void operator+=(const SpanCounts& o) { add_counts(*this, o); }
  std::uint64_t total() const;
  static constexpr std::size_t kKinds = 11;
  std::array<std::pair<std::string_view, std::uint64_t>, kKinds> named() const;
};

void report(const SpanCounts& counts, Statistics& statistics);

/// The steps of a study, for pictures of the scan plane. Row 0 is drawn first.
struct SpanTrace {
  /// A run of the line in one row. The row is: for merge the visible list after a segment, for stack a place on the stack
  /// (row 0: the current segment), for box the depth of division; for point a bar is a cell.
  struct Bar {
    double x0, x1;
    unsigned row;
    std::uint32_t segment;  ///< index in the studied segments; 0xffffffff: a divided part
  };
  std::vector<Bar> bars;
};

/// `remembered` is `box` with the divisions of the line before.
enum class SpanMethodKind : std::uint8_t { merge, stack, box, point, remembered };
inline constexpr std::array<std::string_view, 5> kSpanMethodNames{"merge", "stack", "box", "point", "remembered"};

/// Decides which of two touching segments is in front, by their faces and equally on every line, so that rounding of depths
/// changes nothing. `crossing`: their depths decide.
class PairOrders {
 public:
  virtual ~PairOrders() = default;
  virtual DepthOrder of(std::uint32_t a, std::uint32_t b) = 0;
};

/// The full sort key of 2.3.3.1: x of the left end, then depth there, then slope; nearer segments first. It makes merge and
/// stack fast, but no method needs it to be correct.
template <class X>
bool comes_before(const ScanSegment<X>& a, const ScanSegment<X>& b) {
  if (a.x0 != b.x0) return a.x0 < b.x0;
  if (a.z0 != b.z0) return a.z0 < b.z0;
  return a.slope() < b.slope();
}

/// A span method. It keeps only scratch memory between lines: the spans it finds do not depend on earlier studies.
template <class X>
class SpanMethod {
 public:
  virtual ~SpanMethod() = default;

  /// Replaces `out` by the visible spans of the line, disjoint and from left to right; adjacent spans of one segment are
  /// joined. Where depths are equal along a whole run, either segment may be given. Segments of length zero are invisible.
  virtual void study(std::span<const ScanSegment<X>> segments, std::vector<VisibleSpan>& out) = 0;

  const SpanCounts& counts() const { return counts_; }

  /// Sets the order used where segments touch; null: depths decide.
  void ask(PairOrders* pairs) { pairs_ = pairs; }

  /// Sets the trace that records further studies; null: none.
  void record(SpanTrace* trace) { trace_ = trace; }

 protected:
  void note_bar(double x0, double x1, std::size_t row, std::uint32_t segment) {
    if (trace_ && x0 < x1) trace_->bars.push_back({x0, x1, static_cast<unsigned>(row), segment});
  }

  /// Appends a span, or extends the last one.
  void give(double x0, double x1, std::uint32_t segment, std::vector<VisibleSpan>& out) {
    if (!(x0 < x1)) return;
    if (!out.empty() && out.back().segment == segment && out.back().x1 == x0) {
      out.back().x1 = x1;
      return;
    }
    out.push_back({x0, x1, segment});
    ++counts_.spans;
  }

  SpanCounts counts_;
  PairOrders* pairs_ = nullptr;
  SpanTrace* trace_ = nullptr;
};

template <class X>
std::unique_ptr<SpanMethod<X>> make_span_method(SpanMethodKind kind);

/// Method `box`, or `remembered`. Private to spans.
template <class X>
std::unique_ptr<SpanMethod<X>> make_box_method(bool remembers);

/// Relative difference below which depths are equal. Depths updated line by line carry the rounding of thousands of
/// additions, and touching faces must touch on every line. For a depth as large as a page it is a third of a nanometre.
inline constexpr double kSameDepth = 0x1p-30;

/// The order of two segments on [x0, x1], which both span.
struct DepthComparison {
  DepthOrder order;           ///< first, second or crossing
  bool first_begins = false;  ///< if they cross: the first is in front before the crossing
  double x = 0;               ///< place of the crossing

  bool begins_with_first() const { return order == DepthOrder::first || (order == DepthOrder::crossing && first_begins); }
  bool turns_to_second() const { return order == DepthOrder::crossing && first_begins; }
};

/// The test PRO of [Boulle1980] (figure 2.44): two depth tests, and a division only if the segments cross strictly inside.
/// Equal depths on the whole run count as `first`. `pairs`, which may be null, decides where the two touch.
template <class X>
DepthComparison compare_depths(const ScanSegment<X>& a, const ScanSegment<X>& b, double x0, double x1, SpanCounts& counts,
                               PairOrders* pairs) {
  counts.depth_tests += 2;
  const auto difference = [&](double x) {
    const double za = a.z(x), zb = b.z(x), d = za - zb;
    return std::abs(d) <= kSameDepth * (std::abs(za) + std::abs(zb)) ? 0.0 : d;
  };
  const double d0 = difference(x0), d1 = difference(x1);
  if (pairs && std::min(std::abs(d0), std::abs(d1)) <= a.depth_tolerance + b.depth_tolerance) {
    const DepthOrder order = pairs->of(a.face, b.face);
    if (order != DepthOrder::crossing)
      return {order == DepthOrder::first ? DepthOrder::first : DepthOrder::second, false, x0};
  }
  if (d0 <= 0 && d1 <= 0) return {DepthOrder::first, false, x0};
  if (d0 >= 0 && d1 >= 0) return {DepthOrder::second, false, x0};
  ++counts.penetrations;
  const double x = x0 + (x1 - x0) * (d0 / (d0 - d1));
  // Rounded to an end: the order at the other end holds for the whole run.
  if (!(x > x0)) return {d1 < 0 ? DepthOrder::first : DepthOrder::second, false, x0};
  if (!(x < x1)) return {d0 < 0 ? DepthOrder::first : DepthOrder::second, false, x0};
  return {DepthOrder::crossing, d0 < 0, x};
}

}  // namespace ligne::watkins
