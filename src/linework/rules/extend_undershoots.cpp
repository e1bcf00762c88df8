#include <algorithm>
#include <limits>
#include <optional>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "geometry/point.hpp"
#include "linework/map/line_groups.hpp"
#include "linework/rules/rules.hpp"
#include "linework/stroke_geometry.hpp"

namespace ligne {
namespace {

/// Smallest ratio of the length of a line to its extension. Taste.
constexpr double kLongInWays = 3;
/// Longest last part of a line that gives its direction, in reaches. Taste.
constexpr double kDirectionInReaches = 0.25;
/// Part of the reach within which an end meets lines at any angle. Beyond, it meets lines at the largest turn or more:
/// nearly parallel ones lie beside it, and not before it. Tangent edges, which may end short of a line, do not turn beyond;
/// borders, which end where their sheet does, reach no farther. Taste.
constexpr double kNearPart = 0.5;
/// Sine and cosine of the largest turn of a line that meets no line straight ahead: 20 degrees. Taste.
constexpr double kTurnSine = 0.342, kTurnCosine = 0.94;

/// A free end and the possible extensions of its line.
struct Undershoot {
  Point2 ahead;            ///< direction; its length is the longest extension
  double near = 1;         ///< longest extension that meets a line at a flat angle, in parts of `ahead`
  bool turns_far = true;   ///< whether longer ones may turn
  double straight = 2;     ///< length of the straight extension, in parts of `ahead`; above 1: it meets no line
  Point2 turned{0, 0};     ///< extension to the nearest point of a line in the wedge ahead
  double turned_part = 2;  ///< its length in parts of `ahead`; above 1: there is none
};

/// Updates the turned extension: the nearest point of start + [0, 1] u within the wedge. `start` is relative to the
/// end.
void turn_to(Undershoot& end, Point2 start, Point2 u) {
  const Point2 d = end.ahead, across{-d.y, d.x};
  if (d == Point2(0)) return;
  StrokePart in_wedge{0, 1};
  for (const double side : {-1.0, 1.0}) {
    const Point2 inner_normal = kTurnSine * d + side * kTurnCosine * across;
    in_wedge.keep(glm::dot(inner_normal, start), glm::dot(inner_normal, u), 0, std::numeric_limits<double>::infinity());
  }
  if (in_wedge.empty()) return;
  const double square = glm::dot(u, u);
  const double at = square > 0 ? std::clamp(-glm::dot(start, u) / square, in_wedge.from, in_wedge.to) : in_wedge.from;
  const Point2 turned = start + at * u;
  const double part = glm::length(turned) / glm::length(d);
  const bool is_steep = std::abs(cross(turned, u)) >= kTurnSine * glm::length(turned) * glm::length(u);
  if (part <= (is_steep && end.turns_far ? 1 : end.near) && part < end.turned_part)
    end.turned = turned, end.turned_part = part;
}

/// Updates both extensions of the line that ends at `p` with the stroke.
void lead_to(Undershoot& end, LatticePoint p, const Stroke& s) {
  const Point2 u = offset(s.from, s.to), start = offset(p, s.from);
  const double area = cross(end.ahead, u);
  if (area != 0) {
    const double extension = cross(start, u) / area, along = cross(start, end.ahead) / area;
    const bool is_steep = std::abs(area) >= kTurnSine * glm::length(end.ahead) * glm::length(u);
    if (extension > 0 && extension <= (is_steep ? 1 : end.near) && along >= 0 && along <= 1)
      end.straight = std::min(end.straight, extension);
  }
  turn_to(end, start, u);
}

class UndershootFinder {
 public:
  UndershootFinder(LineMap& map, const EndLimits& limits)
      : map_(map),
        reach_(limits.longest_mm / map.step_mm()),
        touching_(limits.touching_mm / map.step_mm()),
        arcs_(map, touching_) {}

  /// Returns the point to which the line at a free end is extended, if there is one.
  std::optional<LatticePoint> target_of(std::uint32_t end) {
    if (!is_feature(map_.piece(end / 2)) || !arcs_.is_free(end)) return {};
    const Arcs::Arc own = arcs_.from(end);
    const LineClass line_class = map_.piece(end / 2).line_class;
    const double reach = line_class == LineClass::border ? kNearPart * reach_ : reach_;
    const double longest = std::min(reach, own.length / kLongInWays);
    Undershoot shoot{.ahead = longest * direction(end),
                     .near = std::min(1.0, kNearPart * reach_ / longest),
                     .turns_far = line_class != LineClass::tangent};
    const LatticePoint p = map_.point(end);
    map_.near(p, moved(p, shoot.ahead), touching_ + kTurnSine * reach_, [&](std::uint32_t other) {
      const bool leads = arcs_.has(other) && is_feature(map_.piece(other)) && !std::ranges::binary_search(own.pieces, other);
      if (leads) lead_to(shoot, p, map_.piece(other));
      return false;
    });
    if (shoot.straight > 1 && shoot.turned_part > 1) return {};
    const LatticePoint to = moved(p, shoot.straight > 1 ? shoot.turned : shoot.straight * shoot.ahead);
    // An end that lies on a line but for its rounding would creep along it, step by step in each pass.
    return length(p, to) <= touching_ ? std::nullopt : std::optional(to);
  }

 private:
  /// The outward direction of unit length; zero for a line that returns to its end.
  Point2 direction(std::uint32_t end) const {
    const LatticePoint tip = map_.point(end);
    LatticePoint back = tip;
    for (double left = kDirectionInReaches * reach_; end != kNone && left > 0; end = arcs_.next(end ^ 1)) {
      back = map_.point(end ^ 1);
      left -= page_length(map_.piece(end / 2));
    }
    return back == tip ? Point2(0) : offset(back, tip) / length(back, tip);
  }

  LineMap& map_;
  double reach_, touching_;
  Arcs arcs_;
};

}  // namespace

std::size_t extend_undershoots(LineMap& map, const EndLimits& limits, const MakeSource& make_source) {
  UndershootFinder finder(map, limits);
  using Extension = std::tuple<LineClass, LatticePoint, LatticePoint, std::uint32_t>;  // from, to, and the end
  std::vector<Extension> extensions;
  for (std::uint32_t end = 0; end < 2 * map.piece_count(); ++end) {
    if (const auto to = finder.target_of(end))
      extensions.emplace_back(map.piece(end / 2).line_class, map.point(end), *to, end);
  }
  // If two ends would be extended to each other, only the one whose class comes first is extended.
  std::ranges::sort(extensions);
  std::set<std::pair<LatticePoint, LatticePoint>> added;
  std::size_t count = 0;
  for (const auto& [line_class, from, to, end] : extensions) {
    if (added.contains({to, from})) continue;
    added.emplace(from, to);
    const StrokeTip tip = map.tip(end);
    map.add(stroke_between(map.piece(end / 2), tip, {to, tip.z, tip.w}), end, kNone, make_source);
    ++count;
  }
  return count;
}

}  // namespace ligne
