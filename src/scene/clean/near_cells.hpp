#pragma once
/// Cells of a hashed grid in which whatever is near a point is found. Cells are two distances wide, so that all within one
/// distance of a point lie in its own cell or in those beyond its nearer walls: eight cells.

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include "geometry/point.hpp"

namespace ligne {

/// The eight cells round a point: per axis its own cell, and that beyond the nearer wall.
class NearCells {
 public:
  NearCells(const Point3& p, double distance) {
    for (int axis = 0; axis < 3; ++axis) {
      const double position = p[axis] / (2 * distance);
      finite_ = finite_ && std::isfinite(position);
      const double cell = std::floor(position);
      cells_[static_cast<std::size_t>(axis)] = {cell, position - cell < 0.5 ? cell - 1 : cell + 1};
    }
  }

  bool finite() const { return finite_; }

  /// Slot of cell k, 0 <= k < 8, among `slots`, a power of two; cell 0 is the point's own. Cells that share a slot only cost
  /// time: distances are looked at.
  std::size_t slot(unsigned k, std::size_t slots) const {
    std::uint64_t hash = 0;
    for (const double cell : {cells_[0][k & 1], cells_[1][k >> 1 & 1], cells_[2][k >> 2]}) {
      hash = (std::rotl(hash, 23) ^ std::bit_cast<std::uint64_t>(cell + 0.0)) * 0x9e3779b97f4a7c15u;
      hash ^= hash >> 29;
    }
    return hash & (slots - 1);
  }

 private:
  std::array<std::array<double, 2>, 3> cells_{};
  bool finite_ = true;
};

}  // namespace ligne
