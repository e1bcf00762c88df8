#pragma once
/// Cells of a hashed grid for finding all points near a given point. Cells are two distances wide, so everything within
/// one distance of a point lies in its own cell or in those beyond its nearer walls: eight cells.

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include "base/hash.hpp"
#include "geometry/point.hpp"

namespace ligne {

/// The eight cells around a point: per axis its own cell and the one beyond the nearer wall.
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

  /// Slots of the cells among `slots`, a power of two; the first is the slot of the point's own cell. Cells that share
  /// a slot only cost time, since callers compare distances.
  std::array<std::size_t, 8> slots(std::size_t slots) const {
    const auto mixed = [](std::uint64_t hash, double cell) {
      return extend_hash(std::rotl(hash, 23), bits_of_number(cell));
    };
    std::array<std::size_t, 8> found{};
    for (std::size_t x = 0; x < 2; ++x) {
      const std::uint64_t of_x = mixed(0, cells_[0][x]);
      for (std::size_t y = 0; y < 2; ++y) {
        const std::uint64_t of_y = mixed(of_x, cells_[1][y]);
        for (std::size_t z = 0; z < 2; ++z) found[x + 2 * y + 4 * z] = mixed(of_y, cells_[2][z]) & (slots - 1);
      }
    }
    return found;
  }

 private:
  std::array<std::array<double, 2>, 3> cells_{};
  bool finite_ = true;
};

}  // namespace ligne
