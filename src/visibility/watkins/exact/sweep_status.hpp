#pragma once
/// The active list of the exact scan: the edges on the scan line from left to right, with the facets over every gap.
///
/// A *node* represents one edge, or several collinear ones. A *slot* is a place in the list and has a node; exchanging two
/// neighbours exchanges their nodes. The gap right of a slot extends to the next slot; its *cover* is the set of facets over
/// it.
///
/// Invariant: the cover right of a slot is the cover left of it, with every facet that has a side in the slot's node
/// toggled.

#include <algorithm>
#include <cstdint>
#include <vector>

#include "geometry/lattice.hpp"

namespace ligne::watkins {

using Cover = std::vector<std::uint32_t>;  ///< facets without repetition, unordered

/// Inserts the facet, or removes it if present.
inline void toggle(Cover& cover, std::uint32_t facet) {
  for (std::uint32_t& f : cover) {
    if (f == facet) {
      f = cover.back();
      cover.pop_back();
      return;
    }
  }
  cover.push_back(facet);
}

inline bool contains(const Cover& cover, std::uint32_t facet) { return std::ranges::find(cover, facet) != cover.end(); }

struct SweepNode {
  LatticePoint top, bottom;  ///< ends of one of its edges that extends beyond the scan line
  std::uint32_t bottom_point = 0;
  std::uint32_t first = 0;  ///< first of its edges, see ExactSweep
  std::uint32_t slot = 0;
  std::uint32_t generation = 0;  ///< changes when the node is reused
  bool has_lines = false;
  double x = 0, y = 0;  ///< last crossing of its edges with another edge, lattice steps
};

class SweepStatus {
 public:
  static constexpr std::uint32_t kLeftEnd = 0;  ///< the leftmost slot: it has no node, and its gap has an empty cover

  SweepStatus();

  std::uint32_t previous(std::uint32_t slot) const { return slots_[slot].previous; }
  std::uint32_t next(std::uint32_t slot) const { return slots_[slot].next; }  ///< kLeftEnd after the last slot
  Cover& cover(std::uint32_t slot) { return slots_[slot].cover; }             ///< cover of the gap right of the slot
  std::uint32_t node_at(std::uint32_t slot) const { return slots_[slot].node; }
  SweepNode& node(std::uint32_t n) { return nodes_[n]; }
  const SweepNode& node(std::uint32_t n) const { return nodes_[n]; }

  std::uint32_t make_node();
  void free_node(std::uint32_t n);
  void put(std::uint32_t slot, std::uint32_t node) {
    slots_[slot].node = node;
    nodes_[node].slot = slot;
  }
  /// Inserts a slot without a node behind `slot`.
  std::uint32_t insert_after(std::uint32_t slot);
  void erase(std::uint32_t slot);

  /// The last slot whose node lies strictly left of the point, by binary search.
  std::uint32_t last_left_of(LatticePoint p) const;

 private:
  static constexpr std::uint32_t kBlock = 64;

  struct Slot {
    std::uint32_t previous = 0, next = 0, node = 0, block = 0;
    Cover cover;
  };
  /// A run of consecutive slots, for searching.
  struct Block {
    std::uint32_t rank = 0, count = 0;
    std::uint32_t slots[kBlock];
  };

  bool left_of(std::uint32_t slot, LatticePoint p) const;
  std::uint32_t place_in_block(std::uint32_t slot) const;
  void split(std::uint32_t block);
  void renumber(std::size_t from);

  std::vector<Slot> slots_;
  std::vector<SweepNode> nodes_;
  std::vector<Block> blocks_;
  std::vector<std::uint32_t> order_;  ///< blocks from left to right
  std::vector<std::uint32_t> free_slots_, free_nodes_, free_blocks_;
};

}  // namespace ligne::watkins
