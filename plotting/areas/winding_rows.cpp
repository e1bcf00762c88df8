#include "areas/winding_rows.hpp"

#include <algorithm>
#include <cmath>

namespace ligne::svg {
namespace {

/// Smallest distance of an anchor from all edges, in lattice steps: many times the rounding of vertices, which is one
/// step.
constexpr double kClear = 16;
/// Smallest distance of neighbouring lines, in lattice steps: most places between two lines are far from both.
constexpr double kLeastDistance = 64;
/// Most lines tried, going back from the begin of a stroke. Adjustable.
constexpr int kTries = 8;

double coordinate(StepPoint p, int axis) { return static_cast<double>(axis == 0 ? p.x : p.y); }

}  // namespace

WindingRows::WindingRows(std::span<const StepSegment> edges, std::span<const std::int32_t> windings, const StepBox& box)
    : lines_{make_lines(0, edges, windings, box), make_lines(1, edges, windings, box)} {}

WindingRows::Lines WindingRows::make_lines(int axis, std::span<const StepSegment> edges,
                                           std::span<const std::int32_t> windings, const StepBox& box) {
  const auto count = static_cast<double>(edges.size());
  const double low = axis == 0 ? box.low_x : box.low_y, high = axis == 0 ? box.high_x : box.high_y;
  double extents = high - low;
  for (const StepSegment& edge : edges) extents += std::abs(coordinate(edge.b, axis) - coordinate(edge.a, axis));
  Lines lines;
  // Halfway between steps, so that no vertex lies on a line.
  lines.distance = std::max(std::ceil(extents / count), kLeastDistance);
  lines.first = low + 0.5;
  lines.count = static_cast<std::size_t>((high - low) / lines.distance) + 1;

  std::vector<NearPart> parts;
  for (std::size_t i = 0; i < edges.size(); ++i) add_near_parts(axis, lines, edges[i], windings[i], parts);
  std::sort(parts.begin(), parts.end(),
            [](const NearPart& p, const NearPart& q) { return p.line != q.line ? p.line < q.line : p.high < q.high; });
  lines.begin.assign(lines.count + 1, 0);
  for (const NearPart& part : parts) ++lines.begin[part.line + 1];
  for (std::size_t i = 0; i < lines.count; ++i) lines.begin[i + 1] += lines.begin[i];
  for (std::size_t i = 0; i < lines.count; ++i) {
    std::int32_t sum = 0;
    for (std::size_t k = lines.begin[i]; k < lines.begin[i + 1]; ++k) {
      lines.lows.push_back(parts[k].low);
      lines.highs.push_back(parts[k].high);
      lines.windings.push_back(sum += parts[k].winding);
    }
    std::sort(lines.lows.begin() + lines.begin[i], lines.lows.end());
  }
  return lines;
}

/// Adds, for each line, the part of the edge that lies nearer than kClear to it, grown by kClear at both ends.
void WindingRows::add_near_parts(int axis, const Lines& lines, const StepSegment& edge, std::int32_t winding,
                                 std::vector<NearPart>& parts) {
  const double a = coordinate(edge.a, axis), b = coordinate(edge.b, axis);
  const double from = coordinate(edge.a, 1 - axis), to = coordinate(edge.b, 1 - axis);
  const double low = std::min(a, b) - kClear - lines.first, high = std::max(a, b) + kClear - lines.first;
  const auto last = std::min(static_cast<std::size_t>(std::max(high / lines.distance, 0.0)), lines.count - 1);
  for (auto i = static_cast<std::size_t>(std::ceil(std::max(low / lines.distance, 0.0))); i <= last; ++i) {
    const double at = lines.first + lines.distance * static_cast<double>(i);
    if (at > std::max(a, b) + kClear) break;
    const auto where = [&](double beside) {
      return a == b ? to : from + (to - from) * std::clamp((beside - a) / (b - a), 0.0, 1.0);
    };
    const double p = a == b ? from : where(at - kClear), q = where(at + kClear);
    // A walk along the line gains the winding where it crosses the edge from the right to the left of the edge.
    const bool crosses = (a < at) != (b < at), gains = (axis == 1) == (a > b);
    parts.push_back({static_cast<std::uint32_t>(i), std::min(p, q) - kClear, std::max(p, q) + kClear,
                     !crosses ? 0
                     : gains  ? winding
                              : -winding});
  }
}

/// The winding at the place on the line; nothing if the place lies within a part of an edge.
std::optional<std::int32_t> WindingRows::winding_at(const Lines& lines, std::size_t line, double place) {
  const auto range = [&](const std::vector<double>& all) {
    return std::span(all).subspan(lines.begin[line], lines.begin[line + 1] - lines.begin[line]);
  };
  const std::span<const double> lows = range(lines.lows), highs = range(lines.highs);
  const auto begun = std::upper_bound(lows.begin(), lows.end(), place) - lows.begin();
  const auto ended = std::lower_bound(highs.begin(), highs.end(), place) - highs.begin();
  if (begun != ended) return std::nullopt;
  return ended == 0 ? 0 : lines.windings[lines.begin[line] + static_cast<std::size_t>(ended) - 1];
}

std::optional<Anchor> WindingRows::find_before(const StepSegment& stroke) const {
  const int axis = std::abs(stroke.dx()) > std::abs(stroke.dy()) ? 0 : 1;
  const Lines& lines = lines_[static_cast<std::size_t>(axis)];
  const double a = coordinate(stroke.a, axis), d = coordinate(stroke.b, axis) - a;
  const double along = coordinate(stroke.a, 1 - axis), slope = (coordinate(stroke.b, 1 - axis) - along) / d;
  const double in_distances = (a - lines.first) / lines.distance;
  double line = d > 0 ? std::floor(in_distances) : std::ceil(in_distances);
  for (int tries = 0; tries < kTries; ++tries, line -= std::copysign(1.0, d)) {
    if (line < 0 || line >= static_cast<double>(lines.count)) return std::nullopt;
    const double back = lines.first + lines.distance * line - a;
    const std::optional<std::int32_t> winding = winding_at(lines, static_cast<std::size_t>(line), along + slope * back);
    if (winding) return Anchor{back / d, *winding};
  }
  return std::nullopt;
}

}  // namespace ligne::svg
