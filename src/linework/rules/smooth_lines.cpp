#include "linework/rules/smooth_lines.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>
#include <vector>

#include "base/key_table.hpp"
#include "base/no_index.hpp"
#include "geometry/point.hpp"

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

/// End 2 i is the `from` of stroke i, end 2 i + 1 its `to`.
class LineSmoother {
 public:
  LineSmoother(std::vector<Stroke>& strokes, const std::function<bool(const Stroke&)>& is_rough) : strokes_(strokes) {
    for (std::uint32_t i = 0; i < strokes.size(); ++i) {
      if (is_rough(strokes[i])) rough_.push_back(i);
    }
    if (rough_.empty()) return;
    for (const std::uint32_t i : rough_) {
      for (const LatticePoint p : {strokes[i].from, strokes[i].to}) {
        std::uint32_t& node = nodes_[KeyTable::key(p)];
        if (node != kNone) continue;
        node = static_cast<std::uint32_t>(arms_.size());
        arms_.push_back({});
      }
    }
    for (std::uint32_t i = 0; i < strokes.size(); ++i) {
      add_arm(strokes[i].from, 2 * i);
      add_arm(strokes[i].to, 2 * i + 1);
    }
    is_rough_.assign(strokes.size(), 0);
    for (const std::uint32_t i : rough_) is_rough_[i] = 1;
  }

  /// Returns the number of points moved.
  std::size_t run() {
    std::size_t moved = 0;
    done_.assign(strokes_.size(), 0);
    for (const std::uint32_t i : rough_) {
      if (done_[i]) continue;
      // Goes back to the beginning of the line, or once around the ring.
      std::uint32_t first = 2 * i;
      for (std::uint32_t back = next(first); back != kNone; back = next(first)) {
        first = back ^ 1;
        if (first == 2 * i) break;
      }
      moved += smooth_from(first);
    }
    // Moves points only now, because next() finds strokes by the points of their ends.
    for (const auto& [end, to] : smooth_) point(end) = to;
    return moved;
  }

 private:
  struct Arms {
    std::array<std::uint32_t, 2> ends{};
    std::uint32_t count = 0;
  };

  LatticePoint& point(std::uint32_t end) { return end % 2 == 0 ? strokes_[end / 2].from : strokes_[end / 2].to; }

  void add_arm(LatticePoint p, std::uint32_t end) {
    const std::uint32_t node = nodes_.find(KeyTable::key(p));
    if (node == kNone) return;
    if (arms_[node].count < 2) arms_[node].ends[arms_[node].count] = end;
    ++arms_[node].count;
  }

  /// Returns the near end of the stroke that continues a rough line at `end`, or kNone.
  std::uint32_t next(std::uint32_t end) {
    const Arms& arms = arms_[nodes_.find(KeyTable::key(point(end)))];
    if (arms.count != 2) return kNone;
    const std::uint32_t other = arms.ends[0] == end ? arms.ends[1] : arms.ends[0];
    const Stroke &a = strokes_[end / 2], &b = strokes_[other / 2];
    const bool alike = is_rough_[other / 2] && a.visible == b.visible && a.level == b.level;
    return alike && end / 2 != other / 2 ? other : kNone;
  }

  std::size_t smooth_from(std::uint32_t first) {
    Line line;
    std::vector<std::uint32_t> ends;  // the first end of each stroke, in the direction of the line
    for (std::uint32_t end = first; end != kNone && !done_[end / 2]; end = next(end ^ 1)) {
      done_[end / 2] = 1;
      ends.push_back(end);
      line.add(point(end));
    }
    const std::uint32_t last = ends.back() ^ 1;
    if (next(last) == first) {
      line.close();
    } else {
      line.add(point(last));
    }
    line.smooth();
    std::size_t moved = 0;
    for (std::size_t i = 0; i < ends.size(); ++i) {
      moved += line.at(i) != point(ends[i]);
      smooth_.push_back({ends[i], line.at(i)});
      smooth_.push_back({ends[i] ^ 1, line.at((i + 1) % line.size())});
    }
    return moved;
  }

  std::vector<Stroke>& strokes_;
  std::vector<std::uint32_t> rough_;
  std::vector<std::uint8_t> is_rough_, done_;  ///< by stroke
  KeyTable nodes_;
  std::vector<Arms> arms_;                                      ///< by node
  std::vector<std::pair<std::uint32_t, LatticePoint>> smooth_;  ///< ends and their new points
};

}  // namespace

std::size_t smooth_lines(StrokeModel& model, const std::function<bool(const Stroke&)>& is_rough) {
  return LineSmoother(model.strokes, is_rough).run();
}

}  // namespace ligne
