#include "plotting/paths/inside_first.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace ligne {
namespace {

constexpr std::uint32_t kOutside = std::numeric_limits<std::uint32_t>::max();

/// Counts the crossings of a ray to the right: an odd number means inside.
bool is_inside(std::span<const Point2> loop, Point2 p) {
  bool inside = false;
  for (std::size_t i = 1; i < loop.size(); ++i) {
    const Point2 a = loop[i - 1], b = loop[i];
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
  }
  return inside;
}

double area_of(const Rect& box) { return (box.max.x - box.min.x) * (box.max.y - box.min.y); }

/// For each stroke the smallest closed one that it lies in, or kOutside. Sweeps down the page.
std::vector<std::uint32_t> surrounders(const Polylines& lines) {
  const auto n = static_cast<std::uint32_t>(lines.size());
  std::vector<Rect> boxes(n);
  std::vector<std::uint32_t> strokes(n), loops;
  std::iota(strokes.begin(), strokes.end(), 0u);
  for (std::uint32_t s = 0; s < n; ++s) {
    for (const Point2 p : lines[s]) boxes[s].extend(p);
    if (lines[s].size() > 3 && lines[s].front() == lines[s].back()) loops.push_back(s);
  }
  std::erase_if(strokes, [&](std::uint32_t s) { return lines[s].empty(); });
  std::ranges::sort(strokes, {}, [&](std::uint32_t s) { return std::pair(lines[s].front().y, s); });
  std::ranges::sort(loops, {}, [&](std::uint32_t s) { return std::pair(boxes[s].min.y, s); });
  std::vector<std::uint32_t> around(n, kOutside), open;
  std::size_t next = 0;
  for (const std::uint32_t s : strokes) {
    const Point2 p = lines[s].front();
    for (; next < loops.size() && boxes[loops[next]].min.y <= p.y; ++next) open.push_back(loops[next]);
    std::erase_if(open, [&](std::uint32_t loop) { return boxes[loop].max.y < p.y; });
    const double own = area_of(boxes[s]);
    double smallest = std::numeric_limits<double>::infinity();
    for (const std::uint32_t loop : open) {
      const Rect& box = boxes[loop];
      const double area = area_of(box);
      if (loop == s || p.x < box.min.x || p.x > box.max.x || area <= own || area >= smallest) continue;
      if (!is_inside(lines[loop], p)) continue;
      smallest = area;
      around[s] = loop;
    }
  }
  return around;
}

}  // namespace

std::vector<std::uint32_t> inside_first(const Polylines& lines, const std::vector<std::uint32_t>& order) {
  const std::vector<std::uint32_t> around = surrounders(lines);
  std::vector<std::vector<std::uint32_t>> inside(lines.size());
  for (const std::uint32_t s : order) {
    if (around[s] != kOutside) inside[around[s]].push_back(s);
  }
  std::vector<std::uint8_t> is_drawn(lines.size(), 0);
  std::vector<std::uint32_t> result;
  struct Visit {
    std::uint32_t stroke;
    std::size_t next;  ///< index of the next stroke inside it
  };
  std::vector<Visit> stack;
  for (const std::uint32_t first : order) {
    if (!is_drawn[first]) stack.push_back({first, 0});
    while (!stack.empty()) {
      Visit& visit = stack.back();
      if (visit.next < inside[visit.stroke].size()) {
        const std::uint32_t within = inside[visit.stroke][visit.next++];
        if (!is_drawn[within]) stack.push_back({within, 0});
        continue;
      }
      is_drawn[visit.stroke] = 1;
      result.push_back(visit.stroke);
      stack.pop_back();
    }
  }
  return result;
}

}  // namespace ligne
