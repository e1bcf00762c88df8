#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>
#include <vector>

#include "base/parallel.hpp"
#include "geometry/search/point_tree.hpp"
#include "linework/map/line_groups.hpp"
#include "linework/rules/rules.hpp"
#include "linework/stroke_geometry.hpp"

namespace ligne {
namespace {

/// Smallest cosine of the turn at a bridged gap, where ink hides it and where it is seen. Taste.
constexpr double kLeastCosine = 0.5, kStraightCosine = 0.94;
/// A bridge that is seen needs lines at least this many times as long as itself. Taste.
constexpr double kLongInGaps = 2;
/// Bridges of at least this many gaps are far: their lines must be straighter, and longer in proportion. Taste.
constexpr double kFarPartInGaps = 3, kFarCosine = 0.985, kLongInFar = 4;
/// Most rounds of joining: a joined line may have become long enough for another bridge.
constexpr int kMostBridgingRounds = 3;
/// Two ends fewer lattice steps apart define no direction, because each is rounded by itself.
constexpr double kRoundedSteps = 8;
/// A chain whose own ends are joined has at least this many gaps. Otherwise a speck would become a ring.
constexpr double kRingInGaps = 4;
/// The line behind an end does not block its bridge over this many times the clear distance.
constexpr double kOwnLineInClears = 4;
/// Factor above the rounding errors of a squared distance.
constexpr double kAbout = 1 + 0x1p-40;

/// A free end of an edge.
struct OpenEnd {
  std::uint32_t end;
  LatticePoint point{};
  double dx = 0, dy = 0, length = 0;  ///< direction and length of the whole stroke, towards the end
  double line_length = 0;             ///< length of its chain
  std::uint32_t chain = kNone;
  std::uint32_t nearest = kNone;  ///< nearest end to which it may be joined
};

class OpenEnds {
 public:
  OpenEnds(const LineMap& map, double gap, double wide) : gap_(gap), wide_(wide) {
    const ArcsOfPieces chains(map, Arcs(map, Arcs::kNoContacts));
    for (std::uint32_t end = 0; end < 2 * map.piece_count(); ++end) {
      if (!map.is_alive(end / 2) || !is_feature(map.piece(end / 2)) || !map.is_free(end)) continue;
      const Stroke& s = map.stroke_of(end / 2);
      const LatticePoint start = end % 2 == 0 ? s.to : s.from, p = map.point(end);
      const std::uint32_t chain = chains.of(end / 2);
      ends_.push_back({end, p, double(p.x) - start.x, double(p.y) - start.y, page_length(s), chains[chain].length, chain});
    }
    std::vector<TreePoint<2>> points;
    points.reserve(ends_.size());
    for (const OpenEnd& end : ends_) points.push_back({end.point.x, end.point.y});
    const PointTree<2> tree(points);
    parallel_blocks(ends_.size(), kSearchBlock, [&](std::size_t begin, std::size_t last) {
      for (std::size_t e = begin; e < last; ++e) ends_[e].nearest = nearest(static_cast<std::uint32_t>(e), tree);
    });
  }

  /// Pairs of ends that are each other's nearest.
  std::vector<std::pair<OpenEnd, OpenEnd>> pairs() const {
    std::vector<std::pair<OpenEnd, OpenEnd>> found;
    for (std::uint32_t e = 0; e < ends_.size(); ++e) {
      const std::uint32_t other = ends_[e].nearest;
      if (other != kNone && other > e && ends_[other].nearest == e) found.emplace_back(ends_[e], ends_[other]);
    }
    return found;
  }

 private:
  static double along(const OpenEnd& e, LatticePoint p) {
    return e.dx * (double(p.x) - e.point.x) + e.dy * (double(p.y) - e.point.y);
  }

  /// Whether the line goes on towards the point. A stroke shorter than the distance to it defines no direction.
  bool leads_to(const OpenEnd& e, LatticePoint p, double distance) const {
    if (distance <= kRoundedSteps) return true;
    const bool shows = distance >= gap_, far = distance >= kFarPartInGaps * gap_;
    if (e.length <= distance && !shows) return true;
    if (shows && e.line_length < (far ? kLongInFar : kLongInGaps) * distance) return false;
    return along(e, p) >= (far ? kFarCosine : shows ? kStraightCosine : kLeastCosine) * e.length * distance;
  }

