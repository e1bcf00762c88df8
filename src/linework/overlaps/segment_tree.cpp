#include "linework/overlaps/segment_tree.hpp"

#include <utility>

#include "base/no_index.hpp"

namespace ligne {
namespace {

constexpr double kRounding = 2;  ///< lattice steps; more than the rounding error of any position here

// Largest distance by which the ends of a common interval may seem to be swapped, in tolerances. An interval begins and
// ends at an end of one segment that is within the tolerance of the other. Each end is measured at right angles to one
// of the segments.
constexpr double kTurned = 2;
// Largest distance in v of a point of a short segment near the line, in tolerances: slopes on the page are at most 1.
constexpr double kBeside = 3;

// Bounds of a run, in tolerances: its gaps and the distance of its segments from its line; the distance from its line
// to a line on which the run lies. Gaps are shorter than any piece of a stroke, and the distances together are within
// the tolerance.
constexpr double kRunSlack = 0.25, kOnRun = 0.5;

// Adjustable: a node is rebuilt when one child has more than this part of the node's segments plus kFew.
constexpr double kUneven = 0.75;
constexpr std::uint32_t kFew = 16;

}  // namespace

FrameSegment::FrameSegment(const DirectionFrame& frame, LatticePoint from, LatticePoint to)
    : u0(frame.u(from)), v0(frame.v(from)), u1(frame.u(to)), v1(frame.v(to)) {
  if (u0 > u1) {
    std::swap(u0, u1);
    std::swap(v0, v1);
  }
  slope = u1 > u0 ? (v1 - v0) / (u1 - u0) : 0;
}

void SegmentTree::Node::add(const FrameSegment& s) {
  bounds.low_u.add(s.u0), bounds.low_v.add(s.v0);
  bounds.high_u.add(s.u1), bounds.high_v.add(s.v1);
  bounds.slope.add(s.slope);
  bounds.at_first.add(s.v_at(first_u)), bounds.at_last.add(s.v_at(last_u));
}

/// Range of v at u over the lines of all segments below. A line's value is a weighted mean of its values at two places;
/// one weight is negative outside of these places.
NumberRange SegmentTree::Node::v_at(double u) const {
  const double t = last_u > first_u ? (u - first_u) / (last_u - first_u) : 0;
  const auto [a, b] = std::pair(bounds.at_first, bounds.at_last);
  return {(1 - t) * (t <= 1 ? a.low : a.high) + t * (t >= 0 ? b.low : b.high),
          (1 - t) * (t <= 1 ? a.high : a.low) + t * (t >= 0 ? b.high : b.low)};
}

/// Whether the line of a segment below may be within the margin of this line at some u in the range. Two linear
/// functions bound the difference.
bool SegmentTree::Node::is_near(const FrameSegment& line, double u_low, double u_high, double margin) const {
  const NumberRange first = v_at(u_low), last = v_at(u_high);
  const double v_first = line.v_at(u_low), v_last = line.v_at(u_high);
  const bool above = first.low > v_first + margin && last.low > v_last + margin;
  const bool below = first.high < v_first - margin && last.high < v_last - margin;
  return !above && !below;
}

/// Largest distance in v at one u between a segment and the line where both are within the tolerance of each other. The
/// tolerance is measured at right angles to the steeper of them, and u is off by as much. Slopes of segments on the
/// page are at most 1.
double SegmentTree::margin_along(const FrameSegment& line, double slopes_apart) const {
  const double steepest = std::max(1.0, std::abs(line.slope) + std::abs(frame_.slope));
  return tolerance_ * (std::sqrt(1 + steepest * steepest) + slopes_apart) + kRounding;
}

bool SegmentTree::may_be_along(const Node& node, const FrameSegment& line) const {
  const Bounds& b = node.bounds;
  const double slack = kTurned * tolerance_ + kRounding, margin = margin_along(line, b.slope.farthest(line.slope));
  const double from = std::max(b.low_u.low, line.u0), to = std::min(b.high_u.high, line.u1);
  if (to - from < -slack) return false;
  const double last_from = std::clamp(std::max(b.low_u.high, line.u0), from, std::max(from, to + slack));
  const double first_to = std::clamp(std::min(b.high_u.low, line.u1), std::min(to, from - slack), to);
  return node.is_near(line, from, last_from, margin) && node.is_near(line, first_to, to, margin);
}

bool SegmentTree::may_be(const Node& node, const FrameSegment& line, Question question) const {
  const Bounds& b = node.bounds;
  const double margin = kBeside * tolerance_ + kRounding;
  if (line.u1 + margin < b.low_u.low || line.u0 - margin > b.high_u.high) return false;
  const auto [v_low, v_high] = std::minmax(line.v0, line.v1);
  const double low = std::min(b.low_v.low, b.high_v.low), high = std::max(b.low_v.high, b.high_v.high);
  if (v_high + margin < low || v_low - margin > high) return false;
  if (question == Question::along) return may_be_along(node, line);
  if (question == Question::beside) {
    const NumberRange first = node.v_at(line.u0), last = node.v_at(line.u1);
    return !(first.low > v_high + margin && last.low > v_high + margin) &&
           !(first.high < v_low - margin && last.high < v_low - margin);
  }
  const double du = line.u1 - line.u0, dv = line.v1 - line.v0;
  const double u = (b.low_u.low + b.high_u.high) / 2, v = (low + high) / 2;
  const double half_u = (b.high_u.high - b.low_u.low) / 2 + margin, half_v = (high - low) / 2 + margin;
  return std::abs((u - line.u0) * dv - (v - line.v0) * du) <= half_u * std::abs(dv) + half_v * std::abs(du);
}

/// may_be() for one segment of a leaf near the line.
bool SegmentTree::may_be(const FrameSegment& s, const FrameSegment& line, Question question) const {
  if (question == Question::along) {
    const double margin = margin_along(line, std::abs(s.slope - line.slope));
    const double from = std::max(s.u0, line.u0), to = std::min(s.u1, line.u1);
    return to - from >= -(kTurned * tolerance_ + kRounding) && std::abs(s.v_at(from) - line.v_at(from)) <= margin &&
           std::abs(s.v_at(to) - line.v_at(to)) <= margin;
  }
  if (question == Question::beside) {
    const double u = (line.u0 + line.u1) / 2, v = (line.v0 + line.v1) / 2;
    const double half = (line.u1 - line.u0) / 2 * std::abs(s.slope) + std::abs(line.v1 - line.v0) / 2;
    return std::abs(s.v_at(u) - v) <= half + kBeside * tolerance_ + kRounding;
  }
  if (question == Question::box) {
    const double du = line.u1 - line.u0, dv = line.v1 - line.v0;
    const double a = (s.u0 - line.u0) * dv - (s.v0 - line.v0) * du, b = (s.u1 - line.u0) * dv - (s.v1 - line.v0) * du;
    const double most = (kBeside * tolerance_ + kRounding) * (std::abs(du) + std::abs(dv));
    return std::min(a, b) <= most && std::max(a, b) >= -most;
  }
  return true;
}

std::size_t SegmentTree::visited_nodes(std::uint32_t number, const FrameSegment& line, Question question) const {
  const Node& node = nodes_[number];
  if (node.count == 0 || node.children == kNone || !may_be(node, line, question)) return 1;
  return 1 + visited_nodes(node.children, line, question) + visited_nodes(node.children + 1, line, question);
}

bool SegmentTree::is_on(const FrameSegment& line, const SegmentRun& run) const {
  const double most = kOnRun * tolerance_ - run.aside;
  return line.u0 <= run.u0 && run.u1 <= line.u1 && std::abs(line.v_at(run.u0) - run.v0) <= most &&
         std::abs(line.v_at(run.u1) - run.v1) <= most;
}

std::optional<SegmentRun> SegmentTree::run_of_leaf(const Node& node) const {
  std::vector<std::uint32_t> items;
  for (std::uint32_t i = node.first_item; i != kNone; i = items_[i].next) {
    if (items_[i].erased) continue;
    if (!orders_[i]) return std::nullopt;
    items.push_back(i);
  }
  std::sort(items.begin(), items.end(),
            [&](std::uint32_t a, std::uint32_t b) { return items_[a].segment.u0 < items_[b].segment.u0; });
  std::optional<SegmentRun> run;
  for (const std::uint32_t i : items) {
    const FrameSegment& s = items_[i].segment;
    const SegmentRun own{s.u0, s.v0, s.u1, s.v1, 0, items_[i].number, items_[i].number, *orders_[i]};
    run = i == items.front() ? own : SegmentRun::joined(*run, own, kRunSlack * tolerance_);
    if (!run) break;
  }
  return run;
}

void SegmentTree::find_run(std::uint32_t number) {
  const Node& node = nodes_[number];
  std::optional<SegmentRun>& run = runs_[number];
  if (node.children == kNone) {
    run = run_of_leaf(node);
    return;
  }
  const std::optional<SegmentRun>&a = runs_[node.children], &b = runs_[node.children + 1];
  if (nodes_[node.children].count == 0 || nodes_[node.children + 1].count == 0) {
    run = nodes_[node.children].count == 0 ? b : a;
  } else {
    run = a && b ? SegmentRun::joined(*a, *b, kRunSlack * tolerance_) : std::nullopt;
  }
}

void SegmentTree::find_runs_up_from(std::uint32_t node) {
  if (!has_runs_) return;
  for (; node != kNone; node = nodes_[node].parent) find_run(node);
}

std::uint32_t SegmentTree::insert(const FrameSegment& segment, std::uint32_t number,
                                  const std::optional<StrokeOrder>& order) {
  const auto place = static_cast<std::uint32_t>(items_.size());
  items_.push_back({segment, number, kNone, kNone, false});
  if (order && !has_runs_) {
    has_runs_ = true;
    runs_.resize(nodes_.size());
  }
  if (has_runs_) {
    orders_.resize(items_.size());
    orders_[place] = order;
  }
  if (nodes_.empty()) {
    nodes_.emplace_back();
    if (has_runs_) runs_.resize(nodes_.size());
    nodes_[0].first_u = segment.u0, nodes_[0].last_u = segment.u1;
  }
  std::uint32_t at = 0, uneven = kNone;
  for (;;) {
    Node& node = nodes_[at];
    node.add(segment);
    ++node.count;
    if (node.children == kNone) break;
    const std::uint32_t child = node.children + (node.key(segment) < node.divide ? 0 : 1);
    const bool has_grown = 2 * node.count >= 3 * node.count_when_built;
    if (uneven == kNone && has_grown && nodes_[child].count + 1 > kUneven * node.count + kFew) uneven = at;
    at = child;
  }
  Node& leaf = nodes_[at];
  items_[place].next = leaf.first_item;
  items_[place].leaf = at;
  leaf.first_item = place;
  if (uneven != kNone) {
    build_anew(uneven);
  } else if (++leaf.listed > 2 * std::max(kLeafSize, leaf.count_when_built)) {
    build_anew(at);
  }
  find_runs_up_from(items_[place].leaf);
  return place;
}

void SegmentTree::fill(const std::vector<std::pair<FrameSegment, std::uint32_t>>& segments) {
  if (segments.empty()) return;
  std::vector<std::uint32_t> items(segments.size());
  items_.reserve(segments.size());
  for (std::uint32_t i = 0; i < items.size(); ++i) {
    items_.push_back({segments[i].first, segments[i].second, kNone, kNone, false});
    items[i] = i;
  }
  nodes_.emplace_back();
  build(0, items);
}

void SegmentTree::erase(std::uint32_t place) {
  items_[place].erased = true;
  for (std::uint32_t at = items_[place].leaf; at != kNone; at = nodes_[at].parent) --nodes_[at].count;
  find_runs_up_from(items_[place].leaf);
}

std::uint32_t SegmentTree::new_children() {
  if (!free_.empty()) {
    const std::uint32_t pair = free_.back();
    free_.pop_back();
    return pair;
  }
  nodes_.resize(nodes_.size() + 2);
  if (has_runs_) runs_.resize(nodes_.size());
  return static_cast<std::uint32_t>(nodes_.size() - 2);
}

/// Collects the items below the node, and frees its child nodes.
void SegmentTree::collect(std::uint32_t node, std::vector<std::uint32_t>& items) {
  const std::uint32_t children = nodes_[node].children;
  if (children == kNone) {
    for (std::uint32_t i = nodes_[node].first_item; i != kNone; i = items_[i].next) {
      if (!items_[i].erased) items.push_back(i);
    }
    return;
  }
  collect(children, items);
  collect(children + 1, items);
  free_.push_back(children);
}

void SegmentTree::build_anew(std::uint32_t node) {
  std::vector<std::uint32_t> items;
  items.reserve(nodes_[node].count);
  collect(node, items);
  build(node, items);
}

/// Chooses the key by which the node divides its items: the quantity that separates them most. Returns false if all
/// keys are equal.
bool SegmentTree::choose_division(Node& node, std::span<const std::uint32_t> items, std::vector<double>& keys) const {
  double length = 0, sum_of_slopes = 0;
  NumberRange slope, u;
  for (const std::uint32_t i : items) {
    const FrameSegment& s = items_[i].segment;
    length += s.u1 - s.u0;
    sum_of_slopes += s.slope;
    slope.add(s.slope);
    u.add((s.u0 + s.u1) / 2);
  }
  const double n = static_cast<double>(items.size()), mean_slope = is_directed_ ? sum_of_slopes / n : 0;
  length /= n;
  NumberRange across;
  for (const std::uint32_t i : items) {
    const FrameSegment& s = items_[i].segment;
    across.add((s.v0 + s.v1 - mean_slope * (s.u0 + s.u1)) / 2);
  }
  const double by_slope = is_directed_ ? slope.extent() * length : 0, by_v = across.extent(), by_u = u.extent() - length;
  node.of_u = node.of_v = node.of_slope = 0;
  if (by_u > std::max(by_slope, by_v) || std::max(by_slope, by_v) <= 0) {
    node.of_u = 1;
  } else if (by_v >= by_slope) {
    node.of_v = 1;
    node.of_u = -mean_slope;
  } else {
    node.of_slope = 1;
  }
  keys.clear();
  for (const std::uint32_t i : items) keys.push_back(node.key(items_[i].segment));
  const auto middle = keys.begin() + static_cast<std::ptrdiff_t>(keys.size() / 2);
  std::nth_element(keys.begin(), middle, keys.end());
  node.divide = *middle;
  const auto least = std::min_element(keys.begin(), keys.end());
  if (*least < node.divide) return true;
  // Half of the items have the least key; the node divides above it.
  double next = std::numeric_limits<double>::infinity();
  for (const double key : keys) {
    if (key > node.divide) next = std::min(next, key);
  }
  node.divide = next;
  return std::isfinite(next);
}

void SegmentTree::build(std::uint32_t number, std::span<std::uint32_t> items) {
  std::vector<double> keys;
  Node node = nodes_[number];
  node.bounds = {};
  node.children = node.first_item = kNone;
  node.count = node.count_when_built = node.listed = static_cast<std::uint32_t>(items.size());
  NumberRange u;
  for (const std::uint32_t i : items) {
    u.add(items_[i].segment.u0);
    u.add(items_[i].segment.u1);
  }
  if (!items.empty()) node.first_u = u.low, node.last_u = u.high;
  for (const std::uint32_t i : items) node.add(items_[i].segment);
  if (items.size() <= kLeafSize || !choose_division(node, items, keys)) {
    for (const std::uint32_t i : items) {
      items_[i].next = std::exchange(node.first_item, i);
      items_[i].leaf = number;
    }
    nodes_[number] = node;
    if (has_runs_) find_run(number);
    return;
  }
  const auto second =
      std::partition(items.begin(), items.end(), [&](std::uint32_t i) { return node.key(items_[i].segment) < node.divide; });
  node.children = new_children();
  nodes_[number] = node;
  const auto first_count = static_cast<std::size_t>(second - items.begin());
  for (const std::uint32_t child : {node.children, node.children + 1}) nodes_[child].parent = number;
  build(node.children, items.first(first_count));
  build(node.children + 1, items.subspan(first_count));
  if (has_runs_) find_run(number);
}

}  // namespace ligne
