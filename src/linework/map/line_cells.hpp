#pragma once
/// A grid over the page that finds segments near a segment.

#include <cstdint>
#include <utility>
#include <vector>

#include "base/key_table.hpp"
#include "base/no_index.hpp"
#include "linework/overlaps/stroke_index.hpp"

namespace ligne {

/// Square cells that list the numbered segments passing through them. Segments can be added but not removed.
class LineCells {
 public:
  /// `cell` is the side of a cell in lattice steps; walked_cell() gives one that keeps the number of entries small.
  explicit LineCells(double cell) : cell_(cell), grid_(cell, 0) {}

  /// Announces a query near() with these arguments. Once there is one, segments are listed only in cells of announced
  /// queries. Call it before the first insert().
  void expect(LatticePoint from, LatticePoint to, double reach) {
    is_limited_ = true;
    SegmentGrid(cell_, reach).walk(from, to, [&](std::uint64_t cell) {
      std::uint32_t& first = first_[cell];
      if (first == kNone) first = kLast;
      return false;
    });
  }
  /// Returns whether any cell lists the segment.
  bool insert(std::uint32_t number, LatticePoint from, LatticePoint to) {
    const std::size_t before = entries_.size();
    grid_.walk(from, to, [&](std::uint64_t cell) {
      if (is_limited_ && first_.find(cell) == kNone) return false;
      std::uint32_t& first = first_[cell];
      entries_.emplace_back(number, first);
      first = static_cast<std::uint32_t>(entries_.size() - 1);
      return false;
    });
    return entries_.size() > before;
  }
  bool empty() const { return entries_.empty(); }

  /// Calls visit(number) for every segment within `reach` steps of the segment from-to, for some that are farther away, and
  /// for some more than once, until it returns true. Returns whether it did.
  template <class Visit>
  bool near(LatticePoint from, LatticePoint to, double reach, const Visit& visit) const {
    return SegmentGrid(cell_, reach).walk(from, to, [&](std::uint64_t cell) {
      for (std::uint32_t e = first_.find(cell); e < kLast; e = entries_[e].second) {
        if (visit(entries_[e].first)) return true;
      }
      return false;
    });
  }

 private:
  static constexpr std::uint32_t kLast = kNone - 1;  ///< ends the list of an announced cell

  double cell_;
  bool is_limited_ = false;
  SegmentGrid grid_;
  KeyTable first_;                                                // for each cell its first entry
  std::vector<std::pair<std::uint32_t, std::uint32_t>> entries_;  // segment, next entry
};

}  // namespace ligne
