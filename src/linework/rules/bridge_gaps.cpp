/// Two rules that join ends of lines by bridges: bridge_gaps() joins free ends that point at each other, close_outlines()
/// joins outlines where an outline of a body is not drawn.

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

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

/// Length of the outline behind an end on which it looks for no other end, in longest bridges.
constexpr double kOwnLineInBridges = 2;
/// Parts at both ends of a bridge of outlines that may lie beside other lines, in clear distances.
constexpr double kMeetingInClears = 2;
/// Least cosine of the turn from an outline into its bridge: 120 degrees. Outlines that end side by side are not joined.
constexpr double kLeastBridgeCosine = -0.5;

/// A bridge between two ends, with the properties of the line that ends at `like`.
struct Bridge {
  std::uint32_t from, to, like;
  double length;
};

Stroke stroke_of(const LineMap& map, const Bridge& bridge) {
  return stroke_between(map.piece(bridge.like / 2), map.tip(bridge.from), map.tip(bridge.to));
}

/// Whether a line within `clear` lattice steps blocks a stroke. The pieces of `own` do not.
bool is_blocked(LineMap& map, const Stroke& stroke, double clear, const std::vector<std::uint32_t>& own) {
  return map.near(stroke.from, stroke.to, clear, [&](std::uint32_t p) {
    return std::ranges::find(own, p) == own.end() && !part_near(stroke, map.piece(p), clear).empty();
  });
}

/// A free end of an edge.
struct OpenEnd {
  std::uint32_t end;
  LatticePoint point{};
  Point2 along{0, 0};           ///< vector of the whole stroke, towards the end
  double length = 0;            ///< of the whole stroke
  double line_length = 0;       ///< length of its chain; infinite if no rule asks how long it is
  std::uint32_t chain = kNone;  ///< its lowest piece, if the length is known
};

class OpenEnds {
 public:
  OpenEnds(const LineMap& map, double gap, double wide) : map_(map), gap_(gap), wide_(wide) {
    const double most = std::max(kRingInGaps * gap, std::max(kLongInFar, kLongInGaps) * wide);
    std::vector<TreePoint<2>> points;
    for (std::uint32_t end = 0; end < 2 * map.piece_count(); ++end) {
      if (!map.is_alive(end / 2) || !is_feature(map.piece(end / 2)) || !map.is_free(end)) continue;
      const Stroke& s = map.stroke_of(end / 2);
      const LatticePoint p = map.point(end);
      const Arcs::Arc chain = chain_from(map, end, most);
      const bool is_long = chain.pieces.empty();
      ends_.push_back({end, p, offset(tip(s, end ^ 1).p, p), page_length(s), is_long ? Arcs::kAnyLength : chain.length,
                       is_long ? kNone : chain.pieces.front()});
      points.push_back({p.x, p.y});
    }
    tree_ = PointTree<2>(points);
  }

  /// Bridges between ends that are each other's nearest.
  std::vector<Bridge> bridges() const {
    std::vector<std::uint32_t> nearest_to(ends_.size());
    parallel_blocks(ends_.size(), kEndBlock, [&](std::size_t begin, std::size_t last) {
      for (std::size_t e = begin; e < last; ++e) nearest_to[e] = nearest(static_cast<std::uint32_t>(e));
    });
    std::vector<Bridge> found;
    for (std::uint32_t e = 0; e < ends_.size(); ++e) {
      const std::uint32_t other = nearest_to[e];
      if (other == kNone || other < e || nearest_to[other] != e) continue;
      const OpenEnd &a = ends_[e], &b = ends_[other];
      found.push_back({a.end, b.end, is_shorter(a, b) ? b.end : a.end, length(a.point, b.point)});
    }
    return found;
  }

 private:
  bool is_shorter(const OpenEnd& a, const OpenEnd& b) const {
    if (a.line_length < Arcs::kAnyLength || b.line_length < Arcs::kAnyLength) return a.line_length < b.line_length;
    return chain_from(map_, a.end).length < chain_from(map_, b.end).length;
  }

  /// Whether the line goes on towards the point. A stroke shorter than the distance to it defines no direction.
  bool leads_to(const OpenEnd& e, LatticePoint p, double distance) const {
    if (distance <= kRoundedSteps) return true;
    const bool shows = distance >= gap_, far = distance >= kFarPartInGaps * gap_;
    if (e.length <= distance && !shows) return true;
    if (shows && e.line_length < (far ? kLongInFar : kLongInGaps) * distance) return false;
    const double cosine = far ? kFarCosine : shows ? kStraightCosine : kLeastCosine;
    return glm::dot(e.along, offset(e.point, p)) >= cosine * e.length * distance;
  }

