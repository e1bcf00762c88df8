#include "linework/rules/rules.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <glm/geometric.hpp>
#include <span>
#include <vector>

#include "base/no_index.hpp"
#include "geometry/point.hpp"
#include "linework/map/continuations.hpp"
#include "linework/stroke_geometry.hpp"

namespace ligne {
namespace {

/// Points before and behind a point over which the turn of the line there is measured.
constexpr int kReach = 3;
/// Adjustable: the line has a corner where it turns by more than 45 degrees.
constexpr double kCornerCosine = 0.70710678;
/// Rounds of smoothing, and the parts of the way to the middle of its neighbours by which a point moves in each: first
/// towards it, which removes a zigzag from point to point, then back, so that circles keep their radii [Taubin1995].
/// Adjustable.
constexpr int kRounds = 8;
constexpr std::array<double, 2> kParts{0.5, -0.53};
/// Adjustable: largest shift of a point, as part of the shorter stroke that ends there. A zigzag of equal strokes stays
/// below it.
constexpr double kMostShift = 0.5;

/// The points of a line, smoothed. A closed line goes on from its last point to its first. Ends and corners stay.
std::vector<Point2> smoothed(const std::vector<Point2>& given, bool is_closed) {
  const auto n = static_cast<int>(given.size());
  const auto index = [&](int i) { return static_cast<std::size_t>((i + n) % n); };
  const auto may_move = [&](int i) {
    if (!is_closed && (i < kReach || i + kReach >= n)) return i > 0 && i + 1 < n;
    const Point2 before = given[index(i)] - given[index(i - kReach)], after = given[index(i + kReach)] - given[index(i)];
    return glm::dot(before, after) >= kCornerCosine * glm::length(before) * glm::length(after);
  };
  std::vector<int> moving;
  for (int i = 0; n > kReach && i < n; ++i) {
    if (may_move(i)) moving.push_back(i);
  }
  std::vector<Point2> places = given;
  for (int round = 0; round < kRounds; ++round) {
    for (const double part : kParts) {
      const std::vector<Point2> old = places;
      for (const int i : moving) {
        places[index(i)] += part * ((old[index(i - 1)] + old[index(i + 1)]) * 0.5 - old[index(i)]);
      }
    }
  }
  for (const int i : moving) {
    const Point2 at = given[index(i)], shift = places[index(i)] - at;
    const double shorter = std::min(glm::distance(at, given[index(i - 1)]), glm::distance(at, given[index(i + 1)]));
    const double by = glm::length(shift), most = kMostShift * shorter;
    if (by > most) places[index(i)] = at + (most / by) * shift;
  }
  return places;
}

LatticePoint& end_point(std::vector<Stroke>& strokes, std::uint32_t end) {
  return end % 2 == 0 ? strokes[end / 2].from : strokes[end / 2].to;
}

/// The ends that continue each other in rough lines: exactly two strokes meet there, both rough and of equal visibility.
std::vector<std::uint32_t> continuations(const std::vector<Stroke>& strokes, const std::vector<std::uint8_t>& is_rough) {
  const Nodes nodes(strokes);
  std::vector<std::uint32_t> partner(nodes.end_count(), kNone);
  for (std::uint32_t end = 0; end < nodes.end_count(); ++end) {
    const std::uint32_t other = is_rough[end / 2] ? nodes.other(end) : kNone;
    if (other == kNone || !is_rough[other / 2] || other / 2 == end / 2) continue;
    const Stroke &a = strokes[end / 2], &b = strokes[other / 2];
    if (a.visible == b.visible && a.level == b.level) partner[end] = other;
  }
  return partner;
}

}  // namespace

std::size_t smooth_lines(StrokeModel& model, const std::function<bool(const Stroke&)>& is_rough) {
  std::vector<Stroke>& strokes = model.strokes;
  std::vector<std::uint8_t> rough(strokes.size(), 0);
  for (std::size_t i = 0; i < strokes.size(); ++i) rough[i] = is_rough(strokes[i]);
  if (std::ranges::find(rough, 1) == rough.end()) return 0;
  std::size_t moved = 0;
  const auto smooth = [&](std::span<const std::uint32_t> ends, bool is_ring) {
    if (!rough[ends.front() / 2]) return;
    std::vector<Point2> line;
    const auto add = [&](LatticePoint p) { line.emplace_back(p.x, p.y); };
    for (const std::uint32_t end : ends) add(end_point(strokes, end));
    if (!is_ring) add(end_point(strokes, ends.back() ^ 1));
    line = smoothed(line, is_ring);
    const auto rounded = [&](std::size_t i) { return nearest_step(line[i].x, line[i].y); };
    for (std::size_t i = 0; i < ends.size(); ++i) {
      const LatticePoint p = rounded(i);
      moved += p != end_point(strokes, ends[i]);
      end_point(strokes, ends[i]) = p;
      end_point(strokes, ends[i] ^ 1) = rounded((i + 1) % line.size());
    }
  };
  for_each_line(continuations(strokes, rough), LineOrder::strokes, smooth);
  return moved;
}

}  // namespace ligne
