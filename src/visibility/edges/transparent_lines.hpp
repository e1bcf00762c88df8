#pragma once
/// The visible parts of one line where some faces are transparent.

#include <vector>

#include "visibility/common/cell_grid.hpp"
#include "visibility/common/open_parts.hpp"

namespace ligne {

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
