#include "plotting/paths/simplify.hpp"

#include <algorithm>
#include <optional>

#include <glm/geometric.hpp>

#include "base/parallel.hpp"
#include "plotting/paths/farthest_point.hpp"
#include "plotting/paths/segment_distance.hpp"

namespace ligne {
namespace {

/// Segments in a piece. Longer lines are simplified piece by piece, since the time for a piece can grow with the square
/// of its points where they lie far beyond the ends of the segments tried. Adjustable.
constexpr std::uint32_t kPiecePoints = 2048;

/// Mean number of visits to each point of a piece before a tree is built over them, as for a zigzag. Adjustable.
constexpr std::size_t kLooks = 8;

/// Finds the farthest point of a part of a piece: by visiting all points, or after too many visits by a tree.
class Farthest {
 public:
  explicit Farthest(std::span<const Point2> piece) : piece_(piece), looks_left_(kLooks * piece.size()) {}

  FarthestPoint::Found between(std::uint32_t from, std::uint32_t to) {
    if (tree_) return tree_->between(from, to);
    if (looks_left_ < to - from) return tree_.emplace(piece_).between(from, to);
    looks_left_ -= to - from;
    FarthestPoint::Found found{from, -1};
    for (std::uint32_t i = from + 1; i < to; ++i) {
      const double distance = squared_distance(piece_[i], piece_[from], piece_[to]);
      if (distance > found.squared_distance) found = {i, distance};
    }
    return found;
  }

 private:
  std::span<const Point2> piece_;
  std::size_t looks_left_;
  std::optional<FarthestPoint> tree_;
};

/// Appends the indices of the points that stay of a piece, except its first point, whose index is `first`.
void simplify_piece(std::span<const Point2> piece, std::uint32_t first, double tolerance, double most_lost,
                    std::vector<std::uint32_t>& kept) {
  const auto n = static_cast<std::uint32_t>(piece.size());
  std::vector<double> way(n, 0);  // from the first point, along the line
  for (std::uint32_t i = 1; i < n; ++i) way[i] = way[i - 1] + glm::distance(piece[i - 1], piece[i]);
  const auto shortens = [&](std::uint32_t from, std::uint32_t to) {
    return to > from + 1 && glm::distance(piece[from], piece[to]) < (way[to] - way[from]) * (1 - most_lost);
  };
  Farthest farthest(piece);
  std::vector<std::uint32_t> stack{n - 1};
  for (std::uint32_t from = 0; !stack.empty();) {
    const std::uint32_t to = stack.back();
    const auto [at, distance] = farthest.between(from, to);
    if (distance > tolerance * tolerance || shortens(from, to)) {
      stack.push_back(at);
    } else {
      kept.push_back(first + to);
      from = to;
      stack.pop_back();
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
