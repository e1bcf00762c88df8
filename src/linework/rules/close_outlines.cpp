#include <algorithm>
#include <tuple>
#include <vector>

#include <glm/geometric.hpp>

#include "geometry/search/point_tree.hpp"
#include "linework/rules/rules.hpp"
#include "linework/stroke_geometry.hpp"

namespace ligne {
namespace {

/// Length of the line behind an end on which it looks for no other end, in longest bridges.
constexpr double kOwnLineInBridges = 2;
/// Parts at both ends of a bridge that may lie beside other lines, in clear distances.
constexpr double kMeetingInClears = 2;
/// Least cosine of the turn from a line into its bridge: 120 degrees. Lines that end side by side are not joined.
constexpr double kLeastBridgeCosine = -0.5;

/// A bridge from a free end to another end.
struct Bridge {
  std::uint32_t from, to;
  double length;
};

class OutlineGaps {
 public:
  OutlineGaps(LineMap& map, const OutlineGapLimits& limits)
      : map_(map), limits_(limits), wide_(limits.wide_mm / map.step_mm()), clear_(limits.clear_mm / map.step_mm()) {
    std::vector<TreePoint<2>> points;
    for (std::uint32_t end = 0; end < 2 * map.piece_count(); ++end) {
      if (!map.is_alive(end / 2) || map.piece(end / 2).line_class != LineClass::outline) continue;
      ends_.push_back(end);
      points.push_back({map.point(end).x, map.point(end).y});
    }
    tree_ = PointTree<2>(points);
  }

  /// The bridges from free ends to their nearest ends along missing outlines, the shortest first.
  std::vector<Bridge> bridges() {
    std::vector<Bridge> found;
    for (const std::uint32_t end : ends_) {
      if (!map_.is_free(end) || touches(end)) continue;
      const Bridge bridge = nearest(end);
      if (bridge.to == kNone || turns_back(end, bridge.to)) continue;
      const bool is_free = map_.is_free(bridge.to);
      if (is_free && turns_back(bridge.to, end)) continue;
      if (limits_.is_outline(mm(end), mm(bridge.to), !is_free) && is_clear(bridge)) found.push_back(bridge);
    }
    const auto key = [&](const Bridge& b) { return std::tuple(b.length, map_.point(b.from), map_.point(b.to)); };
    std::ranges::sort(found, {}, key);
    return found;
  }

 private:
  Point2 mm(std::uint32_t end) const { return map_.to_mm(map_.point(end)); }

  /// Order of the ends that are equally far away.
  std::pair<LatticePoint, float> key_of(std::uint32_t end) const {
    const Stroke& s = map_.piece(end / 2);
    return {map_.point(end), end % 2 == 0 ? s.z_from : s.z_to};
  }

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
    const Point2 along{double(p.x) - start.x, double(p.y) - start.y}, ahead{double(q.x) - p.x, double(q.y) - p.y};
    return glm::dot(along, ahead) < kLeastBridgeCosine * glm::length(along) * glm::length(ahead);
  }

  Bridge nearest(std::uint32_t end) const {
    const std::vector<std::uint32_t> own = own_line(end);
    const LatticePoint p = map_.point(end);
    Bridge best{end, kNone, wide_};
    const auto enter = [&](std::uint32_t, double squared) { return squared <= best.length * best.length; };
    tree_.search_from(p, enter, [&](std::uint32_t first, std::uint32_t last) {
      for (std::uint32_t i = first; i < last; ++i) {
        const std::uint32_t other = ends_[tree_.order()[i]];
        const double away = length(p, map_.point(other));
        if (away > best.length || std::ranges::binary_search(own, other / 2)) continue;
        if (away < best.length || best.to == kNone || key_of(other) < key_of(best.to)) best = {end, other, away};
      }
    });
    return best;
  }

  /// Whether no line runs beside the bridge between its ends.
  bool is_clear(const Bridge& bridge) {
    const double margin = kMeetingInClears * clear_;
    if (bridge.length <= 2 * margin) return true;
    const Stroke whole = bridge_between(map_, bridge.from, bridge.to, bridge.from / 2);
    Stroke middle = whole;
    middle.from = point_at(whole, margin / bridge.length);
    middle.to = point_at(whole, 1 - margin / bridge.length);
    return !map_.near(middle.from, middle.to, clear_,
                      [&](std::uint32_t piece) { return !part_near(middle, map_.piece(piece), clear_).empty(); });
  }

  LineMap& map_;
  const OutlineGapLimits& limits_;
  double wide_, clear_;
  std::vector<std::uint32_t> ends_;
  PointTree<2> tree_;
};

}  // namespace

std::size_t close_outlines(LineMap& map, const OutlineGapLimits& limits, const MakeSource& make_source) {
  if (!limits.is_outline) return 0;
  std::size_t count = 0;
  for (const Bridge& bridge : OutlineGaps(map, limits).bridges()) {
    if (!map.is_free(bridge.from)) continue;  // another bridge leads there
    map.add(bridge_between(map, bridge.from, bridge.to, bridge.from / 2), bridge.from, bridge.to, make_source);
    ++count;
  }
  return count;
}

}  // namespace ligne
