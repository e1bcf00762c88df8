#pragma once
/// Where the faces stand in an order of their pieces from front to back.

#include <algorithm>
#include <cstdint>
#include <vector>

#include "visibility/common/hidden_interval.hpp"

namespace ligne {

/// The ranks of the pieces of each face. A piece hides nothing of one of lower rank, or of its own. Faces without pieces,
/// and lines of no face, have no place in the order: nothing is known of them.
class FaceRanks {
 public:
  explicit FaceRanks(std::size_t face_count) : ranges_(face_count) {}

  void add(std::uint32_t face, std::uint32_t rank) {
    Range& r = ranges_[face];
    r.last = r.known ? std::max(r.last, rank) : rank;
    r.first = r.known ? std::min(r.first, rank) : rank;
    r.known = true;
  }

  /// From now on nothing is known of the face.
  void forget(std::uint32_t face) {
    if (face < ranges_.size()) ranges_[face] = {};
  }

  /// A face that covers both sides of a line and hides it stands before the pieces that each of its faces has there, since
  /// on the page it overlaps both. So no face that begins behind this rank hides the line. That is not so of a face with a
  /// side along the line: it covers one side, and on the page may overlap neither.
  std::uint32_t rank_of(const PageLine& line) const { return std::min(last(line.face0), last(line.face1)); }

  bool begins_behind(std::uint32_t face, std::uint32_t rank) const { return ranges_[face].first > rank; }

  /// Whether every piece of the first stands before, or behind, every piece of the second.
  bool all_before(std::uint32_t a, std::uint32_t b) const {
    return ranges_[a].known && ranges_[b].known && ranges_[a].last < ranges_[b].first;
  }

 private:
  struct Range {
    std::uint32_t first = 0, last = 0xffffffffu;
    bool known = false;
  };
  std::uint32_t last(std::uint32_t face) const { return face < ranges_.size() ? ranges_[face].last : 0xffffffffu; }

  std::vector<Range> ranges_;
};

}  // namespace ligne
