#include "scene/heal/edge_tree.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>

#include "geometry/nearest_on_segment.hpp"

namespace ligne {
namespace {

/// Largest number of segments in a leaf. Adjustable.
constexpr std::uint32_t kLeaf = 4;

/// The point of a segment nearest to another point.
struct FootPoint {
  double at;      ///< from 0 to 1 along the segment
  double square;  ///< squared distance
};

FootPoint foot(const EdgeTree::Segment& s, const Point3& p) {
  const Point3 along = s.b - s.a;
  const double at = nearest_on_segment(p, s.a, s.b);
  const Point3 away = p - (s.a + at * along);
  return {at, glm::dot(away, away)};
}

/// Factor on a squared distance that exceeds all rounding: a larger square means a larger distance.
constexpr double kSquareSlack = 1 + 8 * std::numeric_limits<double>::epsilon();

double square_limit(double distance) { return kSquareSlack * distance * distance; }

/// Keeps the nearest of the segments tested.
class NearestSearch {
 public:
  NearestSearch(const Point3& p, double distance, FunctionRef<bool(std::uint32_t, double)> accept)
      : p_(p), accept_(accept), limit_(square_limit(distance)) {
    best_.distance = distance;
  }

  const NearestPoint& best() const { return best_; }
  bool is_beyond(double square) const { return square > limit_; }
  void look_at(std::uint32_t number, const EdgeTree::Segment& segment) {
    const auto [at, square] = foot(segment, p_);
    if (is_beyond(square)) return;
    const double d = std::sqrt(square);
    const bool is_first = best_.segment == NearestPoint{}.segment;
    if (d > best_.distance || (d == best_.distance && !is_first) || !accept_(number, at)) return;
    best_ = {number, at, d};
    limit_ = square_limit(d);
  }

