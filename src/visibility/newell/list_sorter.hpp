#pragma once
/// Sorts single lists of elements. The lists of a sorter are sorted one after the other; sorters with different elements may
/// work at the same time.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <span>
#include <unordered_map>
#include <vector>

#include "base/add_counts.hpp"
#include "visibility/common/facet.hpp"
#include "visibility/newell/paint_elements.hpp"

namespace ligne::newell {

/// A hierarchy of grids for elements on the page, with cell sizes that double. An element lies in the grid whose cells are
/// at least its size, so in at most four cells. Each cell is sorted by farthest depth. The list is processed from the back
/// to the front, so searched and removed elements lie at the end of a cell.

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

struct ListCounts {
  std::uint64_t zones = 0;       ///< sets with disjoint extents on the page, nested
  std::uint64_t slabs = 0;       ///< sets with disjoint depths, nested
  std::uint64_t lists = 0;       ///< sets that could not be decomposed and were sorted
  std::uint64_t ahead = 0;       ///< elements compared with their sets before they became the head
  std::uint64_t one_body = 0;    ///< pairs of one convex body, not compared
  std::uint64_t separated = 0;   ///< pairs separated by a plane, not compared
  std::uint64_t one_way = 0;     ///< pairs compared one way only, because convex faces do not penetrate
  std::uint64_t opened = 0;      ///< bodies replaced by their faces
  std::uint64_t compared = 0;    ///< pairs of an element and a member of its set Q_p
  std::uint64_t apart_in_x = 0;  ///< these pairs by the test that decided
  std::uint64_t apart_in_y = 0;
  std::uint64_t behind_plane = 0;
  std::uint64_t before_plane = 0;
  std::uint64_t projections = 0;  ///< pairs compared edge by edge
  std::uint64_t disjoint = 0;     ///< of these, disjoint pairs
  std::uint64_t depths = 0;       ///< pairs compared in depth over their common part
  std::uint64_t farther = 0;      ///< of these, pairs where the first is nowhere in front
  std::uint64_t moved = 0;        ///< elements marked and moved to the head of the list
  std::uint64_t plane_cuts = 0;   ///< elements cut by the plane of another element
  std::uint64_t page_cuts = 0;    ///< elements halved on the page because both planes failed

  std::uint64_t cuts() const { return plane_cuts + page_cuts; }
  void add(const ListCounts& o) { add_counts(*this, o); }
};

/// Key of an element in the list: farthest depth, farthest first, then element number for depths equal as floats. The list
/// and the sets Q_p share this order.
using SortKey = std::uint64_t;
/// The high half is the depth as a float, mapped to an unsigned integer that rises as the depth falls.
SortKey sort_key(double reach, std::uint32_t element);
inline SortKey sort_key_of(SortKey reach, std::uint32_t element) { return reach >> 32 << 32 | element; }

class ListSorter {
 public:
  using Set = std::vector<std::uint32_t>;

  /// `keys`: one per element. `page` contains all lists, which have about `count` elements.
  ListSorter(PaintElements& elements, std::vector<SortKey> keys, const Extents& page, std::size_t count);

  /// Sorts a list, farthest first, and cuts elements without an order. No element stands in two lists.
  Set sort(std::span<const std::uint32_t> list);
  const ListCounts& counts() const { return counts_; }

 private:
  using Keys = std::vector<SortKey>;
  static constexpr SortKey kLast = ~SortKey{0};
  static std::uint32_t element_of(SortKey k) { return static_cast<std::uint32_t>(k); }  ///< kNone for kLast

  std::uint32_t head();
  bool settle(std::uint32_t p);
  bool resolve(std::uint32_t p, std::uint32_t q);
  bool may_hide(std::uint32_t p, std::uint32_t q) { return may_hide(p, q, counts_, common_); }
  bool may_hide(std::uint32_t p, std::uint32_t q, ListCounts& counts, CommonPart& work) const;
  void put_in_place(std::uint32_t whole, const std::vector<std::uint32_t>& parts);
  bool open_body(std::uint32_t p, std::uint32_t q);
  bool replace(std::uint32_t element, const ModelPlane& plane, std::uint64_t& count);
  void remove(std::uint32_t element);
  void insert(std::uint32_t element);
  void note(std::uint32_t element);

  /// The progress of comparing an element with its set Q_p. The result for a pair stays valid.
  struct Comparison {
    Keys others;              ///< not yet compared, farthest last
    Keys before;              ///< elements before it when it was compared ahead, unordered; most will be gone
    std::uint32_t known = 0;  ///< elements with higher numbers were made later
  };
  Comparison& comparison_of(std::uint32_t p);
  Comparison inherited(const Comparison& whole, std::uint32_t piece) const;
  bool work_off(std::uint32_t p, Keys& set);
  void look_ahead();
  struct AheadWork {
    ListCounts counts;
    CommonPart common;
    Set seen;  ///< per element: 1 + the last element whose comparison collected it
  };
  Comparison compared_ahead(std::uint32_t p, AheadWork& work) const;

  PaintElements& elements_;
  Keys keys_;  ///< per element
  PageLevels levels_;
  static constexpr std::uint32_t kBlock = 32;  ///< boxes per block. Tuned
  std::vector<Box> boxes_;                     ///< per element
  std::vector<Box> blocks_;                    ///< union of every kBlock boxes
  ListCounts counts_;
  CommonPart common_;

  // The current list: elements moved to its head, the initial sort, and pieces inserted later.
  enum class State : std::uint8_t { waiting, marked, gone };
  std::vector<State> state_;
  Set moved_;
  Set sorted_;
  std::size_t first_ = 0;                                      ///< first element of sorted_ that may be waiting
  std::size_t ahead_end_ = 0;                                  ///< elements of sorted_ before this one were compared ahead
  std::set<SortKey> inserted_;                                 ///< waiting pieces
  std::unordered_map<std::uint32_t, Comparison> comparisons_;  ///< of former heads; only looked up
  std::vector<AheadWork> works_;                               ///< per thread
  Set order_;                                                  ///< elements already sorted
  std::size_t gone_ = 0;                                       ///< elements that left the lists since levels_ forgot them
  std::vector<std::uint32_t> seen_;                            ///< per element: 1 + last element that collected it
};

}  // namespace ligne::newell
