#pragma once
/// Triangulates a polygon while a sweep line crosses it from left to right.

#include <array>
#include <cstdint>
#include <vector>

#include "base/no_index.hpp"
#include "geometry/point.hpp"

namespace ligne {

/// The inside of a polygon to the left of a sweep line, cut into triangles as the line advances. A *slab* is the inside
/// between two edges that are neighbours on the line. Its uncut part lies to the right of a chain of corners:
///
///       a ------------------------ upper edge      The chain a b c d bends away from the inside (or is straight) at each
///        \                                         corner, so the next corner p of the slab sees all of it from the upper
///         b--__               |                    edge; from the lower edge it sees the corners from d back to the first
///              c--__d         | sweep line         bend that hides the others. The triangles between p
///                    \________|_ lower edge         and the corners that it sees are cut off.
///
/// Invariant: all corners of a chain except the first come from one side of the slab (Chain::side). Where two slabs have
/// met at a corner, both of their chains end there, and the next corner of the slab is joined to it. Garey, Johnson,
/// Preparata and Tarjan 1978 cut a polygon into monotone parts, and the parts into triangles; this does both in one pass.
/// The signs are exact, and no triangle lacks area: a corner collinear with the last two of a chain is added to the chain.
class MonotoneChains {
 public:
  using Index = std::uint32_t;
  using Slab = std::uint32_t;
  using Triple = std::array<Index, 3>;

  explicit MonotoneChains(const std::vector<Point2>& positions) : p_(positions) {}

  /// p is the leftmost corner of a new slab.
  Slab start(Index p);
  /// The lower or upper edge ends at p, and another one continues.
  void add_lower(Slab slab, Index p);
  void add_upper(Slab slab, Index p);
  /// Both edges end at p.
  void end(Slab slab, Index p);
  /// p lies between the edges: `slab` becomes the part below p, and the new slab is the part above.
  Slab split(Slab slab, Index p);
  /// The upper edge of `lower` and the lower edge of `upper` end at p, and none continues: `lower` becomes both slabs.
  void merge(Slab lower, Slab upper, Index p);

  /// Triangles cut so far, counter-clockwise.
  std::vector<Triple>& triangles() { return triangles_; }

 private:
  enum class Side : std::uint8_t { lower, upper };

  /// A corner of a chain and the one before it.
  struct Link {
    Index position;
    std::uint32_t previous;
  };
  struct Chain {
    std::uint32_t last = kNone;
    Side side = Side::lower;
  };
  struct Chains {
    Chain lower, upper;  ///< `upper` is used only if two slabs have met
    bool met = false;
  };

  void push(Chain& chain, Index p);
  void pop(Chain& chain);
  void add(Chain& chain, Index p, Side side);
  /// Cuts off everything between the chain and p; the chain is empty then.
  void fan(Chain& chain, Index p);
  void cut(Side side, Index before, Index last, Index p);
  Slab new_slab();

  const std::vector<Point2>& p_;
  std::vector<Link> links_;
  std::vector<std::uint32_t> free_links_;
  std::vector<Chains> slabs_;
  std::vector<Slab> free_slabs_;
  std::vector<Triple> triangles_;
};

}  // namespace ligne