  /// Whether leads_to() is false for all points of the box. A line may lead only to points in a cone. Where thousands
  /// of lines end side by side, nearly all ends lie outside of it.
  static bool leads_away(const OpenEnd& e, const PointBox<2>& box) {
    static const double sine = std::sqrt(1 - kLeastCosine * kLeastCosine);
    constexpr double kRounding = 1;  // lattice steps
    for (const double side : {-1.0, 1.0}) {
      // The inner normal of a side of the cone, as long as the stroke.
      const double nx = sine * e.dx - side * kLeastCosine * e.dy, ny = sine * e.dy + side * kLeastCosine * e.dx;
      const double x = (nx > 0 ? box.high[0] : box.low[0]) - double(e.point.x);
      const double y = (ny > 0 ? box.high[1] : box.low[1]) - double(e.point.y);
      if (nx * x + ny * y < -kRounding * e.length) return true;
    }
    return false;
  }

  std::uint32_t nearest(std::uint32_t e, const PointTree<2>& tree) const {
    const OpenEnd& end = ends_[e];
    const LatticePoint p = end.point;
    std::uint32_t best = kNone;
    double best_distance = wide_;
    const auto enter = [&](std::uint32_t node, double squared) {
      if (squared > kAbout * best_distance * best_distance) return false;
      const bool is_apart = end.length > wide_ && squared > kAbout * kRoundedSteps * kRoundedSteps;
      return !is_apart || !leads_away(end, tree.box(node));
    };
    const auto offer = [&](std::uint32_t o) {
      const OpenEnd& other = ends_[o];
      const LatticePoint q = other.point;
      const double away = length(p, q);
      if (o == e || away >= wide_ || away > best_distance || (away == best_distance && o > best)) return;
      if (end.chain == other.chain && end.line_length < kRingInGaps * gap_) return;
      if (!leads_to(end, q, away) || !leads_to(other, p, away)) return;
      best = o;
      best_distance = away;
    };
    tree.search_from(p, enter, [&](std::uint32_t first, std::uint32_t last) {
      for (std::uint32_t i = first; i < last; ++i) offer(tree.order()[i]);
    });
    return best;
  }

  double gap_, wide_;
  std::vector<OpenEnd> ends_;
};

std::size_t bridge_once(LineMap& map, const GapLimits& limits, const MakeSource& make_source) {
  const double gap = limits.gap_mm / map.step_mm(), clear = limits.clear_mm / map.step_mm();
  const auto pairs = OpenEnds(map, gap, limits.wide_mm / map.step_mm()).pairs();
  std::vector<std::pair<Stroke, std::size_t>> bridges;
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const auto& [a, b] = pairs[k];
    const Stroke bridge = bridge_between(map, a.end, b.end, (a.line_length < b.line_length ? b.end : a.end) / 2);
    std::vector<std::uint32_t> own = map.line_back(a.end, kOwnLineInClears * clear);
    std::ranges::copy(map.line_back(b.end, kOwnLineInClears * clear), std::back_inserter(own));
    const auto blocks = [&](std::uint32_t p) {
      return std::ranges::find(own, p) == own.end() && !part_near(bridge, map.piece(p), clear).empty();
    };
    const bool shows = length(a.point, b.point) >= gap;
    if (!shows || !map.near(bridge.from, bridge.to, clear, blocks)) bridges.emplace_back(bridge, k);
  }
  for (const auto& [bridge, k] : bridges) map.add(bridge, pairs[k].first.end, pairs[k].second.end, make_source);
  return bridges.size();
}

}  // namespace

Stroke bridge_between(const LineMap& map, std::uint32_t a, std::uint32_t b, std::uint32_t like) {
  const Stroke &s = map.piece(a / 2), &t = map.piece(b / 2);
  const bool a_from = a % 2 == 0, b_from = b % 2 == 0;
  Stroke bridge = map.piece(like);
  bridge.from = map.point(a);
  bridge.to = map.point(b);
  bridge.z_from = a_from ? s.z_from : s.z_to;
  bridge.z_to = b_from ? t.z_from : t.z_to;
  bridge.w_from = a_from ? s.w_from : s.w_to;
  bridge.w_to = b_from ? t.w_from : t.w_to;
  return bridge;
}

std::size_t bridge_gaps(LineMap& map, const GapLimits& limits, const MakeSource& make_source) {
  std::size_t count = 0;
  for (int round = 0; round < kMostBridgingRounds; ++round) {
    const std::size_t added = bridge_once(map, limits, make_source);
    count += added;
    if (added == 0) break;
  }
  return count;
}

}  // namespace ligne
