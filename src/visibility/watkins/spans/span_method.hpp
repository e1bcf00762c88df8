#pragma once
/// Which segment is nearest along one scan line: the four span methods of [Boulle1980] (2.3.2.6, 2.3.3) behind one
/// interface.
///
/// Notation: a scan plane cuts every face in segments. A segment runs from (x0, z0) to (x1, z1), x0 <= x1; depth is linear
/// over it and smaller is nearer. X is double (real coordinates) or std::int32_t (whole ones, as in [Boulle1980]'s screen).

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "visibility/common/depth_order.hpp"

namespace ligne::watkins {

template <class X>
struct ScanSegment {
  X x0, x1;
  double z0, z1;
  std::uint32_t face;
  double depth_tolerance = 0;  ///< what is within this depth of it touches it

  /// Depth at x; the ends give their own depth to the last bit.
  double z(double x) const {
    if (x <= double(x0)) return z0;
    if (x >= double(x1)) return z1;
    return z0 + (z1 - z0) * ((x - double(x0)) / (double(x1) - double(x0)));
  }
  double slope() const { return x0 < x1 ? (z1 - z0) / (double(x1) - double(x0)) : 0; }
};

/// A run on which one segment is the nearest. Its ends are ends of segments, or places where two of them penetrate (which
/// are no whole numbers even when the ends are).
struct VisibleSpan {
  double x0, x1;          ///< x0 < x1
  std::uint32_t segment;  ///< index among the segments studied
};

/// Whether every span has a length and begins where the one before it ends, or further to the right.
inline bool are_left_to_right(std::span<const VisibleSpan> spans) {
  for (std::size_t i = 0; i < spans.size(); ++i) {
    if (!(spans[i].x0 < spans[i].x1) || (i > 0 && spans[i].x0 < spans[i - 1].x1)) return false;
  }
  return true;
}

/// The cost of a study, as [Boulle1980] counts it. `total()` is the sum over which methods are compared.
struct SpanCounts {
  std::uint64_t comparisons = 0;   ///< of abscissas
  std::uint64_t depth_tests = 0;   ///< depths compared with each other
  std::uint64_t penetrations = 0;  ///< places computed where two segments cross
  std::uint64_t insertions = 0;    ///< pieces put into the visible list (merge)
  std::uint64_t pushes = 0;        ///< (stack)
  std::uint64_t pops = 0;          ///< (stack)
  std::uint64_t boxes = 0;         ///< parts of the line studied as a box (box)
  std::uint64_t points = 0;        ///< cells of the line written or compared (point)
  std::uint64_t spans = 0;         ///< spans handed out
  std::uint64_t swaps = 0;         ///< exchanges in sorting

  void operator+=(const SpanCounts& o);
  std::uint64_t total() const;
  static constexpr std::size_t kKinds = 10;
  std::array<std::pair<std::string_view, std::uint64_t>, kKinds> named() const;
};

/// How a study went, for pictures of the scan plane. Row 0 is drawn first.
struct SpanTrace {
  /// A run of the line in one row: of merge the visible list after a segment, of stack a place on the stack (row 0: the
  /// current segment), of box a part at a depth of division, of point a cell.
  struct Bar {
    double x0, x1;
    unsigned row;
    std::uint32_t segment;  ///< index among the segments studied; 0xffffffff: a part that is divided
  };
  std::vector<Bar> bars;
};

enum class SpanMethodKind : std::uint8_t { merge, stack, box, point };
inline constexpr std::array<std::string_view, 4> kSpanMethodNames{"merge", "stack", "box", "point"};

/// Knows which of two segments that touch is in front, by their faces, and the same on every line, so that the roundings of
/// depths change nothing from line to line. `crossing`: their depths decide.
class PairOrders {
 public:
  virtual ~PairOrders() = default;
  virtual DepthOrder of(std::uint32_t a, std::uint32_t b) = 0;
};

/// The full key of 2.3.3.1: x of the left end, then depth there, then slope; what is nearer comes first. The methods need
/// it only to be fast (merge, stack with whole ties), never to be right.
template <class X>
bool comes_before(const ScanSegment<X>& a, const ScanSegment<X>& b) {
  if (a.x0 != b.x0) return a.x0 < b.x0;
  if (a.z0 != b.z0) return a.z0 < b.z0;
  return a.slope() < b.slope();
}

/// A span method keeps working memory from line to line, nothing else: the spans it
/// finds do not depend on what it studied before.
template <class X>
class SpanMethod {
 public:
  virtual ~SpanMethod() = default;

  /// Replaces `out` by the visible spans of the line, from left to right, disjoint; neighbours of one segment are one span.
  /// Where depths are equal along a whole run either segment may be given. Segments of length zero are seen nowhere.
  virtual void study(std::span<const ScanSegment<X>> segments, std::vector<VisibleSpan>& out) = 0;

  const SpanCounts& counts() const { return counts_; }

  /// Who is asked where segments touch; without anybody their depths decide.
  void ask(PairOrders* pairs) { pairs_ = pairs; }

  /// Further studies are recorded there; null: nowhere.
  void record(SpanTrace* trace) { trace_ = trace; }

 protected:
  void note_bar(double x0, double x1, std::size_t row, std::uint32_t segment) {
    if (trace_ && x0 < x1) trace_->bars.push_back({x0, x1, static_cast<unsigned>(row), segment});
  }

  /// Appends a span, or lengthens the last one.
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

template <class X>
std::unique_ptr<SpanMethod<X>> make_merge_method();
template <class X>
std::unique_ptr<SpanMethod<X>> make_stack_method();
template <class X>
std::unique_ptr<SpanMethod<X>> make_box_method();
template <class X>
std::unique_ptr<SpanMethod<X>> make_point_method();

/// Depths that differ by less than this share of themselves are equal: updated line by line they carry the roundings of
/// thousands of additions, and faces that touch are to touch on every line. Of a depth as large as a page it is a third of a
/// nanometre.
inline constexpr double kSameDepth = 0x1p-30;

/// How two segments lie to each other on [x0, x1], which both span.
struct DepthComparison {
  DepthOrder order;           ///< first, second or crossing
  bool first_begins = false;  ///< where they cross: the first is in front before, the second behind
  double x = 0;               ///< where they cross

  bool begins_with_first() const { return order == DepthOrder::first || (order == DepthOrder::crossing && first_begins); }
  bool turns_to_second() const { return order == DepthOrder::crossing && first_begins; }
};

/// The test PRO of [Boulle1980] (figure 2.44): two depth tests, and a division only when the segments cross strictly inside.
/// Equal depths all along count as `first`. Where the two touch, `pairs` is asked, which may be null.
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
  // Rounded onto an end: the order over the whole run is that of the other end.
  if (!(x > x0)) return {d1 < 0 ? DepthOrder::first : DepthOrder::second, false, x0};
  if (!(x < x1)) return {d0 < 0 ? DepthOrder::first : DepthOrder::second, false, x0};
  return {DepthOrder::crossing, d0 < 0, x};
}

}  // namespace ligne::watkins
