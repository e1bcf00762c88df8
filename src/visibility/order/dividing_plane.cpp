#include "visibility/order/dividing_plane.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "base/no_index.hpp"

namespace ligne {
namespace {

constexpr std::size_t kMany = 96;     ///< largest set for which the fewest cuts are sought; larger sets are halved. Tuned
constexpr std::size_t kSample = 512;  ///< most pieces of a set on which a candidate is judged. Tuned

struct Division {
  std::size_t front = 0, back = 0, cut = 0;

  /// The cost of a division; smaller is better. Few pieces: first the number of cuts, then the larger side. Many pieces: the
  /// larger side plus twice the cuts, which keeps the size of the tree O(n log n).
  std::array<std::size_t, 2> cost(bool many) const {
    const std::size_t larger = std::max(front, back) + cut;
    return many ? std::array{larger + cut, cut} : std::array{cut, larger};
  }
};

Division divide(const ModelPieces& pieces, std::span<const std::uint32_t> set, std::size_t stride, const ModelPlane& plane) {
  Division result;
  for (std::size_t i = 0; i < set.size(); i += stride) {
    const PlaneSide side = pieces.side(set[i], plane);
    result.front += side == PlaneSide::front;
    result.back += side == PlaneSide::back;
    result.cut += side == PlaneSide::both;
  }
  return result;
}

/// The plane across axis `k` through the median of the pieces' first corners: faces often end where corners are.
ModelPlane median_plane(const ModelPieces& pieces, std::span<const std::uint32_t> set, std::size_t stride, int k) {
  std::vector<double> places;
  for (std::size_t i = 0; i < set.size(); i += stride) places.push_back(pieces.point(pieces.corners(set[i])[0])[k]);
  const auto middle = places.begin() + static_cast<std::ptrdiff_t>(places.size() / 2);
  std::nth_element(places.begin(), middle, places.end());
  ModelPlane plane{Point3(0), Point3(0)};
  plane.normal[k] = 1;
  plane.point[k] = *middle;
  return plane;
}

}  // namespace

DividingPlane choose_plane(const ModelPieces& pieces, std::span<const std::uint32_t> set, const PlaneChoice& choice,
                           std::uint64_t seed) {
  const auto of_face = [&](std::uint32_t piece) { return DividingPlane{pieces.plane_of(piece), pieces.face(piece)}; };
  if (set.size() == 1) return of_face(set[0]);
  const bool many = choice.free_planes && set.size() > kMany;
  const std::size_t stride = (set.size() + kSample - 1) / kSample;
  DividingPlane best;
  std::array<std::size_t, 2> least{};
  bool any = false;
  const auto consider = [&](const DividingPlane& candidate) {
    const Division division = divide(pieces, set, stride, candidate.plane);
    // A plane that belongs to no face must leave pieces on both sides.
    const bool divides = division.front + division.cut < set.size() && division.back + division.cut < set.size();
    if (candidate.face == kNone && (!divides || std::min(division.front, division.back) == 0)) return;
    const auto cost = division.cost(many);
    if (any && !(cost < least)) return;
    any = true;
    least = cost;
    best = candidate;
  };
  if (set.size() <= choice.candidates) {
    for (const std::uint32_t piece : set) consider(of_face(piece));
  } else {
    for (unsigned i = 0; i < choice.candidates; ++i) {
      seed = scramble(seed);
      consider(of_face(set[seed % set.size()]));
    }
  }
  if (many) {
    for (int k = 0; k < 3; ++k) consider({median_plane(pieces, set, stride, k), kNone});
  }
  return best;
}

}  // namespace ligne
