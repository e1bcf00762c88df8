#include "visibility/penetration/parallel_extents.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace ligne {
namespace {

/// Least length of the sum of the longest sides as vectors with doubled angles, as a part of the sum of their lengths.
/// Adjustable: it is 1 for the facets of a rod, and hardly more than 0 for those of a sphere.
constexpr double kParallel = 0.6;

struct Direction {
  double x = 0, y = 0;
};

Direction longest_side(const PlacedFacet& f) {
  Direction longest;
  for (std::size_t k = 0; k < 3; ++k) {
    const Direction side{f.x[(k + 1) % 3] - f.x[k], f.y[(k + 1) % 3] - f.y[k]};
    if (side.x * side.x + side.y * side.y > longest.x * longest.x + longest.y * longest.y) longest = side;
  }
  return longest;
}

/// The unit vector across the mean direction of the longest sides, which count by their lengths, up to `most`; none if they
/// have no common direction.
std::optional<Direction> across(std::span<const PlacedFacet* const> facets, double most) {
  Direction doubled;  // the sum of the directions with doubled angles, so that opposite ones are alike
  double lengths = 0;
  for (const PlacedFacet* facet : facets) {
    const Direction side = longest_side(*facet);
    const double length = std::hypot(side.x, side.y);
    if (length == 0) continue;
    const double weight = std::min(length, most) / (length * length);
    lengths += std::min(length, most);
    doubled.x += weight * (side.x * side.x - side.y * side.y);
    doubled.y += weight * 2 * side.x * side.y;
  }
  if (!(std::hypot(doubled.x, doubled.y) > kParallel * lengths)) return std::nullopt;
  const double angle = std::atan2(doubled.y, doubled.x) / 2;
  return Direction{-std::sin(angle), std::cos(angle)};
}

}  // namespace

bool ParallelExtents::set(std::span<const PlacedFacet* const> facets, const CellSquare& square, double margin) {
  from_.clear(), to_.clear();
  const std::optional<Direction> normal = across(facets, square.size);
  if (!normal) return false;
  const Direction n = *normal;
  for (const PlacedFacet* f : facets) {
    const auto [from, to] =
        std::minmax({n.x * f->x[0] + n.y * f->y[0], n.x * f->x[1] + n.y * f->y[1], n.x * f->x[2] + n.y * f->y[2]});
    from_.push_back(from - margin), to_.push_back(to + margin);
  }
  return true;
}

std::span<const std::uint32_t> ParallelExtents::overlapping(std::uint32_t facet, std::uint32_t begin, std::uint32_t end,
                                                            std::vector<std::uint32_t>& space) const {
  if (space.size() < from_.size()) space.resize(from_.size());
  const double from = from_[facet], to = to_[facet];
  const double *const froms = from_.data(), *const tos = to_.data();
  std::uint32_t* next = space.data();
  for (std::uint32_t i = begin; i < end; ++i) {
    *next = i;
    next += (froms[i] <= to) & (tos[i] >= from);  // no branch, which would often be predicted wrongly
  }
  return {space.data(), next};
}

}  // namespace ligne
