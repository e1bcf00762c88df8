#include "plotting/paths/simplify.hpp"

#include <algorithm>
#include <bit>

#include <glm/geometric.hpp>

#include "base/parallel.hpp"
#include "geometry/nearest_on_segment.hpp"

namespace ligne {
namespace {

/// Segments in a piece. Longer lines are simplified piece by piece, in parallel. Adjustable.
constexpr std::uint32_t kPiecePoints = 2048;

/// Parts that were divided this many times as often as halving would take are divided in their middle halves from there
/// on. So a zigzag, whose farthest points lie near its ends, takes O(n log n), too. Adjustable.
constexpr unsigned kMostDepths = 2;

/// A part of a line that remains to be simplified.
struct Part {
  std::uint32_t to;
  unsigned depth;  ///< the number of divisions that led to it
};

/// Appends the indices of the points that stay of a piece, except its first point, whose index is `first`
/// [DouglasPeucker1973].
void simplify_piece(std::span<const Point2> piece, std::uint32_t first, double tolerance, double most_lost,
                    std::vector<std::uint32_t>& kept) {
  const auto n = static_cast<std::uint32_t>(piece.size());
  std::vector<double> way(n, 0);  // from the first point, along the line
  for (std::uint32_t i = 1; i < n; ++i) way[i] = way[i - 1] + glm::distance(piece[i - 1], piece[i]);
  const auto shortens = [&](std::uint32_t from, std::uint32_t to) {
    return to > from + 1 && glm::distance(piece[from], piece[to]) < (way[to] - way[from]) * (1 - most_lost);
  };
  const unsigned most_depth = kMostDepths * static_cast<unsigned>(std::bit_width(n));
  std::vector<Part> parts{{n - 1, 0}};
  for (std::uint32_t from = 0; !parts.empty();) {
    const auto [to, depth] = parts.back();
    const std::uint32_t quarter = depth < most_depth ? 0 : (to - from) / 4;
    double farthest = -1, best = -1;
    std::uint32_t at = from;
    for (std::uint32_t i = from + 1; i < to; ++i) {
      const double squared = squared_distance(piece[i], piece[from], piece[to]);
      farthest = std::max(farthest, squared);
      if (squared > best && from + quarter <= i && i + quarter <= to) best = squared, at = i;
    }
    if (farthest > tolerance * tolerance || shortens(from, to)) {
      parts.back().depth = depth + 1;
      parts.push_back({at, depth + 1});
    } else {
      kept.push_back(first + to);
      from = to;
      parts.pop_back();
    }
  }
}

}  // namespace

std::vector<std::uint32_t> simplified(std::span<const Point2> line, double tolerance, double most_lost) {
  const auto n = static_cast<std::uint32_t>(line.size());
  std::vector<std::uint32_t> kept;
  if (n == 0) return kept;
  kept.push_back(0);
  if (n - 1 <= kPiecePoints) {
    if (n > 1) simplify_piece(line, 0, tolerance, most_lost, kept);
    return kept;
  }
  std::vector<std::vector<std::uint32_t>> pieces((n + kPiecePoints - 2) / kPiecePoints);
  parallel_for(pieces.size(), [&](std::size_t k) {
    const auto start = static_cast<std::uint32_t>(k) * kPiecePoints, end = std::min(n - 1, start + kPiecePoints);
    simplify_piece(line.subspan(start, end - start + 1), start, tolerance, most_lost, pieces[k]);
  });
  for (const std::vector<std::uint32_t>& piece : pieces) kept.insert(kept.end(), piece.begin(), piece.end());
  return kept;
}

}  // namespace ligne
