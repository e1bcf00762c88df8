#pragma once
/// Positions of faces in an order of their pieces from front to back.

#include <algorithm>
#include <cstdint>
#include <vector>

#include "visibility/common/hidden_interval.hpp"

namespace ligne {

/// The ranks of the pieces of each face. A piece hides no piece of lower or equal rank. Faces without pieces, and lines
/// of no face, have no rank.
class FaceRanks {
 public:
  explicit FaceRanks(std::size_t face_count) : ranges_(face_count) {}

  void add(std::uint32_t face, std::uint32_t rank) {
    Range& r = ranges_[face];
    r.last = r.known ? std::max(r.last, rank) : rank;
    r.first = r.known ? std::min(r.first, rank) : rank;
    r.known = true;
  }

  /// Removes the ranks of the face.
  void forget(std::uint32_t face) {
    if (face < ranges_.size()) ranges_[face] = {};
  }

  /// The rank behind which no face hides the line. A face that hides a line and covers both of its sides overlaps both
  /// faces of the line on the page, so it has a lower rank than their pieces there. This does not hold for a face with
  /// a side along the line: it covers one side only, and may overlap neither face.
  std::uint32_t rank_of(const PageLine& line) const { return std::min(last(line.face0), last(line.face1)); }

  bool begins_behind(std::uint32_t face, std::uint32_t rank) const { return ranges_[face].first > rank; }

  /// Whether every piece of `a` has a lower rank than every piece of `b`.
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
