#include "linework/rules/smooth_lines.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <limits>
#include <span>
#include <vector>

#include "base/no_index.hpp"
#include "geometry/point.hpp"
#include "linework/map/continuations.hpp"

namespace ligne {
namespace {

/// Weights of the least-squares parabola through seven equally spaced points: the middle point and those beside it.
constexpr std::array<double, 4> kParabola{7.0 / 21, 6.0 / 21, 3.0 / 21, -2.0 / 21};
constexpr int kReach = 3;
/// Adjustable: two rounds remove a zigzag from point to point, and a circle of twenty points keeps its radius.
constexpr int kRounds = 2;
/// Adjustable: a line has a corner where it turns by more, measured kReach points to either side.
constexpr double kCornerCosine = 0.70710678;  ///< 45 degrees
/// Adjustable: largest shift of a point, as part of the shorter stroke that ends there. A zigzag of equal strokes stays
/// below it. Where long strokes meet short ones, a parabola overshoots.
constexpr double kMostShift = 0.5;

/// Points along a line.
class Line {
 public:
  void add(LatticePoint p) { places_.emplace_back(p.x, p.y); }
  /// Connects the last point to the first one.
  void close() { closed_ = true; }

  LatticePoint at(std::size_t i) const {
    return {static_cast<std::int32_t>(std::lround(places_[i].x)), static_cast<std::int32_t>(std::lround(places_[i].y))};
  }
  std::size_t size() const { return places_.size(); }

  void smooth() {
    const auto n = static_cast<int>(places_.size());
    if (n <= kReach) return;
    // The ends of an open line count as corners.
    std::vector<int> corners;
    for (int i = 0; i < n; ++i) {
      if (is_corner(i)) corners.push_back(i);
    }
    // A ring ends where it begins.
    if (closed_ && !corners.empty()) corners.push_back(corners.front() + n);
    const std::vector<Point2> given = places_;
    for (int round = 0; round < kRounds; ++round) {
      if (corners.empty()) smooth_part(0, n - 1, [&](int i) { return place(i); });
      for (std::size_t c = 0; c + 1 < corners.size(); ++c) {
        const int from = corners[c], to = corners[c + 1];
        if (to - from < kReach) continue;
        // Reflection in the corners keeps them in place.
        smooth_part(from, to, [&](int i) {
          if (i < from) return 2.0 * place(from) - place(2 * from - i);
          return i > to ? 2.0 * place(to) - place(2 * to - i) : place(i);
        });
      }
    }
    limit_shifts(given);
  }

 private:
  std::size_t index(int i) const {
    const auto n = static_cast<int>(places_.size());
    return static_cast<std::size_t>((i + n) % n);
  }
  Point2 place(int i) const { return places_[index(i)]; }

  bool is_corner(int i) const {
    const auto n = static_cast<int>(places_.size());
    if (!closed_ && (i < kReach || i + kReach >= n)) return i == 0 || i == n - 1;
    const Point2 before = place(i) - place(i - kReach), after = place(i + kReach) - place(i);
    return glm::dot(before, after) < kCornerCosine * glm::length(before) * glm::length(after);
  }

  /// Smooths the points `from` to `to`, both included.
  template <class PlaceAt>
  void smooth_part(int from, int to, const PlaceAt& place_at) {
    std::vector<Point2> smooth;
    for (int i = from; i <= to; ++i) {
      Point2 sum = kParabola[0] * place_at(i);
      for (int k = 1; k <= kReach; ++k) {
        sum = sum + kParabola[static_cast<std::size_t>(k)] * (place_at(i - k) + place_at(i + k));
      }
      smooth.push_back(sum);
    }
    for (int i = from; i <= to; ++i) places_[index(i)] = smooth[static_cast<std::size_t>(i - from)];
  }

  /// Moves points back so that none has moved too far.
  void limit_shifts(const std::vector<Point2>& given) {
    const auto n = static_cast<int>(places_.size());
    for (int i = 0; i < n; ++i) {
      double shorter = std::numeric_limits<double>::infinity();
      if (closed_ || i > 0) shorter = glm::length(given[index(i)] - given[index(i - 1)]);
      if (closed_ || i + 1 < n) shorter = std::min(shorter, glm::length(given[index(i + 1)] - given[index(i)]));
      const Point2 shift = place(i) - given[index(i)];
      const double by = glm::length(shift), most = kMostShift * shorter;
      if (by > most) places_[index(i)] = given[index(i)] + (most / by) * shift;
    }
  }

  std::vector<Point2> places_;
  bool closed_ = false;
};

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
    Line line;
    for (const std::uint32_t end : ends) line.add(end_point(strokes, end));
    is_ring ? line.close() : line.add(end_point(strokes, ends.back() ^ 1));
    line.smooth();
    for (std::size_t i = 0; i < ends.size(); ++i) {
      moved += line.at(i) != end_point(strokes, ends[i]);
      end_point(strokes, ends[i]) = line.at(i);
      end_point(strokes, ends[i] ^ 1) = line.at((i + 1) % line.size());
    }
  };
  for_each_line(continuations(strokes, rough), LineOrder::strokes, smooth);
  return moved;
}

}  // namespace ligne
