#pragma once
/// Per grid cell, the depth behind which nothing is visible; computed before any scan.
///
/// [Boulle1980] (2.3.5.5) suggests recognising changes among hidden elements, "to predict" them. It is cheapest to keep
/// hidden elements out of the scan: facets and lines behind single facets that each cover a whole cell are omitted. An
/// omitted facet hides only what the covers hide as well.

#include <atomic>
#include <cstdint>
#include <vector>

#include "view/projected_scene.hpp"
#include "visibility/common/cell_grid.hpp"
#include "visibility/common/facet.hpp"
#include "visibility/penetration/penetration.hpp"
#include "visibility/watkins/exact/sweep_scene.hpp"

namespace ligne::watkins {

class OccluderGrid {
 public:
  /// `margin_steps`: a point within this distance of a cell counts as inside it.
  OccluderGrid(const std::vector<ProjectedVertex>& vertices, const std::vector<Facet>& facets, double margin_steps);

  /// True if an object with this rectangle as extent on the page, and z_near as nearest depth, lies wholly behind covers.
  bool hides(double x0, double y0, double x1, double y1, double z_near) const;
  bool hides(const Facet& facet, const std::vector<ProjectedVertex>& vertices) const;
  /// True if every point of the segment lies behind covers.
  bool hides(const PageSegment& segment) const;

 private:
  void add(const Facet& facet, const std::vector<ProjectedVertex>& vertices);
  std::uint32_t column(double x) const;
  std::uint32_t row(double y) const;

  double x_ = 0, y_ = 0, size_ = 1, margin_;
  std::uint32_t columns_ = 1, rows_ = 1;
  bool empty_ = true;                      ///< no facet covers a cell
  std::vector<std::atomic<float>> depth_;  ///< row by row; infinite without a cover
};

/// Removes facets behind covers from the list, and marks lines behind covers.
void leave_out_hidden(const ProjectedScene& scene, const OccluderGrid& covers, std::vector<Facet>& facets,
                      std::vector<SweepLine>& lines);

/// Uses cells that several connected facets cover together. A facet that no cell lists lies behind such patches everywhere,
/// or coincides with another facet there.
void leave_out_hidden(const CellGrid& grid, std::vector<Facet>& facets, std::vector<SweepLine>& lines);

/// True if the line lies behind the covers of all cells that it crosses.
bool lies_behind(const CellGrid& grid, const SweepLine& line);

}  // namespace ligne::watkins
