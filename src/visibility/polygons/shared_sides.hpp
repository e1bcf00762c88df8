#pragma once
/// Finds sides that two clip faces share, one on each side. Such a side does not bound the union of the two: without it
/// the winding numbers of all clip faces stay unchanged. So a surface of many facets clips a subject as one face, with
/// its rim.

#include <cstdint>
#include <vector>

#include "base/no_index.hpp"
#include "visibility/polygons/clip_part.hpp"

namespace ligne {

class SharedSides {
 public:
  void clear();

  /// Adds clip faces with the numbers 0, 1, 2, ... A transparent and an opaque face are never partners.
  void add(const ClipPart& clip, bool transparent);

  /// The clip face across a side of a clip face, or kNone. Each side has at most one partner.
  std::uint32_t partner(std::uint32_t clip, std::uint32_t side) const { return partner_[kMostSides * clip + side]; }

 private:
  static constexpr std::uint32_t kMostSides = 4;

  struct Side {
    LatticeSegment segment;
    bool transparent, reversed;
    std::uint32_t number;  ///< kMostSides times the clip face, plus the side
  };
  /// A slot of the hash table. If its round is not the current one, it belongs to an earlier subject.
  struct Slot {
    std::uint32_t round = 0, side = 0;
  };

  void insert(std::uint32_t side);
  void grow();

  std::vector<Side> sides_;
  std::vector<std::uint32_t> partner_;
  std::vector<Slot> slots_;
  std::uint32_t round_ = 0;
};

}  // namespace ligne