  /// Whether leads_to() is false for all points of the box, which are farther away than the root of `squared`. A line may
  /// lead only to points in a cone. Where thousands of lines end side by side, nearly all ends lie outside of it.
  bool leads_away(const OpenEnd& e, const PointBox<2>& box, double squared) const {
    static const auto sine = [](double cosine) { return std::sqrt(1 - cosine * cosine); };
    static const std::array<Point2, 3> cones{
        {{kLeastCosine, sine(kLeastCosine)}, {kStraightCosine, sine(kStraightCosine)}, {kFarCosine, sine(kFarCosine)}}};
    const auto is_beyond = [&](double distance) { return squared > kAbout * distance * distance; };
    const Point2 cone = cones[is_beyond(kFarPartInGaps * gap_) ? 2 : is_beyond(gap_) ? 1 : 0];
    constexpr double kRounding = 1;  // lattice steps
    for (const double side : {-1.0, 1.0}) {
      // The inner normal of a side of the cone, as long as the stroke.
      const Point2 n = cone.y * e.along + side * cone.x * Point2(-e.along.y, e.along.x);
      const Point2 corner(n.x > 0 ? box.high[0] : box.low[0], n.y > 0 ? box.high[1] : box.low[1]);
      if (glm::dot(n, corner - Point2(e.point.x, e.point.y)) < -kRounding * e.length) return true;
    }
    return false;
  }

  /// The nearest end to which an end may be joined, or kNone.
  std::uint32_t nearest(std::uint32_t e) const {
    const OpenEnd& end = ends_[e];
    const LatticePoint p = end.point;
    std::uint32_t best = kNone;
    // A longer bridge than a gap needs a line that is longer in proportion.
    double best_distance = std::clamp(kAbout * end.line_length / kLongInGaps, std::min(gap_, wide_), wide_);
    const auto enter = [&](std::uint32_t node, double squared) {
      if (squared > kAbout * best_distance * best_distance) return false;
      const bool is_apart = end.length > wide_ && squared > kAbout * kRoundedSteps * kRoundedSteps;
      return !is_apart || !leads_away(end, tree_.box(node), squared);
    };
    tree_.search_from(p, enter, [&](std::uint32_t place) {
      const std::uint32_t o = tree_.order()[place];
      const OpenEnd& other = ends_[o];
      const LatticePoint q = other.point;
      const double away = length(p, q);
      if (o == e || away >= wide_ || away > best_distance || (away == best_distance && o > best)) return;
      if (end.chain == other.chain && end.line_length < kRingInGaps * gap_) return;
      if (!leads_to(end, q, away) || !leads_to(other, p, away)) return;
      best = o;
      best_distance = away;
    });
    return best;
  }

  const LineMap& map_;
  double gap_, wide_;
  std::vector<OpenEnd> ends_;
  PointTree<2> tree_;
};

class OutlineGaps {
 public:
  OutlineGaps(LineMap& map, const GapLimits& limits, const IsOutline& is_outline)
      : map_(map), runs_along_(is_outline), wide_(limits.wide_mm / map.step_mm()), clear_(limits.clear_mm / map.step_mm()) {}

  /// The bridges from free ends to their nearest ends along missing outlines, the shortest first.
  std::vector<Bridge> bridges() {
    std::vector<Bridge> found;
    for (std::uint32_t end = 0; end < 2 * map_.piece_count(); ++end) {
      if (!map_.is_alive(end / 2) || !is_outline(end / 2) || !map_.is_free(end) || touches(end)) continue;
      const Bridge bridge = nearest(end);
      if (bridge.to == kNone || turns_back(end, bridge.to)) continue;
      const bool is_free = map_.is_free(bridge.to);
      if (is_free && turns_back(bridge.to, end)) continue;
      if (runs_along_(mm(end), mm(bridge.to), !is_free) && is_clear(bridge)) found.push_back(bridge);
    }
    const auto key = [&](const Bridge& b) { return std::tuple(b.length, map_.point(b.from), map_.point(b.to)); };
    std::ranges::sort(found, {}, key);
    return found;
  }

