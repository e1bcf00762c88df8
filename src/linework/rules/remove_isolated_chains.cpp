#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "base/disjoint_sets.hpp"
#include "base/no_index.hpp"
#include "base/parallel.hpp"
#include "linework/rules/rules.hpp"
#include "linework/stroke_geometry.hpp"

namespace ligne {
namespace {

/// A ring that is removed may be longer by so much: it is a sliver, of which either side may be such a chain. Taste.
constexpr double kRingTimes = 1.5;
/// Largest distance of the points of a straight line from its axis, in widths of a ring. Taste.
constexpr double kStraightInRings = 0.5;

double diagonal(const Rect& box) { return std::sqrt(box.width() * box.width() + box.height() * box.height()); }

/// Lines that are connected by nodes and contacts.
struct Cluster {
  Rect box;                                                  ///< bounding box
  double longest = std::numeric_limits<double>::infinity();  ///< lattice steps; a larger cluster stays
  bool has_ring = false, is_removed = false;
  std::vector<std::uint32_t> sources{};  ///< its edges, one more than it may have at most, if their number is limited
  std::vector<LatticePoint> points{};    ///< ends of its pieces, if it must lie on one line and is small
};

/// Whether all points lie within `width` steps of the line between two of them that are far apart.
bool lie_on_one_line(const std::vector<LatticePoint>& points, double width) {
  const auto farthest = [&](LatticePoint from) {
    return *std::ranges::max_element(points, {}, [&](LatticePoint p) { return length(from, p); });
  };
  Stroke axis;
  axis.from = farthest(points.front());
  axis.to = farthest(axis.from);
  return std::ranges::all_of(points, [&](LatticePoint p) { return foot_on(axis, p).distance <= width; });
}

}  // namespace

std::vector<std::uint32_t> bodies_of(const LineMap& map, const BodyOf& body_of) {
  std::vector<std::uint32_t> bodies(map.piece_count(), kNone);
  parallel_blocks(bodies.size(), kShortWorkBlock, [&](std::size_t begin, std::size_t end) {
    for (auto p = static_cast<std::uint32_t>(begin); p < end; ++p) {
      if (map.is_alive(p)) bodies[p] = body_of(map.piece(p));
    }
  });
  return bodies;
}

std::vector<double> longest_of_bodies(const LineMap& map, std::span<const std::uint32_t> bodies, double longest_mm,
                                      double body_part, std::span<const double> factors) {
  std::vector<Rect> extents;
  for (std::uint32_t p = 0; p < map.piece_count(); ++p) {
    const std::uint32_t body = bodies[p];
    if (body == kNone) continue;
    if (body >= extents.size()) extents.resize(body + 1);
    for (const LatticePoint end : {map.piece(p).from, map.piece(p).to}) extents[body].extend({end.x, end.y});
  }
  std::vector<double> longest(extents.size());
  for (std::size_t b = 0; b < extents.size(); ++b) {
    const double part = factors.empty() ? body_part : factors[b] * body_part;
    longest[b] = std::min(longest_mm / map.step_mm(), part * diagonal(extents[b]));
  }
  return longest;
}

std::size_t remove_isolated_chains(LineMap& map, const BodyOf& body_of, const IsolatedLimits& limits) {
  const Nodes& nodes = map.nodes();
  DisjointSets sets(nodes.end_count());  // of nodes
  std::vector<std::uint32_t> in_rings;   // nodes
  const auto connect = [&](std::uint32_t a, std::uint32_t b) {
    if (sets.find(a) == sets.find(b)) in_rings.push_back(a);
    sets.join(a, b);
  };
  for (std::uint32_t p = 0; p < map.piece_count(); ++p) {
    if (map.is_alive(p)) connect(nodes.of(2 * p), nodes.of(2 * p + 1));
  }
  for (const Contact& contact : map.contacts()) {
    if (map.holds(contact)) connect(contact.node, contact.other);
  }
  std::vector<std::uint32_t> number(nodes.end_count(), kNone);  // by the node that stands for a cluster
  std::vector<Cluster> clusters;
  const auto cluster_at = [&](std::uint32_t node) -> Cluster& {
    std::uint32_t& n = number[sets.find(node)];
    if (n == kNone) n = static_cast<std::uint32_t>(clusters.size()), clusters.emplace_back();
    return clusters[n];
  };
  for (const std::uint32_t node : in_rings) cluster_at(node).has_ring = true;
  // How many times as large a cluster may be whose points lie on one line.
  const auto times_of = [&](const Cluster& cluster) { return cluster.has_ring ? kRingTimes : limits.straight_times; };
  const std::vector<std::uint32_t> bodies = bodies_of(map, body_of);
  const auto longest = longest_of_bodies(map, bodies, limits.longest_mm, limits.body_part, limits.factors);
  for (std::uint32_t p = 0; p < map.piece_count(); ++p) {
    if (!map.is_alive(p)) continue;
    Cluster& cluster = cluster_at(nodes.of(2 * p));
    const std::uint32_t body = is_feature(map.piece(p)) ? bodies[p] : kNone;
    cluster.longest = std::min(cluster.longest, body == kNone ? 0 : longest[body]);
    add_source(cluster.sources, map.piece(p).source, limits.most_sources);
    for (const LatticePoint end : {map.piece(p).from, map.piece(p).to}) {
      cluster.box.extend({end.x, end.y});
      if (times_of(cluster) > 1 && diagonal(cluster.box) <= times_of(cluster) * cluster.longest)
        cluster.points.push_back(end);
    }
  }
  const double ring_width = limits.ring_width_mm / map.step_mm();
  std::size_t removed = 0;
  for (Cluster& cluster : clusters) {
    const double size = diagonal(cluster.box), width = cluster.has_ring ? ring_width : kStraightInRings * ring_width;
    cluster.is_removed = cluster.box.width() >= 0 && cluster.sources.size() <= limits.most_sources &&
                         size <= times_of(cluster) * cluster.longest &&
                         ((!cluster.has_ring && size <= cluster.longest) || lie_on_one_line(cluster.points, width));
    removed += cluster.is_removed;
  }
  for (std::uint32_t p = 0; p < map.piece_count(); ++p) {
    if (map.is_alive(p) && cluster_at(nodes.of(2 * p)).is_removed) map.remove(p);
  }
  return removed;
}

}  // namespace ligne
