#pragma once
/// Sides that two clip faces have in common, one on each side. They bound nothing of the two together: how often all clip
/// faces wind round a place is the same without them. So a surface of many facets is laid over a subject as one face, by its
/// rim.

#include <cstdint>
#include <vector>

#include "base/no_index.hpp"
#include "visibility/polygons/clip_part.hpp"

namespace ligne {

class SharedSides {
 public:
  void clear();

  /// Clip faces are added with the numbers 0, 1, 2, ... Transparent ones and others are not brought together.
  void add(const ClipPart& clip, bool transparent);

  /// The clip face on the other side of a side of a clip face, or kNone. Each side is brought together with one other at
  /// most.
  std::uint32_t partner(std::uint32_t clip, std::uint32_t side) const { return partner_[kMostSides * clip + side]; }

 private:
  static constexpr std::uint32_t kMostSides = 4;

  struct Side {
    LatticeSegment segment;
    bool transparent, reversed;
    std::uint32_t number;  ///< kMostSides times the clip face, plus the side
  };
  /// A place of the hash table; of an older subject when the round is another.
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
