#pragma once
/// Two ways to follow a line through the nodes of a LineMap. Each is a snapshot: later edits of the map do not change
/// it, except where noted.

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "base/index_lists.hpp"
#include "base/no_index.hpp"
#include "linework/map/line_map.hpp"

namespace ligne {

/// Runs: pieces of one class that are drawn as one line. At each node the ends of each class are paired, the
/// straightest pair first; then the remaining ends of edges are paired across classes in the same way. A run is
/// identified by its lowest piece.
class Runs {
 public:
  struct Run {
    double length = 0;  ///< lattice steps
    LineClass line_class = LineClass::mesh;
    std::uint32_t longest_continuation = kNone;  ///< the longest run of another class that continues this run
  };

  /// Takes the pieces of edges; others have the run kNone. O(n log d) for nodes of the degree d.
  explicit Runs(const LineMap& map);
  std::uint32_t of(std::uint32_t piece) const { return of_[piece]; }
  const Run& operator[](std::uint32_t lowest) const { return runs_[lowest]; }

 private:
  std::vector<std::uint32_t> of_;
  std::vector<Run> runs_;
};

/// Arcs: lines from one junction to the next. A line that ends within `reach` of the side of another makes a junction
/// there. Pieces whose two ends belong to one junction belong to no arc. Chains are arcs that ignore such contacts: two
/// pieces continue each other wherever exactly two pieces end.
class Arcs {
 public:
  struct Arc {
    std::vector<std::uint32_t> ends;       ///< the ends at which its pieces begin, in the order of the line
    std::vector<std::uint32_t> pieces;     ///< ascending
    double length = 0;                     ///< lattice steps
    std::vector<std::uint32_t> junctions;  ///< its two junctions; none for a ring
  };

  static constexpr double kAnyLength = std::numeric_limits<double>::infinity();

  /// O(n).
  Arcs(const LineMap& map, double reach);
  /// The junction of an end, which may also be a node inside a line.
  std::uint32_t junction_of(std::uint32_t end) const { return junction_of_[end]; }
  /// The number of remaining pieces at a junction.
  std::uint32_t degree(std::uint32_t junction) const { return degree_[junction]; }
  bool has(std::uint32_t piece) const { return is_left_[piece] != 0; }
  /// Whether an end of a remaining piece is the only one at its junction.
  bool is_free(std::uint32_t end) const { return has(end / 2) && degree(junction_of(end)) == 1; }
  /// All ends that belonged to the junction originally, ascending.
  std::span<const std::uint32_t> ends_at(std::uint32_t junction) const { return at_junction_[junction]; }
  /// The end that continues an end of a remaining piece, or kNone: the other of exactly two at a junction.
  std::uint32_t next(std::uint32_t end) const;
  /// The arcs of the remaining pieces, in the order of their lowest pieces. A ring begins with its lowest piece.
  std::vector<Arc> find() const;
  /// The arc that begins at an end of a remaining piece, where next() is kNone. Empty if it is longer than `most`.
  Arc from(std::uint32_t end, double most = kAnyLength) const;
  void take_away(const Arc& arc);

 private:
  Arc arc_of(std::span<const std::uint32_t> ends, bool is_ring) const;

  const LineMap& map_;
  std::vector<std::uint32_t> junction_of_;  ///< by end
  std::vector<std::uint32_t> degree_;       ///< by junction
  IndexLists at_junction_;                  ///< ends by junction
  std::vector<std::uint8_t> is_left_;       ///< by piece
};

/// The chain that begins at a free end of a living piece, without its junctions. Empty if it is longer than `most`.
Arcs::Arc chain_from(const LineMap& map, std::uint32_t free_end, double most = Arcs::kAnyLength);

}  // namespace ligne
