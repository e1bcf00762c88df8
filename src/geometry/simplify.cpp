#include "geometry/simplify.hpp"

#include <algorithm>
#include <bit>

#include <glm/geometric.hpp>

#include "geometry/nearest_on_segment.hpp"

namespace ligne {
namespace {

/// Parts that were divided this many times as often as halving would take are divided in their middle halves from there
/// on. So a zigzag, whose farthest points lie near its ends, takes O(n log n), too. Adjustable.
constexpr unsigned kMostDepths = 2;

/// A part of a line that remains to be simplified.
struct Part {
  std::uint32_t to;
  unsigned depth;  ///< the number of divisions that led to it
};

}  // namespace

/// [DouglasPeucker1973]
std::vector<std::uint32_t> simplified(std::span<const Point2> line, double tolerance, double most_lost) {
  const auto n = static_cast<std::uint32_t>(line.size());
  if (n == 0) return {};
  std::vector<double> way(n, 0);  // from the first point, along the line
  for (std::uint32_t i = 1; i < n; ++i) way[i] = way[i - 1] + glm::distance(line[i - 1], line[i]);
  const auto shortens = [&](std::uint32_t from, std::uint32_t to) {
    return to > from + 1 && glm::distance(line[from], line[to]) < (way[to] - way[from]) * (1 - most_lost);
  };
  const unsigned most_depth = kMostDepths * static_cast<unsigned>(std::bit_width(n));
  std::vector<std::uint32_t> kept{0};
  std::vector<Part> parts;
  if (n > 1) parts.push_back({n - 1, 0});
  for (std::uint32_t from = 0; !parts.empty();) {
    const auto [to, depth] = parts.back();
    const std::uint32_t quarter = depth < most_depth ? 0 : (to - from) / 4;
    double farthest = -1, best = -1;
    std::uint32_t at = from;
    for (std::uint32_t i = from + 1; i < to; ++i) {
      const double squared = squared_distance(line[i], line[from], line[to]);
      farthest = std::max(farthest, squared);
      if (squared > best && from + quarter <= i && i + quarter <= to) best = squared, at = i;
    }
    if (farthest > tolerance * tolerance || shortens(from, to)) {
      parts.back().depth = depth + 1;
      parts.push_back({at, depth + 1});
    } else {
      kept.push_back(to);
      from = to;
      parts.pop_back();
    }
  }
  return kept;
}

}  // namespace ligne
