#pragma once
/// The visible parts of one line where some faces are transparent.

#include <vector>

#include "visibility/common/cell_grid.hpp"
#include "visibility/common/open_parts.hpp"

namespace ligne {

/// Like VisibleParts, but a transparent face hides nothing: what is behind it is seen at a higher level. Working
/// memory that is kept from line to line. The grid is one through which transparent faces are seen.
class TransparentLines {
 public:
  TransparentLines(const ProjectedScene& scene, const std::vector<Facet>& facets, const CellGrid& grid,
                   double coincidence_steps)
      : scene_(scene), facets_(facets.data()), grid_(grid), coincidence_steps_(coincidence_steps) {}

  /// The visible parts of the line with their levels, in order, disjoint. A point is seen on the side on which less is in
  /// front of it. The parts are the caller's to change until the next call.
  std::vector<LinePart>& find(const PageLine& line);

 private:
  /// Something begins or ends to be in front of a side, or of both.
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
