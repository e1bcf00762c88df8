#include "areas/steps.hpp"

#include <algorithm>
#include <utility>

namespace ligne::svg {
namespace {

/// Quotients in doubles that differ by more than this differ exactly too: they lie in [0, 1] and carry three roundings.
constexpr double kQuotientRounding = 0x1p-50;

/// Products of two numbers below this fit into 128 bits.
constexpr Int128 kFactorLimit = Int128{1} << 63;

/// Compares positive fractions by their continued fractions, which need no products.
int compare_fractions(Int128 a, Int128 b, Int128 c, Int128 d) {
  for (int sign = 1;; sign = -sign) {
    const Int128 whole_of_first = a / b, whole_of_second = c / d;
    if (whole_of_first != whole_of_second) return whole_of_first < whole_of_second ? -sign : sign;
    a %= b;
    c %= d;
    if (a == 0 || c == 0) return a == c ? 0 : a == 0 ? -sign : sign;
    std::swap(a, b);
    std::swap(c, d);
  }
}

}  // namespace

bool lies_on(const StepSegment& s, StepPoint p) {
  if (p.x < std::min(s.a.x, s.b.x) - 1 || p.x > std::max(s.a.x, s.b.x) + 1 || p.y < std::min(s.a.y, s.b.y) - 1 ||
      p.y > std::max(s.a.y, s.b.y) + 1)
    return false;
  return side_of(s, orientation(s, p)) == 0;
}

Along along(Int128 num, Int128 den) {
  if (den < 0) {
    num = -num;
    den = -den;
  }
  return {num, den, static_cast<double>(num) / static_cast<double>(den)};
}

Along nearest_to(const StepSegment& s, StepPoint p) {
  const std::int64_t dx = s.dx(), dy = s.dy();
  return along(Int128{p.x - s.a.x} * dx + Int128{p.y - s.a.y} * dy, Int128{dx} * dx + Int128{dy} * dy);
}

Along crossing(const StepSegment& s, const StepSegment& edge, Int128 a, Int128 b) {
  return along(orientation(edge, s.a), b - a);
}

int compare(const Along& s, const Along& t) {
  if (s.value < t.value - kQuotientRounding) return -1;
  if (s.value > t.value + kQuotientRounding) return 1;
  if (s.den < kFactorLimit && t.den < kFactorLimit) {
    const Int128 p = s.num * t.den, q = t.num * s.den;
    return (p > q) - (p < q);
  }
  return compare_fractions(s.num, s.den, t.num, t.den);
}

void StepBox::extend(StepPoint p) {
  const auto x = static_cast<double>(p.x), y = static_cast<double>(p.y);
  extend(StepBox{x, y, x, y});
}

void StepBox::extend(const StepBox& other) {
  low_x = std::min(low_x, other.low_x);
  low_y = std::min(low_y, other.low_y);
  high_x = std::max(high_x, other.high_x);
  high_y = std::max(high_y, other.high_y);
}

StepBox box_of(const StepSegment& s) {
  StepBox box;
  box.extend(s.a);
  box.extend(s.b);
  return box;
}

EdgeTree::EdgeTree(std::span<const StepSegment> edges) : count_(edges.size()) {
  if (edges.empty()) return;
  levels_.emplace_back((edges.size() + kLeaf - 1) / kLeaf);
  for (std::size_t i = 0; i < edges.size(); ++i) levels_[0][i / kLeaf].extend(box_of(edges[i]));
  while (levels_.back().size() > 1) {
    const std::vector<StepBox>& below = levels_.back();
    std::vector<StepBox> above((below.size() + kChildren - 1) / kChildren);
    for (std::size_t i = 0; i < below.size(); ++i) above[i / kChildren].extend(below[i]);
    levels_.push_back(std::move(above));
  }
  box_ = levels_.back()[0];
}

}  // namespace ligne::svg
