/// A line is a bucket of strokes: those of one power of two of the length, whose middles lie in one column of that width,
/// and whose slopes and offsets round to the same values. In its column, and one column to either side, the strokes of a
/// bucket lie within half the tolerance of each other.
///
/// The strokes of a bucket are taken in the order of precedence, with the depths in the middle of the column. Each loses
/// what the strokes before it cover. The covered intervals are kept as their union, so n strokes take n log n steps.

#include "linework/overlaps/compared_strokes.hpp"

#include <algorithm>
#include <cmath>
#include <compare>
#include <iterator>
#include <map>
#include <span>
#include <utility>

#include "base/parallel.hpp"

namespace ligne {
namespace {

/// Strokes in a bucket above which it is a crowd. Fewer make few pairs. Adjustable.
constexpr std::size_t kFew = 8;
/// Steps of the offset in a tolerance, and of the slope in a tolerance over the length of a stroke.
constexpr double kOffsetSteps = 4, kSlopeSteps = 8;

/// The bucket of a stroke.
struct LineKey {
  std::int32_t level = 0;  ///< twice the binary logarithm of the length in tolerances; plus 1 if u is y
  std::int32_t column = 0, slope = 0, offset = 0;
  auto operator<=>(const LineKey&) const = default;
};

/// A stroke in the frame of its bucket.
struct PlacedStroke {
  double u_from, u_to;
  double middle;  ///< of the column
  LineKey key;

  PlacedStroke(const Stroke& s, double tolerance_steps) {
    const double dx = double(s.to.x) - s.from.x, dy = double(s.to.y) - s.from.y;
    const bool flat = std::abs(dx) >= std::abs(dy);
    const double slope = flat ? dy / dx : dx / dy;
    u_from = flat ? s.from.x : s.from.y, u_to = flat ? s.to.x : s.to.y;
    const int level = std::ilogb(page_length(s) / tolerance_steps);
    const double width = std::ldexp(tolerance_steps, level), column = std::floor((u_from + u_to) / (2 * width));
    middle = (column + 0.5) * width;
    const double offset = (flat ? s.from.y : s.from.x) + (middle - u_from) * slope;
    const auto rounded = [](double v) { return static_cast<std::int32_t>(std::floor(v)); };
    key = {2 * level + (flat ? 0 : 1), rounded(column), rounded(kSlopeSteps * slope * width / tolerance_steps),
           rounded(kOffsetSteps * offset / tolerance_steps)};
  }
};

/// A stroke in its bucket, by its number.
using Filed = std::pair<LineKey, std::uint32_t>;

/// The strokes that need a check, by bucket.
std::vector<Filed> filed_by_line(const std::vector<Stroke>& strokes, double tolerance_steps) {
  std::vector<Filed> filed;
  for (std::uint32_t i = 0; i < strokes.size(); ++i) {
    if (strokes[i].needs_overlap_check) filed.push_back({PlacedStroke(strokes[i], tolerance_steps).key, i});
  }
  parallel_sort(filed.begin(), filed.end());
  return filed;
}

/// The union of the intervals that strokes cover on one line.
class CoveredLine {
 public:
  explicit CoveredLine(double slack) : slack_(slack) {}

  /// Adds the interval of the stroke. Returns the parts of the stroke that were covered before.
  std::vector<CoveredPart> add(const Stroke& stroke, const PlacedStroke& placed) {
    const bool forward = placed.u_from <= placed.u_to;
    double u_from = std::min(placed.u_from, placed.u_to);
    Interval whole{std::max(placed.u_from, placed.u_to), forward ? stroke.from : stroke.to,
                   forward ? stroke.to : stroke.from};
    const double low = u_from, high = whole.to, extent = placed.u_to - placed.u_from;
    auto next = covered_.upper_bound(low);
    if (next != covered_.begin() && std::prev(next)->second.to + slack_ >= low) --next;
    std::vector<CoveredPart> parts;
    while (next != covered_.end() && next->first <= high + slack_) {
      const double from = std::max(low, next->first), to = std::min(high, next->second.to);
      if (to - from > slack_) {
        CoveredPart part{{(from - placed.u_from) / extent, next->second.p_from},
                         {(to - placed.u_from) / extent, next->second.p_to}};
        if (!forward) std::swap(part.from, part.to);
        parts.push_back(part);
      }
      if (next->first < u_from) u_from = next->first, whole.p_from = next->second.p_from;
      if (next->second.to > whole.to) whole.to = next->second.to, whole.p_to = next->second.p_to;
      next = covered_.erase(next);
    }
    covered_.emplace(u_from, whole);
    return parts;
  }

 private:
  struct Interval {
    double to;
    LatticePoint p_from, p_to;  ///< ends of strokes
  };
  double slack_;                        ///< smaller gaps count as covered
  std::map<double, Interval> covered_;  ///< by where they begin; they do not touch
};

/// Returns the rests of the strokes of one bucket.
std::vector<CutStroke> thin_line(const std::vector<Stroke>& strokes, std::span<const Filed> bucket,
                                 const OverlapTolerance& tolerance) {
  std::vector<std::pair<PrecedenceKey, std::uint32_t>> order;
  for (const auto& [bucket_key, number] : bucket) {
    const Stroke& s = strokes[number];
    const PlacedStroke p(s, tolerance.steps);
    order.emplace_back(precedence_key(s, (p.middle - p.u_from) / (p.u_to - p.u_from), tolerance.mm), number);
  }
  std::ranges::sort(order);
  CoveredLine line(tolerance.steps);
  std::vector<CutStroke> left;
  for (const auto& [key, number] : order) {
    const Stroke& s = strokes[number];
    std::vector<CoveredPart> parts = line.add(s, PlacedStroke(s, tolerance.steps));
    left.push_back({number, rests_of(s, parts, tolerance.steps)});
  }
  return left;
}

}  // namespace

std::vector<CutStroke> thin_crowded_lines(const std::vector<Stroke>& strokes, const OverlapTolerance& tolerance) {
  const std::vector<Filed> filed = filed_by_line(strokes, tolerance.steps);
  std::vector<CutStroke> cut;
  for (std::size_t begin = 0, end = 0; begin < filed.size(); begin = end) {
    while (end < filed.size() && filed[end].first == filed[begin].first) ++end;
    if (end - begin <= kFew) continue;
    std::ranges::move(thin_line(strokes, std::span(filed).subspan(begin, end - begin), tolerance), std::back_inserter(cut));
  }
  std::ranges::sort(cut, {}, &CutStroke::number);
  return cut;
}

}  // namespace ligne
