#include <algorithm>
#include <functional>
#include <queue>
#include <utility>
#include <vector>

#include "base/key_table.hpp"
#include "linework/map/line_groups.hpp"
#include "linework/rules/rules.hpp"
#include "linework/stroke_geometry.hpp"

namespace ligne {
namespace {

/// Most rounds; adjustable. Removing a dangle may make the line that it left part of another dangle.
constexpr int kMostPruningRounds = 8;
/// Largest length of another path between the ends of an arc, as a multiple of the arc. Taste.
constexpr double kDetour = 2;

class DanglePruner {
 public:
  DanglePruner(LineMap& map, const BodyOf& body_of, const DangleLimits& limits)
      : map_(map),
        arcs_(map, limits.touching_mm / map.step_mm()),
        limits_(limits),
        beside_(limits.beside_mm / map.step_mm()),
        body_(bodies_of(map, body_of)),
        longest_(longest_of_bodies(map, body_, limits.longest_mm, limits.body_part, limits.factors)) {
    for (std::uint32_t p = 0; p < map.piece_count(); ++p) {
      if (map.piece(p).line_class != LineClass::outline) body_[p] = kNone;
    }
  }

  std::size_t prune() {
    std::size_t count = 0;
    for (int round = 0; round < kMostPruningRounds; ++round) {
      std::vector<Arcs::Arc> arcs = short_arcs();
      std::ranges::sort(arcs, {}, [](const Arcs::Arc& arc) { return std::pair(arc.length, arc.pieces.front()); });
      const std::size_t before = count;
      for (const Arcs::Arc& arc : arcs) {
        if (!is_dangle(arc)) continue;
        arcs_.take_away(arc);
        for (const std::uint32_t p : arc.pieces) map_.remove(p);
        ++count;
      }
      if (count == before) break;
    }
    return count;
  }

 private:
  /// The arcs between junctions that are short enough for dangles.
  std::vector<Arcs::Arc> short_arcs() const {
    const double longest = longest_.empty() ? 0 : std::ranges::max(longest_);
    std::vector<Arcs::Arc> found;
    for (std::uint32_t end = 0; end < 2 * map_.piece_count(); ++end) {
      // Such an arc ends where one piece ends or more than two do. It is found from both of its ends.
      if (body_[end / 2] == kNone || !arcs_.has(end / 2) || arcs_.degree(arcs_.junction_of(end)) == 2) continue;
      Arcs::Arc arc = arcs_.from(end, limits_.beside_times * longest);
      if (!arc.pieces.empty() && end <= (arc.ends.back() ^ 1)) found.push_back(std::move(arc));
    }
    return found;
  }

  bool is_dangle(const Arcs::Arc& arc) {
    const std::uint32_t body = body_[arc.pieces.front()];
    if (body == kNone || arc.junctions.size() != 2) return false;
    if (!std::ranges::all_of(arc.pieces, [&](std::uint32_t p) { return body_[p] == body; })) return false;
    // Keeps an arc that only joins lines: the end that it joined would be joined again.
    if (std::ranges::all_of(arc.pieces, [&](std::uint32_t p) { return map_.piece(p).is_joint; })) return false;
    if (arc.length > limits_.beside_times * longest_[body] || has_more_sources(arc)) return false;
    const auto [fewer, more] = std::minmax({arcs_.degree(arc.junctions[0]), arcs_.degree(arc.junctions[1])});
    // Such a junction of two arcs was one of three before a dangle was removed, so this arc is now part of a longer
    // line.
    if (fewer == 2 || more == 2) return false;
    if (arc.length <= longest_[body] && fewer == 1 && more > 2) return true;
    return std::ranges::all_of(arc.pieces, [&](std::uint32_t p) { return runs_beside(p, arc); }) &&
           (fewer == 1 || has_detour(arc));
  }

  /// Whether an arc consists of more edges than a dangle may.
  bool has_more_sources(const Arcs::Arc& arc) const {
    std::vector<std::uint32_t> sources;
    for (const std::uint32_t p : arc.pieces) add_source(sources, map_.piece(p).source, limits_.most_sources);
    return sources.size() > limits_.most_sources;
  }

  static bool has(const Arcs::Arc& arc, std::uint32_t piece) { return std::ranges::binary_search(arc.pieces, piece); }

  /// Whether a path that avoids the arc leads from one of its junctions to the other, no longer than kDetour times the arc
  /// and its distance from the path. Searches for the shortest path (Dijkstra, A note on two problems in connexion with
  /// graphs, 1959).
  bool has_detour(const Arcs::Arc& arc) const {
    const double longest = kDetour * (arc.length + beside_);
    using Path = std::pair<double, std::uint32_t>;  // length of the path, and the junction at its end
    std::priority_queue<Path, std::vector<Path>, std::greater<>> paths({}, {{0, arc.junctions[0]}});
    KeyTable done;  // junctions
    while (!paths.empty()) {
      const auto [length, junction] = paths.top();
      paths.pop();
      if (std::exchange(done[junction], 0) != kNone) continue;
      if (junction == arc.junctions[1]) return true;
      for (const std::uint32_t end : arcs_.ends_at(junction)) {
        const double further = length + page_length(map_.piece(end / 2));
        if (!arcs_.has(end / 2) || further > longest || has(arc, end / 2)) continue;
        paths.emplace(further, arcs_.junction_of(end ^ 1));
      }
    }
    return false;
  }

  /// Whether both ends and the middle of the piece lie beside another line.
  bool runs_beside(std::uint32_t p, const Arcs::Arc& arc) {
    const Stroke& s = map_.piece(p);
    return lies_beside(s.from, arc) && lies_beside(point_at(s, 0.5), arc) && lies_beside(s.to, arc);
  }
  bool lies_beside(LatticePoint p, const Arcs::Arc& arc) {
    return map_.near(p, p, beside_, [&](std::uint32_t other) {
      return !has(arc, other) && foot_on(map_.piece(other), p).distance <= beside_;
    });
  }

  LineMap& map_;
  Arcs arcs_;
  DangleLimits limits_;
  double beside_;
  std::vector<std::uint32_t> body_;  ///< by piece; kNone except for outlines
  std::vector<double> longest_;      ///< by body: longest dangle, lattice steps
};

}  // namespace

std::size_t prune_dangles(LineMap& map, const BodyOf& body_of, const DangleLimits& limits) {
  return DanglePruner(map, body_of, limits).prune();
}

}  // namespace ligne
