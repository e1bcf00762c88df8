#pragma once
/// A hierarchy of grids for elements on the page, with cell sizes that double. An element lies in the grid whose cells are
/// at least its size, so in at most four cells. Each cell is sorted by farthest depth. The list is processed from the back
/// to the front, so searched and removed elements lie at the end of a cell.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "visibility/common/facet.hpp"
#include "visibility/newell/paint_elements.hpp"

namespace ligne::newell {

/// The extents of an element, rounded outwards to floats. Most comparisons end with them, so they are kept compact.
struct Box {
  float x0, y0, z0, x1, y1, z1;

  Box(const Extents& e)
      : x0(round_down(e.low[0])),
        y0(round_down(e.low[1])),
        z0(round_down(e.low[2])),
        x1(round_up(e.high[0])),
        y1(round_up(e.high[1])),
        z1(round_up(e.high[2])) {}

  void extend(const Box& o) {
    x0 = std::min(x0, o.x0);
    y0 = std::min(y0, o.y0);
    z0 = std::min(z0, o.z0);
    x1 = std::max(x1, o.x1);
    y1 = std::max(y1, o.y1);
    z1 = std::max(z1, o.z1);
  }

  /// True if they overlap on the page and the other's farthest depth lies behind this one's nearest depth.
  bool meets(const Box& o) const { return x0 < o.x1 && o.x0 < x1 && y0 < o.y1 && o.y0 < y1 && z0 < o.z1; }
};

class PageLevels {
  struct Entry {
    Box box;
    std::uint32_t element;
  };

  /// The first entry of a cell whose farthest depth exceeds z.
  template <class Cell>
  static auto first_reached(Cell& cell, float z) {
    return std::upper_bound(cell.begin(), cell.end(), z, [](float v, const Entry& entry) { return v < entry.box.z1; });
  }

 public:
  /// `page` contains all elements that will be added, about `count` of them. It may be empty (high < low).
  PageLevels(const Extents& page, std::size_t count) : x_(page.low[0]), y_(page.low[1]) {
    const double width = std::max(page.high[0] - x_, 0.0), height = std::max(page.high[1] - y_, 0.0);
    const double longer = std::max(width, height), shorter = std::min(width, height);
    // The finest level has about one cell per element, and at most one per element along the longer side.
    const double n = static_cast<double>(std::max<std::size_t>(count, 1));
    double size = longer > 0 ? std::max(std::sqrt(longer * shorter / n), longer / n) : 1;
    for (;; size *= 2) {
      const auto columns = static_cast<int>(width / size) + 1, rows = static_cast<int>(height / size) + 1;
      levels_.push_back({size, columns, rows, std::vector<std::vector<Entry>>(std::size_t(columns) * rows)});
      if (columns == 1 && rows == 1) break;
    }
  }

  void add(std::uint32_t element, const Extents& e) {
    const double size = std::max(e.high[0] - e.low[0], e.high[1] - e.low[1]);
    std::size_t k = 0;
    while (k + 1 < levels_.size() && levels_[k].size < size) ++k;
    const Entry entry{e, element};
    visit_cells(levels_[k], e, [&](std::vector<Entry>& cell) {
      cell.insert(std::upper_bound(cell.begin(), cell.end(), entry, reaches_less_far), entry);
    });
  }

  /// Calls visit(element) for the elements that the extents meet (Box::meets), some repeatedly, and removes those for which
  /// it returns false.
  template <class Visit>
  void visit(const Extents& e, Visit visit) {
    const Box box(e);
    for (Level& level : levels_) {
      visit_cells(level, e, [&](std::vector<Entry>& cell) {
        const auto forget = [&](const Entry& entry) { return box.meets(entry.box) && !visit(entry.element); };
        cell.erase(std::remove_if(first_reached(cell, box.z0), cell.end(), forget), cell.end());
      });
    }
  }

  /// Calls visit without removing elements. Several threads may call it at once.
  template <class Visit>
  void look(const Extents& e, Visit visit) const {
    const Box box(e);
    for (const Level& level : levels_) {
      visit_cells(level, e, [&](const std::vector<Entry>& cell) {
        for (auto entry = first_reached(cell, box.z0); entry != cell.end(); ++entry) {
          if (box.meets(entry->box)) visit(entry->element);
        }
      });
    }
  }

  /// Removes the elements for which gone(element) is true.
  template <class Gone>
  void forget(Gone gone) {
    for (Level& level : levels_) {
      for (std::vector<Entry>& cell : level.cells) {
        std::erase_if(cell, [&](const Entry& entry) { return gone(entry.element); });
      }
    }
  }

 private:
  struct Level {
    double size;
    int columns, rows;
    std::vector<std::vector<Entry>> cells;
  };

  static bool reaches_less_far(const Entry& a, const Entry& b) { return a.box.z1 < b.box.z1; }

  template <class AnyLevel, class Visit>
  void visit_cells(AnyLevel& level, const Extents& e, Visit visit) const {
    const auto place = [&](double v, double origin, int n) {
      return std::clamp(static_cast<int>((v - origin) / level.size), 0, n - 1);
    };
    const int left = place(e.low[0], x_, level.columns), right = place(e.high[0], x_, level.columns);
    const int top = place(e.low[1], y_, level.rows), bottom = place(e.high[1], y_, level.rows);
    for (int row = top; row <= bottom; ++row) {
      for (int column = left; column <= right; ++column) visit(level.cells[std::size_t(row) * level.columns + column]);
    }
  }

  double x_, y_;
  std::vector<Level> levels_;
};

}  // namespace ligne::newell
