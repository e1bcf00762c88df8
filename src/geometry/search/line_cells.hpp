#pragma once
/// A grid over the page that finds segments near a segment.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "base/key_table.hpp"
#include "base/no_index.hpp"
#include "geometry/lattice.hpp"

namespace ligne {

/// Square cells that list the numbered segments passing through them. Segments can be added but not removed.
class LineCells {
 public:
  /// `cell` is the side of a cell in lattice steps. A segment takes an entry in every cell that it passes.
  explicit LineCells(double cell) : cell_(cell), per_step_(1 / cell) {}

  void insert(std::uint32_t number, LatticePoint from, LatticePoint to) {
    walk(from, to, 0, [&](std::uint64_t cell) {
      std::uint32_t& first = first_[cell];
      entries_.emplace_back(number, first);
      first = static_cast<std::uint32_t>(entries_.size() - 1);
      return false;
    });
  }

  /// Calls visit(number) for every segment within `reach` steps of the segment from-to, for some that are farther away, and
  /// for some more than once, until it returns true. Returns whether it did.
  template <class Visit>
  bool near(LatticePoint from, LatticePoint to, double reach, const Visit& visit) const {
    return walk(from, to, reach, [&](std::uint64_t cell) {
      for (std::uint32_t e = first_.find(cell); e != kNone; e = entries_[e].second) {
        if (visit(entries_[e].first)) return true;
      }
      return false;
    });
  }

  /// Calls visit(cell) for every cell within `reach` steps of the segment until it returns true. Returns whether it did.
  template <class Visit>
  bool walk(LatticePoint from, LatticePoint to, double reach, const Visit& visit) const;

 private:
  static constexpr double kRounding = 2;  ///< lattice steps; more than the rounding error of any position here

  std::int32_t index(double v) const { return static_cast<std::int32_t>(std::floor(v * per_step_)); }

  double cell_, per_step_;
  KeyTable first_;                                                // for each cell its first entry
  std::vector<std::pair<std::uint32_t, std::uint32_t>> entries_;  // segment, next entry
};

/// Walks slab by slab along the longer direction, called u here; v is the other one, and |dv/du| <= 1.
template <class Visit>
bool LineCells::walk(LatticePoint from, LatticePoint to, double reach, const Visit& visit) const {
  const double dx = double(to.x) - from.x, dy = double(to.y) - from.y, margin = reach + kRounding;
  const bool flat = std::abs(dx) >= std::abs(dy);
  const double u0 = flat ? from.x : from.y, v0 = flat ? from.y : from.x;
  const double u1 = flat ? to.x : to.y;
  const double slope = dx == 0 && dy == 0 ? 0 : flat ? dy / dx : dx / dy;
  const double u_min = std::min(u0, u1), u_max = std::max(u0, u1);
  const std::int32_t i_last = index(u_max + margin);
  for (std::int32_t i = index(u_min - margin); i <= i_last; ++i) {
    const double slab_from = std::clamp(i * cell_ - margin, u_min, u_max);
    const double slab_to = std::clamp((i + 1) * cell_ + margin, u_min, u_max);
    const double v_from = v0 + (slab_from - u0) * slope, v_to = v0 + (slab_to - u0) * slope;
    const std::int32_t j_last = index(std::max(v_from, v_to) + margin);
    for (std::int32_t j = index(std::min(v_from, v_to) - margin); j <= j_last; ++j) {
      if (visit(flat ? KeyTable::key(i, j) : KeyTable::key(j, i))) return true;
    }
  }
  return false;
}

}  // namespace ligne
