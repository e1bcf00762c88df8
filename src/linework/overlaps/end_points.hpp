#pragma once
/// A grid over the ends of segments.

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "base/key_table.hpp"
#include "base/no_index.hpp"
#include "geometry/lattice.hpp"

namespace ligne {

/// Finds ends within reach of a point, but not at the point itself. Ends at one point are one entry, however many they
/// are.
class EndPoints {
 public:
  /// `reach` is in lattice steps, along x and along y.
  explicit EndPoints(double reach) : reach_(reach) {}

  void add(LatticePoint p, std::uint32_t segment) {
    std::uint32_t& number = number_[KeyTable::key(p)];
    if (number == kNone) {
      number = static_cast<std::uint32_t>(points_.size());
      std::uint32_t& first = cells_[KeyTable::key(cell(p.x), cell(p.y))];
      points_.push_back({p, first, {}});
      first = number;
    }
    points_[number].segments.push_back(segment);
  }

  bool is_near(LatticePoint p, LatticePoint q) const {
    return p != q && std::abs(double(p.x) - q.x) <= reach_ && std::abs(double(p.y) - q.y) <= reach_;
  }

  /// Calls found(segment) for each end near the point until it returns true. Returns whether it did.
  template <class Found>
  bool for_each_near(LatticePoint p, const Found& found) const {
    for (std::int32_t row = cell(p.y - reach_); row <= cell(p.y + reach_); ++row) {
      for (std::int32_t column = cell(p.x - reach_); column <= cell(p.x + reach_); ++column) {
        for (std::uint32_t e = cells_.find(KeyTable::key(column, row)); e != kNone; e = points_[e].next) {
          if (!is_near(p, points_[e].p)) continue;
          for (const std::uint32_t segment : points_[e].segments) {
            if (found(segment)) return true;
          }
        }
      }
    }
    return false;
  }

 private:
  struct Point {
    LatticePoint p;
    std::uint32_t next;  ///< next point of the same cell
    std::vector<std::uint32_t> segments;
  };

  std::int32_t cell(double v) const { return static_cast<std::int32_t>(std::floor(v / (2 * reach_))); }

  double reach_;
  KeyTable number_, cells_;
  std::vector<Point> points_;
};

}  // namespace ligne
