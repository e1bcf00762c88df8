#include "plotting/paths/simplify.hpp"

#include <algorithm>
#include <utility>

#include <glm/geometric.hpp>

#include "plotting/paths/segment_distance.hpp"

namespace ligne {
namespace {

/// Adjustable: a longer line is worked on in pieces of so many points, since the time for a piece can grow with the square
/// of its points.
constexpr std::uint32_t kPiecePoints = 2048;

/// The point between the two that is farthest from their segment, with its squared distance.
std::pair<std::uint32_t, double> farthest(std::span<const Point2> line, std::uint32_t from, std::uint32_t to) {
  std::pair<std::uint32_t, double> found{from, -1};
  for (std::uint32_t i = from + 1; i < to; ++i) {
    const double distance = squared_distance(line[i], line[from], line[to]);
    if (distance > found.second) found = {i, distance};
  }
  return found;
}

}  // namespace

std::vector<std::uint32_t> simplified(std::span<const Point2> line, double tolerance, double most_lost) {
  const auto n = static_cast<std::uint32_t>(line.size());
  std::vector<std::uint32_t> kept;
  if (n == 0) return kept;
  std::vector<double> way(n, 0);  // from the first point, along the line
  for (std::uint32_t i = 1; i < n; ++i) way[i] = way[i - 1] + glm::distance(line[i - 1], line[i]);
  const auto shortens = [&](std::uint32_t from, std::uint32_t to) {
    return to > from + 1 && glm::distance(line[from], line[to]) < (way[to] - way[from]) * (1 - most_lost);
  };
  std::vector<std::uint32_t> stack;
  kept.push_back(0);
  for (std::uint32_t start = 0; start + 1 < n;) {
    const std::uint32_t end = std::min(n - 1, start + kPiecePoints);
    stack.assign(1, end);
    while (!stack.empty()) {
      const std::uint32_t from = kept.back(), to = stack.back();
      const auto [at, distance] = farthest(line, from, to);
      if (distance > tolerance * tolerance || shortens(from, to)) {
        stack.push_back(at);
      } else {
        kept.push_back(to);
        stack.pop_back();
      }
    }
    start = end;
  }
  return kept;
}

}  // namespace ligne
