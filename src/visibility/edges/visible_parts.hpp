#pragma once
/// The visible parts of one line: the rest of it after every facet in front has taken its interval.

#include <mutex>
#include <vector>

#include "base/add_counts.hpp"
#include "visibility/common/cell_grid.hpp"
#include "visibility/common/face_ranks.hpp"
#include "visibility/common/occluded_cells.hpp"
#include "visibility/common/open_parts.hpp"

namespace ligne {

/// Counts for the statistics.
struct TestCounts {
  std::uint64_t leaves = 0;           ///< leaf cells visited
  std::uint64_t covered = 0;          ///< visited leaf cells in which the line lies behind the cover
  std::uint64_t facet_tests = 0;      ///< tests of a line against a facet
  std::uint64_t behind_in_order = 0;  ///< facets not tested: by the order of the faces they lie behind
  void operator+=(const TestCounts& o) { add_counts(*this, o); }
};

/// Counts of all threads.
struct TestTotals {
  std::mutex mutex;
  TestCounts counts;
};

/// Finds the visible parts of lines, one by one. It keeps its working memory from line to line.
class VisibleParts {
 public:
  /// The destructor adds the counts to `totals`, if given. `ranks`: an order of the faces, if there is one. `blank`:
  /// cells in which no line is visible, if known. `only_visible`: see find().
  VisibleParts(const ProjectedScene& scene, const std::vector<Facet>& facets, const CellGrid& grid, double coincidence_steps,
               TestTotals* totals = nullptr, const FaceRanks* ranks = nullptr, const OccludedCells* blank = nullptr,
               bool only_visible = false)
      : vertices_(scene.vertices.data()),
        facets_(facets.data()),
        grid_(grid),
        coincidence_steps_(coincidence_steps),
        totals_(totals),
        ranks_(ranks),
        blank_(blank),
        only_visible_(only_visible) {}
  VisibleParts(const VisibleParts&) = delete;
  VisibleParts& operator=(const VisibleParts&) = delete;
  ~VisibleParts() {
    if (!totals_) return;
    const std::lock_guard lock(totals_->mutex);
    totals_->counts += counts_;
  }

  /// Finds the visible parts of the line, in order, disjoint; parts that touch are joined. The caller may change them
  /// until the next call. Afterwards near_side() says whether a side of a facet in front of the line or level with it
  /// lies along the line; with `only_visible` only the visible part of the line is tested.
  std::vector<LinePart>& find(const PageLine& line);
  bool near_side() const { return near_side_; }

 private:
  void search_leaf(const PageLine& line, const Cell& cell, const CellSquare& square, double from, double to);

  bool has_side_along(const PageLine& line, const Facet& facet) const;
  bool has_side_along_part(const PageLine& line, const Facet& facet) const;

  bool is_own(const PageLine& line, std::uint32_t facet) const {
    return facets_[facet].face == line.face0 || facets_[facet].face == line.face1;
  }

  const ProjectedVertex* vertices_;
  const Facet* facets_;
  const CellGrid& grid_;
  double coincidence_steps_;
  TestTotals* totals_;
  const FaceRanks* ranks_;
  std::uint32_t rank_ = 0;  ///< of the current line
  const OccludedCells* blank_;
  bool only_visible_;
  bool near_side_ = false;
  std::vector<std::uint32_t> near_;  ///< facets with a side along the line, visible or not, perhaps repeated
  std::vector<LinePart> parts_;      ///< found so far, along the whole line
  OpenParts open_;                   ///< not yet hidden, in the current leaf
  TestCounts counts_;
};

/// Like VisibleParts, but a transparent face hides nothing: lines behind it are visible at a higher level. The object
/// keeps its working memory from line to line. The grid must be made with `see_through`.
class TransparentLines {
 public:
  TransparentLines(const ProjectedScene& scene, const std::vector<Facet>& facets, const CellGrid& grid,
                   double coincidence_steps)
      : scene_(scene), facets_(facets.data()), grid_(grid), coincidence_steps_(coincidence_steps) {}

  /// Finds the visible parts of the line with their levels, in order, disjoint. The level is that of the side of the
  /// line with less in front of it. The caller may change the parts until the next call.
  std::vector<LinePart>& find(const PageLine& line);

 private:
  /// A place where a facet begins or ceases to cover one side of the line, or both.
  struct Event {
    double t;
    int left, right;  ///< transparent facets, +1 or -1
    int hidden_left, hidden_right;
  };

  void search_leaf(const PageLine& line, const Cell& cell, const CellSquare& square, double from, double to);

  const ProjectedScene& scene_;
  const Facet* facets_;
  const CellGrid& grid_;
  double coincidence_steps_;
  std::vector<Event> events_;
  std::vector<LinePart> parts_;
};

}  // namespace ligne
