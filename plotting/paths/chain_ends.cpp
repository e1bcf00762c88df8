#include "plotting/paths/chain_ends.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "base/no_index.hpp"
#include "base/parallel.hpp"
#include "linework/map/continuations.hpp"
#include "geometry/nearest_points.hpp"
#include "plotting/paths/path_length.hpp"

namespace ligne {
namespace {

/// Nearest ends that are tried for each loose end. Adjustable.
constexpr std::size_t kCandidates = 8;

struct Pair {
  double squared;
  std::uint32_t a, b;  ///< loose ends, a < b
};

/// Pairs of loose ends within the tolerance, the nearest first. End 2 i is the first point of line i, end 2 i + 1 its
/// last.
std::vector<Pair> near_pairs(const Polylines& lines, double tolerance_mm) {
  std::vector<std::uint32_t> ends;
  std::vector<Point2> points;
  for (std::uint32_t i = 0; i < lines.size(); ++i) {
    if (is_loop(lines[i])) continue;
    for (const bool last : {false, true}) {
      ends.push_back(2 * i + last);
      points.push_back(last ? lines[i].back() : lines[i].front());
    }
  }
  const NearestPoints tree(points);
  std::vector<std::vector<Pair>> found(ends.size());
  parallel_blocks(ends.size(), kSearchBlock, [&](std::size_t first, std::size_t last) {
    std::vector<NearestPoints::Neighbour> neighbours;
    for (std::size_t e = first; e < last; ++e) {
      tree.nearest(points[e], kCandidates + 1, neighbours);
      for (const NearestPoints::Neighbour& n : neighbours) {
        if (n.squared > tolerance_mm * tolerance_mm) break;
        if (n.point != e)
          found[e].push_back({n.squared, std::min(ends[e], ends[n.point]), std::max(ends[e], ends[n.point])});
      }
    }
  });
  std::vector<Pair> pairs;
  for (const std::vector<Pair>& of_end : found) pairs.insert(pairs.end(), of_end.begin(), of_end.end());
  const auto key = [](const Pair& p) { return std::tie(p.squared, p.a, p.b); };
  std::sort(pairs.begin(), pairs.end(), [&](const Pair& l, const Pair& r) { return key(l) < key(r); });
  return pairs;
}

}  // namespace

Polylines join_near_ends(const Polylines& lines, double tolerance_mm) {
  if (!(tolerance_mm > 0)) return lines;
  std::vector<std::uint32_t> partner(2 * lines.size(), kNone);
  for (const Pair& pair : near_pairs(lines, tolerance_mm)) {
    if (partner[pair.a] != kNone || partner[pair.b] != kNone) continue;
    if (pair.a / 2 == pair.b / 2 && path_length(lines[pair.a / 2]) <= kLoopLengths * std::sqrt(pair.squared)) continue;
    partner[pair.a] = pair.b;
    partner[pair.b] = pair.a;
  }

  Polylines out;
  for_each_line(partner, LineOrder::strokes, [&](std::span<const std::uint32_t> ends, bool is_ring) {
    const std::size_t first = out.points.size();
    for (const std::uint32_t end : ends) {
      const auto line = lines[end / 2];
      const auto add = [&](Point2 p) {
        if (out.points.size() == first || out.points.back() != p) out.points.push_back(p);
      };
      if (end % 2 == 0) {
        std::for_each(line.begin(), line.end(), add);
      } else {
        std::for_each(line.rbegin(), line.rend(), add);
      }
    }
    if (is_ring && out.points.back() != out.points[first]) out.points.push_back(out.points[first]);
    out.begin.push_back(static_cast<std::uint32_t>(out.points.size()));
  });
  return out;
}

}  // namespace ligne