 private:
  bool is_outline(std::uint32_t piece) const { return map_.piece(piece).line_class == LineClass::outline; }
  Point2 mm(std::uint32_t end) const { return map_.to_mm(map_.point(end)); }

  /// Order of the ends that are equally far away.
  std::pair<LatticePoint, float> key_of(std::uint32_t end) const { return {map_.point(end), map_.tip(end).z}; }

  std::vector<std::uint32_t> own_line(std::uint32_t end) const {
    std::vector<std::uint32_t> own = map_.line_back(end, kOwnLineInBridges * wide_);
    std::ranges::sort(own);
    return own;
  }

  /// Whether the end lies in the ink of another line.
  bool touches(std::uint32_t end) {
    const std::vector<std::uint32_t> own = own_line(end);
    const LatticePoint p = map_.point(end);
    return map_.near(p, p, clear_, [&](std::uint32_t piece) {
      return !std::ranges::binary_search(own, piece) && foot_on(map_.piece(piece), p).distance <= clear_;
    });
  }

  /// Whether the way from an end to another one turns back beside the line of the first.
  bool turns_back(std::uint32_t end, std::uint32_t other) const {
    const LatticePoint start = map_.point(end ^ 1), p = map_.point(end), q = map_.point(other);
    const Point2 along = offset(start, p), ahead = offset(p, q);
    return glm::dot(along, ahead) < kLeastBridgeCosine * glm::length(along) * glm::length(ahead);
  }

  Bridge nearest(std::uint32_t end) {
    const std::vector<std::uint32_t> own = own_line(end);
    const LatticePoint p = map_.point(end);
    Bridge best{end, kNone, end, wide_};
    map_.near(p, p, wide_, [&](std::uint32_t piece) {
      if (!is_outline(piece) || std::ranges::binary_search(own, piece)) return false;
      for (const std::uint32_t other : {2 * piece, 2 * piece + 1}) {
        const double away = length(p, map_.point(other));
        if (away > best.length) continue;
        if (away < best.length || best.to == kNone || key_of(other) < key_of(best.to)) best = {end, other, end, away};
      }
      return false;
    });
    return best;
  }

  /// Whether no line runs beside the bridge between its ends.
  bool is_clear(const Bridge& bridge) {
    const double margin = kMeetingInClears * clear_;
    if (bridge.length <= 2 * margin) return true;
    const Stroke whole = stroke_of(map_, bridge);
    Stroke middle = whole;
    middle.from = point_at(whole, margin / bridge.length);
    middle.to = point_at(whole, 1 - margin / bridge.length);
    return !is_blocked(map_, middle, clear_, {});
  }

  LineMap& map_;
  const IsOutline& runs_along_;
  double wide_, clear_;
};

}  // namespace

std::size_t bridge_gaps(LineMap& map, const GapLimits& limits, const MakeSource& make_source) {
  const double gap = limits.gap_mm / map.step_mm(), clear = limits.clear_mm / map.step_mm();
  const auto is_seen_and_blocked = [&](const Bridge& bridge) {
    if (bridge.length < gap) return false;
    std::vector<std::uint32_t> own = map.line_back(bridge.from, kOwnLineInClears * clear);
    const std::vector<std::uint32_t> far = map.line_back(bridge.to, kOwnLineInClears * clear);
    own.insert(own.end(), far.begin(), far.end());
    return is_blocked(map, stroke_of(map, bridge), clear, own);
  };
  std::size_t count = 0;
  for (int round = 0; round < kMostBridgingRounds; ++round) {
    std::vector<Bridge> bridges = OpenEnds(map, gap, limits.wide_mm / map.step_mm()).bridges();
    std::erase_if(bridges, is_seen_and_blocked);
    for (const Bridge& bridge : bridges) map.add(stroke_of(map, bridge), bridge.from, bridge.to, make_source);
    count += bridges.size();
    if (bridges.empty()) break;
  }
  return count;
}

std::size_t close_outlines(LineMap& map, const GapLimits& limits, const IsOutline& is_outline,
                           const MakeSource& make_source) {
  std::size_t count = 0;
  for (const Bridge& bridge : OutlineGaps(map, limits, is_outline).bridges()) {
    if (!map.is_free(bridge.from)) continue;  // another bridge leads there
    map.add(stroke_of(map, bridge), bridge.from, bridge.to, make_source);
    ++count;
  }
  return count;
}

}  // namespace ligne
