#pragma once
/// The sweep over one part of the grid: edges come from the nearest cell to the farthest, the horizons take them, and
/// their visible parts become lines.

#include <utility>
#include <vector>

#include "base/parallel.hpp"
#include "visibility/horizon/edges.hpp"
#include "visibility/horizon/horizons.hpp"
#include "visibility/horizon/part_edges.hpp"
#include "visibility/horizon/part_lines.hpp"

namespace ligne::horizon {

/// Horizons of bands of columns, which work in parallel. A band uses only the part of an edge over its columns, so no
/// band waits for another. All bands take the edges in the same order.

template <class Horizon>
class HidingBands {
 public:
  explicit HidingBands(const Bands& bands) {
    for (std::size_t b = 0; b < bands.size(); ++b) bands_.push_back({Horizon(bands.columns(), bands.of_band(b)), {}, {}});
  }

  /// Finds the visible parts of the edges of the lists, in order.
  void take(std::vector<EdgeList>& lists) {
    parallel_tasks(bands_.size(), [&](std::size_t b) {
      for (EdgeList& list : lists) take(list, b);
    });
  }

  /// Largest gap over which spans of two bands are joined.
  double least() const { return bands_.front().horizon.least(); }

 private:
  struct Band {
    Horizon horizon;
    std::vector<Span> above, below;  ///< scratch
  };

  void take(EdgeList& list, std::size_t b) {
    Band& band = bands_[b];
    for (const std::uint32_t number : list.of_band[b]) {
      if constexpr (Horizon::kCovers) {
        if (number & EdgeList::kTriangle) {
          band.horizon.cover(list.triangles[number & ~EdgeList::kTriangle]);
          continue;
        }
      }
      HorizonEdge& edge = list.edges[number];
      if (edge.is_tested() && edge.first_band <= b && b <= edge.last_band) {
        band.above.clear();
        band.below.clear();
        const bool open = band.horizon.find_seen(edge, band.above, band.below);
        if (edge.line.upright()) edge.open = open;  // an upright line lies in one band
        for (const Span& span : band.above) list.seen[b].push_back({number, false, span});
        for (const Span& span : band.below) list.seen[b].push_back({number, true, span});
      }
      if constexpr (!Horizon::kCovers) {
        if (edge.upper || edge.lower) band.horizon.raise(edge);
      }
    }
  }

  std::vector<Band> bands_;
};

template <class Horizon>
class PartSweep {
 public:
  PartSweep(const GridPart& grid, const View& view, const HorizonOptions& options, const Columns& columns, LineStore& store)
      : grid_(grid),
        eye_(view, PlaneProjection(view.camera, grid.columns.sign, grid.rows.sign)),
        bands_(columns),
        edges_(grid, view, options, eye_, bands_, Horizon::kCovers),
        hiding_(bands_),
        lines_(eye_, columns, hiding_.least(), store),
        store_(store) {}

  /// Calls progress(rows done). Returns the number of tested edges of the surface.
  template <class Progress>
  std::size_t run(Progress progress) {
    std::size_t tested = 0;
    std::vector<EdgeList> lists;
    share_lines_ahead([](std::vector<Span>& here, std::vector<Span>& shared) { here = std::move(shared); });
    while (const std::size_t rows = edges_.next(lists)) {
      hiding_.take(lists);
      for (EdgeList& list : lists) {
        lines_.add(list);
        tested += list.tested;
      }
      progress(rows);
    }
    for (CurveTracker& curve : edges_.column_curves()) curve.end();
    lists.resize(1);
    edges_.add_back_lines(lists.front());
    hiding_.take(lists);
    lines_.add(lists.front());
    share_lines_ahead([](std::vector<Span>& here, std::vector<Span>& shared) { shared = std::move(here); });
    return tested;
  }

 private:
  /// Calls share(spans drawn here, spans of all parts) for the curves straight in front of the eye. Each part tests one
  /// side of these curves; on them v has the same value for both parts.
  template <class Share>
  void share_lines_ahead(Share share) {
    const GridAxis::Part &columns = grid_.columns, &rows = grid_.rows;
    const auto at = [&](std::size_t column, std::size_t row) {
      return eye_.sample(grid_.placed(grid_.x.at[columns.order[column]], grid_.y.at[rows.order[row]], 0)).seen.u();
    };
    UprightLines& lines = lines_.upright_lines();
    if (columns.begin > 0)
      share(lines.drawn_at(at(columns.begin, rows.order.size() - 1)), store_.column_ahead[rows.sign > 0]);
    if (rows.begin > 0) share(lines.drawn_at(at(columns.order.size() - 1, rows.begin)), store_.row_ahead[columns.sign > 0]);
  }

  GridPart grid_;
  Eye eye_;
  Bands bands_;
  PartEdges edges_;
  HidingBands<Horizon> hiding_;
  PartLines lines_;
  LineStore& store_;
};

}  // namespace ligne::horizon
