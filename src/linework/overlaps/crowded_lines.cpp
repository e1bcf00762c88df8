/// A line is a bucket of strokes: those of one power of two of the length, whose middles lie in one column of that width,
/// and whose slopes and offsets round to the same values. In its column, and one column to either side, the strokes of a
/// bucket lie within half the tolerance of each other.
///
/// The strokes of a bucket are taken in the order of precedence, with the depths in the middle of the column. Each loses
/// what the strokes before it cover. The covered intervals are kept as their union, so n strokes take n log n steps.

#include "linework/overlaps/crowded_lines.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <compare>
#include <iterator>
#include <map>
#include <span>
#include <tuple>
#include <utility>

#include "base/hash.hpp"
#include "base/parallel.hpp"
#include "linework/overlaps/precedence.hpp"
#include "linework/overlaps/stroke_directions.hpp"

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

  std::uint64_t hash() const {
    std::uint64_t h = 0;
    for (const std::int32_t n : {level, column, slope, offset}) h = extend_hash(h, static_cast<std::uint32_t>(n));
    return mix_bits(h);
  }
};

/// A stroke in the frame of its bucket.
struct PlacedStroke {
  double u_from, u_to;
  double middle;  ///< of the column
  LineKey key;

  PlacedStroke(const Stroke& s, double tolerance_steps) {
    const auto [frame, slope] = [&] {
      const double dx = double(s.to.x) - s.from.x, dy = double(s.to.y) - s.from.y;
      const bool flat = std::abs(dx) >= std::abs(dy);
      return std::pair(DirectionFrame{flat}, flat ? dy / dx : dx / dy);
    }();
    u_from = frame.u(s.from), u_to = frame.u(s.to);
    const int level = std::ilogb(page_length(s) / tolerance_steps);
    const double width = std::ldexp(tolerance_steps, level), column = std::floor((u_from + u_to) / (2 * width));
    middle = (column + 0.5) * width;
    const double offset = frame.v(s.from) + (middle - u_from) * slope;
    const auto rounded = [](double v) { return static_cast<std::int32_t>(std::floor(v)); };
    key = {2 * level + (frame.flat ? 0 : 1), rounded(column), rounded(kSlopeSteps * slope * width / tolerance_steps),
           rounded(kOffsetSteps * offset / tolerance_steps)};
  }
};

/// A stroke in a bucket that may be crowded.
struct Filed {
  LineKey key;
  std::uint32_t stroke;
  auto operator<=>(const Filed&) const = default;
};

/// The strokes in buckets with more than kFew strokes, and a few others, by bucket. A table of counters by hash finds these
/// buckets, so that few strokes are sorted.
std::vector<Filed> file_crowds(const std::vector<Stroke>& strokes, double tolerance_steps) {
  std::vector<std::uint32_t> hashes(strokes.size());
  parallel_blocks(strokes.size(), kShortWorkBlock, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (strokes[i].needs_overlap_check)
        hashes[i] = static_cast<std::uint32_t>(PlacedStroke(strokes[i], tolerance_steps).key.hash());
    }
  });
  std::vector<std::uint8_t> count(std::bit_ceil(4 * strokes.size() + 1), 0);
  const std::size_t mask = count.size() - 1;
  for (std::size_t i = 0; i < strokes.size(); ++i) {
    std::uint8_t& n = count[hashes[i] & mask];
    if (strokes[i].needs_overlap_check && n <= kFew) ++n;
  }
  std::vector<Filed> filed;
  for (std::uint32_t i = 0; i < strokes.size(); ++i) {
    if (strokes[i].needs_overlap_check && count[hashes[i] & mask] > kFew)
      filed.push_back({PlacedStroke(strokes[i], tolerance_steps).key, i});
  }
  parallel_sort(filed.begin(), filed.end());
  return filed;
}

/// The union of the intervals that strokes cover on one line.
class CoveredLine {
 public:
  explicit CoveredLine(double slack) : slack_(slack) {}

  /// Adds the interval of the stroke. Returns the parts of the stroke that were covered before.
  std::vector<CoveredPart> add(const Stroke& stroke, const PlacedStroke& placed);

 private:
  struct Interval {
    double to;
    LatticePoint p_from, p_to;  ///< ends of strokes
  };
  double slack_;                        ///< smaller gaps count as covered
  std::map<double, Interval> covered_;  ///< by where they begin; they do not touch
};

std::vector<CoveredPart> CoveredLine::add(const Stroke& stroke, const PlacedStroke& placed) {
  const bool forward = placed.u_from <= placed.u_to;
  double u_from = std::min(placed.u_from, placed.u_to);
  Interval whole{std::max(placed.u_from, placed.u_to), forward ? stroke.from : stroke.to, forward ? stroke.to : stroke.from};
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

/// Returns the rests of the strokes of one bucket.
std::vector<CutStroke> thin_line(const std::vector<Stroke>& strokes, std::span<const Filed> bucket,
                                 const OverlapTolerance& tolerance) {
  struct Entry {
    std::size_t rank;
    double depth;
    std::uint32_t place;
  };
  std::vector<PlacedStroke> placed;
  std::vector<Entry> order;
  for (std::uint32_t i = 0; i < bucket.size(); ++i) {
    const Stroke& s = strokes[bucket[i].stroke];
    const PlacedStroke& p = placed.emplace_back(s, tolerance.steps);
    const double z = depth(s, (p.middle - p.u_from) / (p.u_to - p.u_from));
    order.push_back({rank(s), rounded_depth(z, tolerance.mm), i});
  }
  std::sort(order.begin(), order.end(), [](const Entry& a, const Entry& b) {
    return std::tie(a.rank, a.depth, a.place) < std::tie(b.rank, b.depth, b.place);
  });
  CoveredLine line(tolerance.steps);
  std::vector<CutStroke> left;
  for (const Entry& e : order) {
    const Stroke& s = strokes[bucket[e.place].stroke];
    std::vector<CoveredPart> parts = line.add(s, placed[e.place]);
    left.push_back({bucket[e.place].stroke});
    append_rests(s, parts, tolerance.steps, left.back().rests);
  }
  return left;
}

}  // namespace

void thin_crowded_lines(ComparedStrokes& strokes, const OverlapTolerance& tolerance) {
  const std::vector<Filed> filed = file_crowds(strokes.strokes, tolerance.steps);
  std::vector<std::pair<std::size_t, std::size_t>> crowds;
  for (std::size_t begin = 0, end = 0; begin < filed.size(); begin = end) {
    while (end < filed.size() && filed[end].key == filed[begin].key) ++end;
    if (end - begin > kFew) crowds.emplace_back(begin, end);
  }
  std::vector<std::vector<CutStroke>> left(crowds.size());
  parallel_for(crowds.size(), [&](std::size_t c) {
    const auto [begin, end] = crowds[c];
    left[c] = thin_line(strokes.strokes, std::span(filed).subspan(begin, end - begin), tolerance);
  });
  for (const std::vector<CutStroke>& of_line : left) strokes.replace(of_line);
}

}  // namespace ligne
