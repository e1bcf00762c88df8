#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "linework/map/line_groups.hpp"
#include "linework/near_part.hpp"
#include "linework/rules/rules.hpp"
#include "linework/stroke_geometry.hpp"

namespace ligne {
namespace {

/// Smallest ratio of the length of a line to its extension. Taste.
constexpr double kLongInWays = 3;
/// Longest last part of a line that gives its direction, in reaches. Taste.
constexpr double kDirectionInReaches = 0.5;
/// Sine and cosine of the largest turn of a line that meets no line straight ahead: 20 degrees. Taste.
constexpr double kTurnSine = 0.342, kTurnCosine = 0.94;

struct Vector {
  double x = 0, y = 0;
};

/// A free end and the possible extensions of its line.
struct Undershoot {
  std::uint32_t end;
  Vector ahead;         ///< direction; its length is the longest extension
  double straight = 2;  ///< length of the straight extension, in parts of `ahead`; above 1: it meets no line
  Vector turned{};      ///< extension to the nearest point of a line in the wedge ahead
  double turned_part = 2;
};

/// Updates the turned extension: the nearest point of start + [0, 1] u within the wedge. `start` is relative to the
/// end.
void turn_to(Undershoot& end, const Vector& start, const Vector& u) {
  const Vector& d = end.ahead;
  StrokePart in_wedge{0, 1};
  for (const double side : {-1.0, 1.0}) {
    // The inner normal of one side of the wedge.
    const Vector n{kTurnSine * d.x - side * kTurnCosine * d.y, kTurnSine * d.y + side * kTurnCosine * d.x};
    const double at_start = n.x * start.x + n.y * start.y, slope = n.x * u.x + n.y * u.y;
    in_wedge.keep(at_start, slope, 0, std::numeric_limits<double>::infinity());
  }
  if (in_wedge.empty() || (d.x == 0 && d.y == 0)) return;
  const double square = u.x * u.x + u.y * u.y;
  const double at =
      square > 0 ? std::clamp(-(start.x * u.x + start.y * u.y) / square, in_wedge.from, in_wedge.to) : in_wedge.from;
  const Vector turned{start.x + at * u.x, start.y + at * u.y};
  const double part = std::hypot(turned.x, turned.y) / std::hypot(d.x, d.y);
  if (part >= end.turned_part) return;
  end.turned = turned;
  end.turned_part = part;
}

/// Updates both extensions of the line that ends at `p` with the stroke.
void lead_to(Undershoot& end, LatticePoint p, const Stroke& s) {
  const Vector u{double(s.to.x) - s.from.x, double(s.to.y) - s.from.y};
  const Vector start{double(s.from.x) - p.x, double(s.from.y) - p.y};
  const double area = end.ahead.x * u.y - end.ahead.y * u.x;
  if (area != 0) {
    const double extension = (start.x * u.y - start.y * u.x) / area;
    const double along = (start.x * end.ahead.y - start.y * end.ahead.x) / area;
    if (extension > 0 && extension <= 1 && along >= 0 && along <= 1) end.straight = std::min(end.straight, extension);
  }
  turn_to(end, start, u);
}

class UndershootFinder {
 public:
  UndershootFinder(LineMap& map, const UndershootLimits& limits)
      : map_(map),
        reach_(limits.reach_mm / map.step_mm()),
        touching_(limits.touching_mm / map.step_mm()),
        arcs_(map, touching_),
        arc_of_(map.piece_count(), kNone) {
    const std::vector<Arcs::Arc> arcs = arcs_.find();
    for (std::uint32_t a = 0; a < arcs.size(); ++a) {
      for (const std::uint32_t p : arcs[a].pieces) arc_of_[p] = a;
      lengths_.push_back(arcs[a].length);
    }
  }

