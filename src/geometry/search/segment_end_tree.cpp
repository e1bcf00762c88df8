#include "geometry/search/segment_end_tree.hpp"

#include <bit>
#include <utility>

#include "base/parallel.hpp"

namespace ligne {

SegmentEndTree::SegmentEndTree(const std::vector<PlacedEnd>& ends, double middle, double tolerance)
    : frame_(line_directions::frame_of(middle)), middle_(middle), reach_(tolerance + kRounding) {
  if (ends.empty()) return;
  double sum = 0;
  low_ = high_ = ends[0].p;
  for (const auto& [p, far, segment] : ends) {
    sum += length(p, far);
    low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y)};
    high_ = {std::max(high_.x, p.x), std::max(high_.y, p.y)};
  }
  const auto reach = static_cast<std::int32_t>(reach_) + 1;
  low_ = {low_.x - reach, low_.y - reach};
  high_ = {high_.x + reach, high_.y + reach};
  steps_per_direction_ = std::max(1.0, sum / static_cast<double>(ends.size()));
  std::vector<PointTree<4>::Point> points(ends.size());
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const auto& [p, far, segment] = ends[i];
    const auto half = static_cast<std::uint32_t>(length(p, far) / 2);  // u changes by at least as much
    points[i] = {rounded(frame_.u(p)), rounded(frame_.v(p)), rounded_direction(line_directions::direction(p, far)),
                 static_cast<std::int32_t>(std::bit_width(half))};
  }
  tree_ = PointTree<4>(points, kWeights);
  ends_.reserve(ends.size());
  for (const std::uint32_t i : tree_.order()) ends_.push_back(ends[i]);
}

/// The foot of an end's perpendicular on the line is at most the reach away from the end in x and in y. So it is at most the
/// reach away in u. In v, which is sheared by a slope of at most 1, it is at most twice the reach away.
SegmentEndTree::Line SegmentEndTree::line_of(const DirectedSegment& s) const {
  Line line{frame_.u(s.from), frame_.v(s.from), frame_.u(s.to), frame_.v(s.to)};
  if (line.u0 > line.u1) {
    std::swap(line.u0, line.u1);
    std::swap(line.v0, line.v1);
  }
  const auto [v_low, v_high] = std::minmax(line.v0, line.v1);
  if (line.u1 > line.u0) line.slope = (line.v1 - line.v0) / (line.u1 - line.u0);
  const double reach_v = (2 + std::abs(line.slope)) * reach_ + 1;
  line.v_low = (line.u1 > line.u0 ? line.v0 - line.slope * line.u0 : v_low) - reach_v;
  line.v_high = (line.u1 > line.u0 ? line.v0 - line.slope * line.u0 : v_high) + reach_v;
  line.direction = rounded_direction(s.direction);
  line.low = {rounded(line.u0 - reach_) - 1, rounded(v_low - 2 * reach_) - 1};
  line.high = {rounded(line.u1 + reach_) + 1, rounded(v_high + 2 * reach_) + 1};
  line.ends[0] = {rounded(line.u0), rounded(line.v0)};
  line.ends[1] = {rounded(line.u1), rounded(line.v1)};
  return line;
}

SegmentEnds::SegmentEnds(std::vector<PlacedEnd> ends, double tolerance)
    : longest_short_(kLongInTolerances * tolerance), size_(ends.size()) {
  std::array<std::vector<PlacedEnd>, kRanges + 1> by_direction;
  for (const PlacedEnd& end : ends) {
    const bool is_long = length(end.p, end.far) > longest_short_;
    by_direction[is_long ? range_of(line_directions::direction(end.p, end.far)) : kShort].push_back(end);
  }
  ends = {};
  parallel_tasks(trees_.size(), [&](std::size_t g) {
    const double middle = g == kShort ? 1 : (static_cast<double>(g) + 0.5) * line_directions::kCircle / kRanges;
    trees_[g] = SegmentEndTree(std::exchange(by_direction[g], {}), middle, tolerance);
  });
}

}  // namespace ligne
