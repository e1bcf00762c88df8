#pragma once
/// A grid of square cells that finds numbered boxes near a place of the page.

#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "geometry/point.hpp"

namespace ligne {

class BoxGrid {
 public:
  explicit BoxGrid(double cell_mm) : cell_mm_(cell_mm) {}

  void add(const Rect& box, std::uint32_t number) {
    for_cells(box, [&](std::int64_t key) { cells_[key].push_back(number); });
  }

  /// Calls visit(number) for boxes near `box`, some several times, until it returns true. Returns whether it did.
  template <class Visit>
  bool any_near(const Rect& box, Visit visit) const {
    bool found = false;
    for_cells(box, [&](std::int64_t key) {
      const auto cell = found ? cells_.end() : cells_.find(key);
      if (cell == cells_.end()) return;
      for (const std::uint32_t number : cell->second) {
        if (!found && visit(number)) found = true;
      }
    });
    return found;
  }

 private:
  template <class Sink>
  void for_cells(const Rect& box, Sink sink) const {
    const auto cell = [this](double at) { return static_cast<std::int64_t>(std::floor(at / cell_mm_)); };
    for (std::int64_t i = cell(box.min.x); i <= cell(box.max.x); ++i) {
      for (std::int64_t j = cell(box.min.y); j <= cell(box.max.y); ++j) sink(i * 0x100000 + j);
    }
  }

  double cell_mm_;
  std::unordered_map<std::int64_t, std::vector<std::uint32_t>> cells_;
};

}  // namespace ligne
