#include "linework/stroke_arcs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>

#include "base/disjoint_sets.hpp"
#include "base/key_table.hpp"
#include "base/no_index.hpp"
#include "linework/overlaps/stroke_index.hpp"
#include "linework/overlaps/stroke_overlap.hpp"

namespace ligne {
namespace {

/// A place inside a stroke at which another one ends.
struct Junction {
  std::uint32_t stroke;
  double fraction;
  std::uint32_t node;
};

class ArcBuilder {
 public:
  ArcBuilder(const std::vector<Stroke>& strokes, std::span<const std::uint32_t> members, double tolerance)
      : strokes_(strokes), members_(members), tolerance_(tolerance) {}

  std::vector<StrokeArc> build() {
    number_nodes();
    cut(junctions());
    link();
    std::vector<StrokeArc> arcs;
    walked_.assign(parts_.size(), false);
    for (std::uint32_t end = 0; end < 2 * parts_.size(); ++end) {
      if (next_[end] == kNone && !walked_[end / 2]) arcs.push_back(walk(end));
    }
    for (std::uint32_t part = 0; part < parts_.size(); ++part) {
      if (walked_[part]) continue;
      arcs.push_back(walk(2 * part));
      arcs.back().closed = true;
    }
    return arcs;
  }

 private:
  std::uint32_t node_at(LatticePoint p) {
    std::uint32_t& node = nodes_[KeyTable::key(p)];
    if (node == kNone) {
      node = static_cast<std::uint32_t>(points_.size());
      points_.push_back(p);
    }
    return node;
  }

  void number_nodes() {
    for (const std::uint32_t m : members_) {
      node_at(strokes_[m].from);
      node_at(strokes_[m].to);
    }
  }

  void meet(std::uint32_t node, std::uint32_t stroke, const SegmentGrid& grid, std::vector<Junction>& found);
  std::vector<Junction> junctions();
  void cut(std::vector<Junction> junctions);
  void link();
  StrokeArc walk(std::uint32_t end);

