#include "plotting/paths/farthest_point.hpp"

#include <algorithm>
#include <numeric>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "geometry/predicates.hpp"
#include "plotting/paths/segment_distance.hpp"

namespace ligne {
namespace {

/// Points in a block that is searched point by point. Adjustable.
constexpr std::uint32_t kLeaf = 32;

/// Relative rounding of a squared distance and of its bound: a dozen roundings. A block that could raise the distance
/// by less is skipped, so that blocks of equally far points are not all searched.
constexpr double kSameDistance = 0x1p-48;

}  // namespace

struct FarthestPoint::Question {
  std::span<const Point2> points;
  std::uint32_t from, to;
  Point2 along;          ///< direction of the segment; any direction if it has no length
  double squared_along;  ///< squared length of `along`
  double length;         ///< length of the segment times the length of `along`
  Found found;

  void ask(std::uint32_t i) {
    const double distance = squared_distance(points[i], points[from], points[to]);
    if (distance > found.squared_distance || (distance == found.squared_distance && i < found.at)) found = {i, distance};
  }
};

FarthestPoint::FarthestPoint(std::span<const Point2> points) : points_(points), levels_(1) {
  const auto n = static_cast<std::uint32_t>(points.size());
  std::vector<std::uint32_t> sorted(n), merged(n);
  std::iota(sorted.begin(), sorted.end(), 0);
  const auto is_left = [&](std::uint32_t l, std::uint32_t r) {
    return points[l].x != points[r].x ? points[l].x < points[r].x : points[l].y < points[r].y;
  };
  const auto at = [&](std::vector<std::uint32_t>& list, std::uint32_t i) { return list.begin() + std::min(i, n); };
  for (std::uint32_t i = 0; i < n; i += kLeaf) std::stable_sort(at(sorted, i), at(sorted, i + kLeaf), is_left);
  for (std::uint32_t size = 2 * kLeaf; size < 2 * n; size *= 2) {
    levels_.emplace_back();
    for (std::uint32_t i = 0; i < n; i += size) {
      std::merge(at(sorted, i), at(sorted, i + size / 2), at(sorted, i + size / 2), at(sorted, i + size), at(merged, i),
                 is_left);
      add_hull({merged.data() + i, std::min(size, n - i)});
    }
    sorted.swap(merged);
  }
}

/// Andrew's monotone chains.
void FarthestPoint::add_hull(std::span<const std::uint32_t> sorted) {
  const auto add_chain = [&](int turn) {
    const std::size_t begin = corners_.size();
    for (const std::uint32_t i : sorted) {
      if (corners_.size() > begin && points_[corners_.back()] == points_[i]) continue;
      while (corners_.size() > begin + 1 &&
             orientation_sign(points_[corners_.end()[-2]], points_[corners_.back()], points_[i]) != turn) {
        corners_.pop_back();
      }
      corners_.push_back(i);
    }
    return static_cast<std::uint32_t>(begin);
  };
  const std::uint32_t lower = add_chain(1), upper = add_chain(-1);
  Node node{lower, upper, static_cast<std::uint32_t>(corners_.size()), {}};
  for (std::uint32_t k = lower; k < node.end; ++k) node.box.extend(points_[corners_[k]]);
  levels_.back().push_back(node);
}

/// The corner farthest in a direction, between its two neighbours, which may be as far.
std::array<std::uint32_t, 3> FarthestPoint::extreme(const Node& node, Point2 direction) const {
  const bool below = direction.y < 0;
  const std::uint32_t first = below ? node.lower_begin : node.upper_begin;
  const std::uint32_t last = (below ? node.upper_begin : node.end) - 1;
  std::uint32_t low = first, high = last;
  while (low < high) {  // along this chain the distance grows up to the farthest corner
    const std::uint32_t middle = low + (high - low) / 2;
    const bool goes_on = glm::dot(points_[corners_[middle + 1]] - points_[corners_[middle]], direction) > 0;
    (goes_on ? low : high) = goes_on ? middle + 1 : middle;
  }
  return {corners_[low > first ? low - 1 : low], corners_[low], corners_[low < last ? low + 1 : low]};
}

/// Tests the hull's farthest corners along the segment's normal. Returns whether another point of the hull may be
/// farther because it lies beyond an end of the segment.
bool FarthestPoint::may_hold_more(Question& question, const Node& node) const {
  const Point2 begin = points_[question.from], along = question.along, normal{-along.y, along.x};
  double beside = 0;
  for (const Point2 direction : {normal, -normal}) {
    const std::array<std::uint32_t, 3> corners = extreme(node, direction);
    beside = std::max(beside, glm::dot(points_[corners[1]] - begin, direction));
    for (const std::uint32_t i : corners) question.ask(i);
  }
  const auto may_be_farther = [&](double low, double high) {
    const double beyond = std::max(-low, high - question.length);
    const double bound = (beside * beside + beyond * beyond) / question.squared_along;
    return beyond > 0 && bound > question.found.squared_distance * (1 + kSameDistance);
  };
  // The box is tested first, since it is quick.
  const Point2 middle = (node.box.min + node.box.max) * 0.5 - begin, half = (node.box.max - node.box.min) * 0.5;
  const double at = glm::dot(middle, along), reach = glm::dot(half, glm::abs(along));
  return may_be_farther(at - reach, at + reach) && may_be_farther(glm::dot(points_[extreme(node, -along)[1]] - begin, along),
                                                                  glm::dot(points_[extreme(node, along)[1]] - begin, along));
}

void FarthestPoint::look_at(Question& question, std::size_t level, std::uint32_t block) const {
  const std::uint32_t size = kLeaf << level;
  const std::uint32_t low = std::max(block * size, question.from + 1), high = std::min((block + 1) * size, question.to);
  if (low >= high) return;
  if (level == 0) {
    for (std::uint32_t i = low; i < high; ++i) question.ask(i);
    return;
  }
  const bool whole = low == block * size && (high == low + size || high == points_.size());
  if (whole && !may_hold_more(question, levels_[level][block])) return;
  look_at(question, level - 1, 2 * block);
  look_at(question, level - 1, 2 * block + 1);
}

FarthestPoint::Found FarthestPoint::between(std::uint32_t from, std::uint32_t to) const {
  Question question{points_, from, to, points_[to] - points_[from], 0, 0, {from, -1}};
  question.length = glm::dot(question.along, question.along);
  if (!(question.length > 0)) question.along = {1, 0};
  question.squared_along = glm::dot(question.along, question.along);
  look_at(question, levels_.size() - 1, 0);
  return question.found;
}

}  // namespace ligne