 private:
  Point3 p_;
  FunctionRef<bool(std::uint32_t, double)> accept_;
  NearestPoint best_;
  double limit_;
};

/// Smallest width of a cell: in mean lengths of a segment, and in reaches. Adjustable.
constexpr double kSideInLengths = 2, kSideInReaches = 4;
/// Largest number of cells along the longest side of the box: each of a cell's three numbers has 21 bits.
constexpr double kMostCells = 0x1p20;
/// Bounds on the rounding errors of a cell number, relative to the side of a cell, and of a point, relative to the
/// largest coordinate.
constexpr double kCellRounding = 0x1p-20, kRounding = 0x1p-48;

}  // namespace

EdgeTree::EdgeTree(std::vector<Segment> segments) : segments_(std::move(segments)), order_(segments_.size()) {
  std::iota(order_.begin(), order_.end(), 0u);
  if (segments_.empty()) return;
  // Ranges are halved, so the sizes at one depth differ by at most one.
  std::size_t leaves = 1;
  while (leaves * kLeaf < segments_.size()) leaves *= 2;
  boxes_.resize(2 * leaves - 1);
  std::vector<Middle> middles(segments_.size());
  build(0, 0, static_cast<std::uint32_t>(segments_.size()), middles);
}

void EdgeTree::build(std::size_t node, std::uint32_t begin, std::uint32_t end, std::vector<Middle>& middles) {
  Box box{segments_[order_[begin]].a, segments_[order_[begin]].a};
  for (std::uint32_t k = begin; k < end; ++k) {
    const Segment& s = segments_[order_[k]];
    box = {glm::min(box.low, glm::min(s.a, s.b)), glm::max(box.high, glm::max(s.a, s.b))};
  }
  boxes_[node] = box;
  if (2 * node + 2 >= boxes_.size()) return;
  const Point3 size = box.high - box.low;
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const std::uint32_t half = begin + (end - begin) / 2;
  for (std::uint32_t k = begin; k < end; ++k) {
    const Segment& s = segments_[order_[k]];
    middles[k] = {s.a[axis] + s.b[axis], order_[k]};
  }
  std::nth_element(middles.begin() + begin, middles.begin() + half, middles.begin() + end,
                   [](const Middle& a, const Middle& b) { return a.at < b.at || (a.at == b.at && a.segment < b.segment); });
  for (std::uint32_t k = begin; k < end; ++k) order_[k] = middles[k].segment;
  build(2 * node + 1, begin, half, middles);
  build(2 * node + 2, half, end, middles);
}

NearestPoint EdgeTree::nearest(const Point3& p, double distance, FunctionRef<bool(std::uint32_t, double)> accept) const {
  NearestSearch search(p, distance, accept);
  if (segments_.empty()) return search.best();
  struct Range {
    std::size_t node;
    std::uint32_t begin, end;
    double square;
  };
  std::array<Range, 64> stack;  // one entry per level; the depth is at most that of a 32-bit count
  std::size_t top = 0;
  const auto push = [&](const Range& range) {
    if (!search.is_beyond(range.square)) stack[top++] = range;
  };
  push({0, 0, static_cast<std::uint32_t>(segments_.size()), boxes_[0].square_distance(p)});
  std::size_t visits = 0;
  while (top > 0) {
    const Range range = stack[--top];
    if (search.is_beyond(range.square)) continue;
    const std::size_t first = 2 * range.node + 1;
    if (first + 1 < boxes_.size()) {
      const std::uint32_t half = range.begin + (range.end - range.begin) / 2;
      const double left = boxes_[first].square_distance(p), right = boxes_[first + 1].square_distance(p);
      if (left <= right) {
        push({first + 1, half, range.end, right});
        push({first, range.begin, half, left});
      } else {
        push({first, range.begin, half, left});
        push({first + 1, half, range.end, right});
      }
      continue;
    }
    for (std::uint32_t k = range.begin; k < range.end; ++k) {
      if (++visits > kMostVisits) return search.best();
      search.look_at(order_[k], segments_[order_[k]]);
    }
  }
  return search.best();
}

NearestPoint nearest_among(std::span<const EdgeTree::Segment> segments, std::span<const std::uint32_t> listed,
                           const Point3& p, double distance, FunctionRef<bool(std::uint32_t, double)> accept) {
  NearestSearch search(p, distance, accept);
  for (const std::uint32_t s : listed) search.look_at(s, segments[s]);
  return search.best();
}

SegmentCells::SegmentCells(std::span<const EdgeTree::Segment> segments, double reach) {
  choose_cells(segments, reach);
  slots_ = std::bit_ceil(4 * segments.size() + 1);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> listed;  // slot, segment
  listed.reserve(4 * segments.size());
  for (std::uint32_t s = 0; s < segments.size(); ++s) {
    // Long segments are cut into parts, so that their boxes are no larger than a cell.
    const auto& [a, b] = segments[s];
    const Point3 along = b - a;
    const double parts = std::ceil(std::max(1.0, glm::length(along) / side_));
    for (double part = 0; part < parts; ++part) {
      const Point3 from = a + part / parts * along, to = a + (part + 1) / parts * along;
      const Cell low = cell_of(glm::max(glm::min(from, to) - margin_, low_)), high = cell_of(glm::max(from, to) + margin_);
      for (std::int64_t x = low.x; x <= high.x; ++x) {
        for (std::int64_t y = low.y; y <= high.y; ++y) {
          for (std::int64_t z = low.z; z <= high.z; ++z) {
            listed.emplace_back(static_cast<std::uint32_t>(slot_of({x, y, z})), s);
          }
        }
      }
    }
  }
  listed_ = {slots_, [&](const auto& put) {
               for (const auto& [slot, segment] : listed) put(slot, segment);
             }};
}

void SegmentCells::choose_cells(std::span<const EdgeTree::Segment> segments, double reach) {
  if (segments.empty()) return;
  Point3 high = low_ = segments[0].a;
  double length = 0;
  for (const EdgeTree::Segment& s : segments) {
    low_ = glm::min(low_, glm::min(s.a, s.b));
    high = glm::max(high, glm::max(s.a, s.b));
    length += glm::distance(s.a, s.b);
  }
  const Point3 size = high - low_, largest = glm::max(glm::abs(low_), glm::abs(high));
  const double longest = std::max({size.x, size.y, size.z});
  side_ = std::max({kSideInLengths * length / double(segments.size()), kSideInReaches * reach, longest / kMostCells});
  if (!(side_ > 0)) side_ = 1;  // all at one place
  margin_ = reach + kCellRounding * side_ + kRounding * std::max({largest.x, largest.y, largest.z});
}

}  // namespace ligne