  const std::vector<Stroke>& strokes_;
  std::span<const std::uint32_t> members_;
  double tolerance_;
  KeyTable nodes_;
  std::vector<LatticePoint> points_;                           ///< of the nodes
  std::vector<std::pair<std::uint32_t, std::uint32_t>> same_;  ///< nodes within the tolerance of each other
  std::vector<ArcPart> parts_;
  std::vector<std::array<std::uint32_t, 2>> part_nodes_;
  std::vector<std::uint32_t> next_;  ///< per end of a part (2 i its from, 2 i + 1 its to) the end that continues it
  std::vector<bool> walked_;
};

/// Where two strokes cross inside both, as fractions of them.
std::optional<std::array<double, 2>> crossing(const Stroke& a, const Stroke& b) {
  const double a0 = orientation(b.from, b.to, a.from), a1 = orientation(b.from, b.to, a.to);
  const double b0 = orientation(a.from, a.to, b.from), b1 = orientation(a.from, a.to, b.to);
  if (!(a0 * a1 < 0 && b0 * b1 < 0)) return {};
  return {{a0 / (a0 - a1), b0 / (b0 - b1)}};
}

/// A node that lies on a stroke is a junction inside it, or one with its end.
void ArcBuilder::meet(std::uint32_t node, std::uint32_t stroke, const SegmentGrid& grid, std::vector<Junction>& found) {
  const Stroke& s = strokes_[stroke];
  const LatticePoint p = points_[node];
  const double size = length(s.from, s.to);
  if (!(size > 0) || !grid.near(p, s.from, s.to, size)) return;
  if (length(p, s.from) <= tolerance_) {
    same_.emplace_back(node, node_at(s.from));
    return;
  }
  if (length(p, s.to) <= tolerance_) {
    same_.emplace_back(node, node_at(s.to));
    return;
  }
  const double along =
      (double(p.x) - s.from.x) * (double(s.to.x) - s.from.x) + (double(p.y) - s.from.y) * (double(s.to.y) - s.from.y);
  const double fraction = along / (size * size);
  if (fraction > 0 && fraction < 1) found.push_back({stroke, fraction, node});
}

std::vector<Junction> ArcBuilder::junctions() {
  const std::vector<std::uint32_t> members(members_.begin(), members_.end());
  const SegmentGrid grid(index_cell(strokes_, members, tolerance_), tolerance_);
  // The strokes of each cell as linked lists.
  struct Entry {
    std::uint32_t stroke, next;
  };
  KeyTable cells;
  std::vector<Entry> entries;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> crossed;
  for (const std::uint32_t m : members_) {
    grid.walk(strokes_[m].from, strokes_[m].to, [&](std::uint64_t key) {
      std::uint32_t& first = cells[key];
      for (std::uint32_t e = first; e != kNone; e = entries[e].next) {
        if (crossing(strokes_[m], strokes_[entries[e].stroke])) crossed.emplace_back(m, entries[e].stroke);
      }
      entries.push_back({m, first});
      first = static_cast<std::uint32_t>(entries.size() - 1);
      return false;
    });
  }
  std::vector<Junction> found;
  const auto ends = static_cast<std::uint32_t>(points_.size());
  for (std::uint32_t node = 0; node < ends; ++node) {
    for (std::uint32_t e = cells.find(grid.cell_of(points_[node])); e != kNone; e = entries[e].next) {
      meet(node, entries[e].stroke, grid, found);
    }
  }
  std::sort(crossed.begin(), crossed.end());
  crossed.erase(std::unique(crossed.begin(), crossed.end()), crossed.end());
  for (const auto& [a, b] : crossed) {
    const auto [at_a, at_b] = *crossing(strokes_[a], strokes_[b]);
    const Stroke& s = strokes_[a];
    const std::uint32_t node =
        node_at({static_cast<std::int32_t>(std::lround(s.from.x + at_a * (double(s.to.x) - s.from.x))),
                 static_cast<std::int32_t>(std::lround(s.from.y + at_a * (double(s.to.y) - s.from.y)))});
    found.insert(found.end(), {{a, at_a, node}, {b, at_b, node}});
  }
  return found;
}

void ArcBuilder::cut(std::vector<Junction> junctions) {
  std::sort(junctions.begin(), junctions.end(), [](const Junction& a, const Junction& b) {
    return std::tie(a.stroke, a.fraction, a.node) < std::tie(b.stroke, b.fraction, b.node);
  });
  for (const std::uint32_t m : members_) {
    const Stroke& s = strokes_[m];
    if (s.from == s.to) continue;
    double from = 0;
    std::uint32_t node = node_at(s.from);
    const auto add = [&](double to, std::uint32_t to_node) {
      parts_.push_back({m, from, to, points_[node], points_[to_node], false});
      part_nodes_.push_back({node, to_node});
      from = to;
      node = to_node;
    };
    auto junction = std::lower_bound(junctions.begin(), junctions.end(), m,
                                     [](const Junction& j, std::uint32_t stroke) { return j.stroke < stroke; });
    for (; junction != junctions.end() && junction->stroke == m; ++junction) {
      if (junction->fraction > from) add(junction->fraction, junction->node);
    }
    add(1, node_at(s.to));
  }
}

/// Two ends that meet alone continue each other.
void ArcBuilder::link() {
  DisjointSets nodes(points_.size());
  for (const auto& [a, b] : same_) nodes.join(a, b);
  std::vector<std::array<std::uint32_t, 2>> ends(points_.size(), {kNone, kNone});
  std::vector<std::uint8_t> count(points_.size(), 0);
  for (std::uint32_t part = 0; part < parts_.size(); ++part) {
    const std::array met{nodes.find(part_nodes_[part][0]), nodes.find(part_nodes_[part][1])};
    if (met[0] == met[1]) continue;  // within the tolerance: no more than a point
    for (std::uint32_t k = 0; k < 2; ++k) {
      const std::uint32_t node = met[k];
      if (count[node] < 2) ends[node][count[node]] = 2 * part + k;
      count[node] = std::min<std::uint8_t>(count[node] + 1, 3);
    }
  }
  next_.assign(2 * parts_.size(), kNone);
  for (std::size_t node = 0; node < ends.size(); ++node) {
    if (count[node] != 2) continue;
    next_[ends[node][0]] = ends[node][1];
    next_[ends[node][1]] = ends[node][0];
  }
}

StrokeArc ArcBuilder::walk(std::uint32_t end) {
  StrokeArc arc;
  while (end != kNone && !walked_[end / 2]) {
    walked_[end / 2] = true;
    arc.parts.push_back(parts_[end / 2]);
    arc.parts.back().reversed = end % 2 == 1;
    end = next_[end ^ 1];
  }
  return arc;
}

}  // namespace

std::vector<StrokeArc> stroke_arcs(const std::vector<Stroke>& strokes, std::span<const std::uint32_t> members,
                                   double tolerance_steps) {
  return ArcBuilder(strokes, members, tolerance_steps).build();
}

}  // namespace ligne
