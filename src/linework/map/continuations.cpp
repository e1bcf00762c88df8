/// Pairing of the arms of a node, straightest first.
///
/// Few arms: all pairs that turn by at most 90 degrees, sorted by their turn, taken greedily.
///
/// Many arms (the pole of a sphere, a fan): the remaining arms are kept in the order of their directions. Each arm forms
/// candidates with the two that are nearest to its opposite direction. The smallest turn is always among the candidates. If
/// one arm of a candidate was taken by a pair, the other one gets new candidates.

#include "linework/map/continuations.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <compare>
#include <iterator>
#include <limits>
#include <queue>
#include <set>

namespace ligne {
namespace {

/// Turn of more than 90 degrees. Turns are compared by their tangent. Dot and cross product of two directions are exact
/// (see geometry/lattice.hpp), so the only rounding is one division.
constexpr double kTooSharp = -1;

double dot(LatticePoint a, LatticePoint b) { return double(a.x) * b.x + double(a.y) * b.y; }
double cross(LatticePoint a, LatticePoint b) { return double(a.x) * b.y - double(a.y) * b.x; }

/// Tangent of the turn from the end of arm a into arm b: 0 straight on, infinity at 90 degrees, kTooSharp beyond.
double turn(LatticePoint a, LatticePoint b) {
  const double along = -dot(a, b);
  if (along < 0) return kTooSharp;
  if (along == 0) return std::numeric_limits<double>::infinity();
  return std::abs(cross(a, b)) / along;
}

struct Candidate {
  double turn;
  std::uint32_t a, b;  ///< arms, a < b
  auto operator<=>(const Candidate&) const = default;
};

/// Order around the circle from +x over +y; exact.
struct ByDirection {
  static bool is_upper(LatticePoint d) { return d.y > 0 || (d.y == 0 && d.x >= 0); }
  bool operator()(const NodeArm& l, const NodeArm& r) const {
    if (is_upper(l.direction) != is_upper(r.direction)) return is_upper(l.direction);
    const double side = cross(l.direction, r.direction);
    return side != 0 ? side > 0 : l.end < r.end;
  }
};

}  // namespace

void pair_few_arms(std::span<const NodeArm> arms, std::span<std::uint32_t> partner) {
  std::array<Candidate, kFewArms*(kFewArms - 1) / 2> candidates;
  std::size_t count = 0;
  for (std::uint32_t a = 0; a < arms.size(); ++a) {
    for (std::uint32_t b = a + 1; b < arms.size(); ++b) {
      const double t = turn(arms[a].direction, arms[b].direction);
      if (t != kTooSharp) candidates[count++] = {t, a, b};
    }
  }
  std::sort(candidates.begin(), candidates.begin() + count);
  std::array<bool, kFewArms> taken{};
  for (std::size_t i = 0; i < count; ++i) {
    const auto [t, a, b] = candidates[i];
    if (taken[a] || taken[b]) continue;
    taken[a] = taken[b] = true;
    join_ends(partner, arms[a].end, arms[b].end);
  }
}

void pair_many_arms(std::span<const NodeArm> arms, std::span<std::uint32_t> partner) {
  std::set<NodeArm, ByDirection> left;  // the ends are indices of arms
  for (std::uint32_t a = 0; a < arms.size(); ++a) left.insert({arms[a].direction, a});
  std::priority_queue<Candidate, std::vector<Candidate>, std::greater<>> candidates;
  const auto offer = [&](std::uint32_t a, std::uint32_t b) {
    const double t = turn(arms[a].direction, arms[b].direction);
    if (t != kTooSharp) candidates.push({t, std::min(a, b), std::max(a, b)});
  };
  const auto offer_nearest = [&](std::uint32_t a) {
    const LatticePoint d = arms[a].direction;
    const auto after = left.lower_bound({{-d.x, -d.y}, 0});
    offer(a, after == left.end() ? left.begin()->end : after->end);
    offer(a, std::prev(after == left.begin() ? left.end() : after)->end);
  };
  for (std::uint32_t a = 0; a < arms.size(); ++a) offer_nearest(a);
  std::vector<bool> taken(arms.size());
  while (!candidates.empty()) {
    const auto [t, a, b] = candidates.top();
    candidates.pop();
    if (taken[a] && taken[b]) continue;
    if (taken[a] || taken[b]) {
      offer_nearest(taken[a] ? b : a);
      continue;
    }
    taken[a] = taken[b] = true;
    join_ends(partner, arms[a].end, arms[b].end);
    for (const std::uint32_t gone : {a, b}) left.erase({arms[gone].direction, gone});
  }
}

void pair_arms(std::span<const NodeArm> arms, std::span<std::uint32_t> partner) {
  if (arms.size() == 2) {
    join_ends(partner, arms[0].end, arms[1].end);
  } else if (arms.size() > kFewArms) {
    pair_many_arms(arms, partner);
  } else if (arms.size() > 2) {
    pair_few_arms(arms, partner);
  }
}

}  // namespace ligne