  /// Returns the ends to extend and their targets.
  std::vector<std::pair<std::uint32_t, LatticePoint>> find() {
    std::vector<std::pair<std::uint32_t, LatticePoint>> found;
    for (std::uint32_t end = 0; end < 2 * map_.piece_count(); ++end) {
      const std::uint32_t piece = end / 2;
      if (!arcs_.has(piece) || !is_feature(map_.piece(piece)) || arcs_.degree(arcs_.junction_of(end)) != 1) continue;
      const Vector d = direction(end);
      const double longest = std::min(reach_, lengths_[arc_of_[piece]] / kLongInWays);
      Undershoot shoot{.end = end, .ahead = {d.x * longest, d.y * longest}};
      const LatticePoint p = map_.point(end);
      const LatticePoint far{p.x + static_cast<std::int32_t>(shoot.ahead.x), p.y + static_cast<std::int32_t>(shoot.ahead.y)};
      map_.near(p, far, touching_ + kTurnSine * reach_, [&](std::uint32_t other) {
        const bool leads = arcs_.has(other) && arc_of_[other] != arc_of_[piece] && is_feature(map_.piece(other));
        if (leads) lead_to(shoot, p, map_.piece(other));
        return false;
      });
      if (shoot.straight > 1 && shoot.turned_part > 1) continue;
      const Vector extension =
          shoot.straight > 1 ? shoot.turned : Vector{shoot.straight * shoot.ahead.x, shoot.straight * shoot.ahead.y};
      const LatticePoint to{p.x + static_cast<std::int32_t>(std::lround(extension.x)),
                            p.y + static_cast<std::int32_t>(std::lround(extension.y))};
      if (to != p) found.emplace_back(end, to);
    }
    return found;
  }

 private:
  /// The outward direction of unit length; zero for a line that returns to its end.
  Vector direction(std::uint32_t end) const {
    const LatticePoint tip = map_.point(end);
    LatticePoint back = tip;
    for (double left = kDirectionInReaches * reach_; end != kNone && left > 0; end = arcs_.next(end ^ 1)) {
      back = map_.point(end ^ 1);
      left -= page_length(map_.piece(end / 2));
    }
    const Vector d{double(tip.x) - back.x, double(tip.y) - back.y};
    const double length = std::hypot(d.x, d.y);
    return length > 0 ? Vector{d.x / length, d.y / length} : Vector{};
  }

  LineMap& map_;
  double reach_, touching_;
  Arcs arcs_;
  std::vector<std::uint32_t> arc_of_;  ///< by piece
  std::vector<double> lengths_;        ///< by arc
};

}  // namespace

std::size_t extend_undershoots(LineMap& map, const UndershootLimits& limits, const MakeSource& make_source) {
  std::vector<std::pair<std::uint32_t, LatticePoint>> found = UndershootFinder(map, limits).find();
  // If two ends would be extended to each other, only the one whose class comes first is extended.
  struct Extension {
    LatticePoint from, to;
    LineClass line_class;
    auto operator<=>(const Extension&) const = default;
  };
  std::vector<Extension> extensions;
  extensions.reserve(found.size());
  for (const auto& [end, to] : found) extensions.push_back({map.point(end), to, map.piece(end / 2).line_class});
  std::ranges::sort(extensions);
  std::erase_if(found, [&](const auto& led) {
    const Extension extension{map.point(led.first), led.second, map.piece(led.first / 2).line_class};
    const auto back = std::ranges::lower_bound(extensions, Extension{extension.to, extension.from, LineClass::outline});
    if (back == extensions.end() || back->from != extension.to || back->to != extension.from) return false;
    return std::pair(back->line_class, back->from) < std::pair(extension.line_class, extension.from);
  });
  for (const auto& [end, to] : found) {
    Stroke s = map.piece(end / 2);
    const bool at_from = end % 2 == 0;
    s.from = at_from ? s.from : s.to;
    s.to = to;
    s.z_from = s.z_to = at_from ? s.z_from : s.z_to;
    s.w_from = s.w_to = at_from ? s.w_from : s.w_to;
    map.add(s, end, kNone, make_source);
  }
  return found.size();
}

}  // namespace ligne
