#include "visibility/warnock/sides.hpp"

#include <cmath>

namespace ligne::warnock {
namespace {

// Adjustable parameters.
constexpr std::size_t kTriedForSides = 8;  ///< nearest intersectors whose sides may divide
constexpr std::size_t kFewElements = 24;   ///< in a window with no more, the sides of the nearest come first
constexpr double kLeastPart = 4;           ///< width of the narrower part, in margins: its inner window is not empty

/// Distance of the window's middle from the line, or nothing when one of the parts were too narrow.
std::optional<double> distance_of_middle(const ConvexWindow& window, const Border& line, double least) {
  double inside = 0, outside = 0;
  for (std::size_t i = 0; i < window.size(); ++i) {
    const double d = line.distance(window.corner(i));
    inside = std::max(inside, d);
    outside = std::max(outside, -d);
  }
  if (inside <= least || outside <= least) return std::nullopt;
  return std::abs(line.distance(window.middle()));
}

std::optional<Border> side_in_the_way(const FaceTable& table, const Lists& lists, const ConvexWindow& window,
                                      const WindowShape& inner, double margin) {
  std::optional<Border> best;
  double nearest = std::numeric_limits<double>::infinity();
  std::size_t tried = 0;
  for (const Element& e : lists.elements) {
    if (e.relation != Relation::intersector) continue;
    if (++tried > kTriedForSides) break;
    for (const Side& s : table.sides_of(table.faces[e.face])) {
      const FramePoint p = table.at(s.v0), q = table.at(s.v1);
      if (p == q || !inner.meets(p, q)) continue;
      const Border line(p, q);
      const auto distance = distance_of_middle(window, line, kLeastPart * margin);
      if (!distance || *distance >= nearest) continue;
      nearest = *distance;
      best = line;
    }
    if (best && lists.elements.size() <= kFewElements) break;
  }
  return best;
}

}  // namespace

std::optional<Border> dividing_border(const FaceTable& table, const Lists& lists, const ConvexWindow& window,
                                      const WindowShape& inner, double margin, double limit) {
  const Window& box = window.box();
  if (box.longer_side() <= std::max(limit, 1.0)) return std::nullopt;
  if (auto side = side_in_the_way(table, lists, window, inner, margin)) return side;
  const double u = std::floor((box.u0 + box.u1) / 2), v = std::floor((box.v0 + box.v1) / 2);
  return box.width() >= box.height() ? Border({u, box.v0}, {u, box.v0 + 1}) : Border({box.u0, v}, {box.u0 + 1, v});
}

}  // namespace ligne::warnock
