#pragma once
/// The visible parts of one line: what is left of it when every facet in front has taken its interval.

#include <vector>

#include "visibility/common/cell_grid.hpp"
#include "visibility/common/open_parts.hpp"

namespace ligne::appel {

/// Counts for the statistics.
struct TestCounts {
  std::uint64_t leaves = 0;       ///< leaf cells visited
  std::uint64_t covered = 0;      ///< of them, those in which the line lies behind the cover
  std::uint64_t facet_tests = 0;  ///< line against facet
  void operator+=(const TestCounts& o) {
    leaves += o.leaves;
    covered += o.covered;
    facet_tests += o.facet_tests;
  }
};

/// Working memory that is kept from line to line.
class VisibleParts {
 public:
  VisibleParts(const ProjectedScene& scene, const std::vector<Facet>& facets, const CellGrid& grid, double coincidence_steps)
      : vertices_(scene.vertices.data()), facets_(facets.data()), grid_(grid), coincidence_steps_(coincidence_steps) {}

  /// Finds the visible parts of the line, in order, disjoint; parts that touch are one. They are the caller's to change
  /// until the next call. Afterwards near_side() tells
  /// whether a side of a facet in front of the line or level with it lies along the line.
  std::vector<LinePart>& find(const PageLine& line);
  bool near_side() const { return near_side_; }
  const TestCounts& counts() const { return counts_; }

 private:
  void search_leaf(const PageLine& line, const Cell& cell, const CellSquare& square, double from, double to);

  const ProjectedVertex* vertices_;
  const Facet* facets_;
  const CellGrid& grid_;
  double coincidence_steps_;
  bool near_side_ = false;
  std::vector<LinePart> parts_;  ///< found so far, along the whole line
  OpenParts open_;               ///< not yet hidden, in the leaf at hand
  TestCounts counts_;
};

}  // namespace ligne::appel
