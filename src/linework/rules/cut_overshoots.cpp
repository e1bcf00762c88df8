#include <algorithm>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "base/no_index.hpp"
#include "linework/map/line_groups.hpp"
#include "linework/rules/rules.hpp"
#include "linework/stroke_geometry.hpp"

namespace ligne {
namespace {

/// A free end of a line, and the place before it where the line crosses another one.
struct Overshoot {
  std::uint32_t end;
  std::vector<std::uint32_t> tail;  ///< pieces from the free end to the one of the crossing
  std::uint32_t last;               ///< the end of the piece of the crossing that leads to the free end
  StrokeCut place;                  ///< on that piece
  double length;                    ///< from the crossing to the free end, lattice steps
};

class OvershootFinder {
 public:
  OvershootFinder(LineMap& map, const EndLimits& limits)
      : map_(map),
        longest_(limits.longest_mm / map.step_mm()),
        touching_(limits.touching_mm / map.step_mm()),
        arcs_(map, touching_) {}

  std::vector<Overshoot> find() {
    std::vector<Overshoot> found;
    for (std::uint32_t end = 0; end < 2 * map_.piece_count(); ++end) {
      if (!is_feature(map_.piece(end / 2)) || !arcs_.is_free(end)) continue;
      if (std::optional<Overshoot> overshoot = behind_crossing(end)) found.push_back(std::move(*overshoot));
    }
    const auto key = [&](const Overshoot& o) { return std::tuple(o.length, map_.point(o.end), o.place.p); };
    std::ranges::sort(found, {}, key);
    return found;
  }

 private:
  std::optional<Overshoot> behind_crossing(std::uint32_t end) {
    const Arcs::Arc chain = chain_from(map_, end, 2 * longest_);
    const double longest = chain.pieces.empty() ? longest_ : std::min(longest_, chain.length / 2);
    Overshoot found{end, {}, end, {}, 0};
    std::uint32_t crossed = kNone;
    for (double passed = 0; found.last != kNone && passed < longest; found.last = arcs_.next(found.last ^ 1)) {
      const Stroke& s = map_.piece(found.last / 2);
      found.length = longest;
      map_.near(s.from, s.to, 0, [&](std::uint32_t other) {
        const std::optional<double> at = crossing(s, other);
        const double length = at ? passed + (found.last % 2 == 0 ? *at : 1 - *at) * page_length(s) : longest;
        if (length < found.length) crossed = other, found.length = length, found.place = {*at, point_at(s, *at)};
        return false;
      });
      if (crossed != kNone) break;
      found.tail.push_back(found.last / 2);
      passed += page_length(s);
    }
    // An end at a crossing was led there, and is rounded.
    if (crossed == kNone || found.length <= touching_ || ends_sooner(crossed, found)) return {};
    return found;
  }

  /// The fraction of a stroke at which another piece crosses it, inside both.
  std::optional<double> crossing(const Stroke& s, std::uint32_t other) const {
    const Stroke& o = map_.piece(other);
    if (!is_feature(o) || !(orientation(s.from, s.to, o.from) * orientation(s.from, s.to, o.to) < 0)) return {};
    const double from = orientation(o.from, o.to, s.from), to = orientation(o.from, o.to, s.to);
    return from * to < 0 ? std::optional(from / (from - to)) : std::nullopt;
  }

  /// Whether the line that is crossed ends freely, or comes back to the crossing, over a shorter way than the overshoot.
  bool ends_sooner(std::uint32_t crossed, const Overshoot& overshoot) const {
    for (std::uint32_t end : {2 * crossed, 2 * crossed + 1}) {
      double length = ligne::length(overshoot.place.p, map_.point(end));
      while (length < overshoot.length && end / 2 != overshoot.last / 2 && map_.next(end) != kNone) {
        end = map_.next(end) ^ 1;
        length += page_length(map_.piece(end / 2));
      }
      if (end / 2 == overshoot.last / 2 || (length < overshoot.length && map_.is_free(end))) return true;
    }
    return false;
  }

  LineMap& map_;
  double longest_, touching_;
  Arcs arcs_;
};

}  // namespace

std::size_t cut_overshoots(LineMap& map, const EndLimits& limits) {
  std::vector<std::uint8_t> is_cut(map.piece_count(), 0);
  std::size_t count = 0;
  for (const auto& [end, tail, last, place, length] : OvershootFinder(map, limits).find()) {
    // A line whose two ends are overshoots loses the second in the next pass.
    if (std::exchange(is_cut[last / 2], 1)) continue;
    for (const std::uint32_t piece : tail) map.remove(piece);
    std::uint32_t gone = last / 2;
    if (place.p != map.point(last) && place.p != map.point(last ^ 1)) {
      const std::uint32_t behind = map.cut_at(gone, place);
      if (last % 2 == 1) gone = behind;
    } else if (place.p == map.point(last)) {
      gone = kNone;
    }
    if (gone != kNone) map.remove(gone);
    ++count;
  }
  return count;
}

}  // namespace ligne
