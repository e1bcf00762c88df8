/// Pairing of the arms of a node, straightest first.
///
/// Few arms: all pairs that turn by at most 90 degrees, sorted by their turn, taken greedily.
///
/// Many arms (the pole of a sphere, a fan): every arm is put on the circle of directions twice, as itself and, turned
/// by half a turn, as its ghost. The turn between two arms is the distance between one arm and the ghost of the other.
/// The smallest turn is always between an arm and a ghost that are neighbours on the circle, since any mark between
/// them would make a smaller turn. So only neighbours are candidates. When a pair is taken, its four marks leave the
/// circle, and at most four new pairs of neighbours arise. O(d log d) for d arms.

#include "linework/map/continuations.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <compare>
#include <limits>
#include <queue>

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

void join(std::span<std::uint32_t> partner, std::uint32_t a, std::uint32_t b) {
  partner[a] = b;
  partner[b] = a;
}

/// An arm, or its ghost, on the circle.
struct Mark {
  LatticePoint direction;
  std::uint32_t arm;
  bool ghost;
};

/// Order around the circle from +x over +y; exact.
bool before(const Mark& l, const Mark& r) {
  const auto half = [](LatticePoint d) { return d.y < 0 || (d.y == 0 && d.x < 0); };
  if (half(l.direction) != half(r.direction)) return half(r.direction);
  const double side = cross(l.direction, r.direction);
  if (side != 0) return side > 0;
  if (l.arm != r.arm) return l.arm < r.arm;
  return l.ghost < r.ghost;
}

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
    join(partner, arms[a].end, arms[b].end);
  }
}

void pair_many_arms(std::span<const NodeArm> arms, std::span<std::uint32_t> partner) {
  std::vector<Mark> marks;
  marks.reserve(2 * arms.size());
  for (std::uint32_t a = 0; a < arms.size(); ++a) {
    const LatticePoint d = arms[a].direction;
    marks.push_back({d, a, false});
    marks.push_back({{-d.x, -d.y}, a, true});
  }
  std::sort(marks.begin(), marks.end(), before);

  const auto n = static_cast<std::uint32_t>(marks.size());
  std::vector<std::uint32_t> next(n), previous(n);
  std::vector<std::array<std::uint32_t, 2>> marks_of(arms.size());
  for (std::uint32_t i = 0; i < n; ++i) {
    next[i] = i + 1 == n ? 0 : i + 1;
    previous[i] = i == 0 ? n - 1 : i - 1;
    marks_of[marks[i].arm][marks[i].ghost] = i;
  }
  std::priority_queue<Candidate, std::vector<Candidate>, std::greater<>> candidates;
  const auto offer = [&](std::uint32_t i) {
    const Mark &l = marks[i], &r = marks[next[i]];
    if (l.ghost == r.ghost || l.arm == r.arm) return;
    const double t = turn(arms[l.arm].direction, arms[r.arm].direction);
    if (t != kTooSharp) candidates.push({t, std::min(l.arm, r.arm), std::max(l.arm, r.arm)});
  };
  for (std::uint32_t i = 0; i < n; ++i) offer(i);

  std::vector<bool> taken(arms.size());
  while (!candidates.empty()) {
    const auto [t, a, b] = candidates.top();
    candidates.pop();
    if (taken[a] || taken[b]) continue;
    taken[a] = taken[b] = true;
    join(partner, arms[a].end, arms[b].end);
    const std::array gone{marks_of[a][0], marks_of[a][1], marks_of[b][0], marks_of[b][1]};
    for (const std::uint32_t i : gone) {
      next[previous[i]] = next[i];
      previous[next[i]] = previous[i];
    }
    // A removed mark keeps the neighbours that it had. In a run of removed marks, the last one removed has the
    // neighbours that remain.
    for (const std::uint32_t i : gone) {
      if (!taken[marks[previous[i]].arm]) offer(previous[i]);
    }
  }
}

void pair_arms(std::span<const NodeArm> arms, std::span<std::uint32_t> partner) {
  if (arms.size() == 2) {
    join(partner, arms[0].end, arms[1].end);
  } else if (arms.size() > kFewArms) {
    pair_many_arms(arms, partner);
  } else if (arms.size() > 2) {
    pair_few_arms(arms, partner);
  }
}

}  // namespace ligne
