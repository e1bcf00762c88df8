#pragma once
/// The depth behind which nothing can be seen, cell by cell, known before any scan.
///
/// [Boulle1980] (2.3.5.5) asks to recognise changes among hidden elements, "to predict" them. The scan predicts most cheaply
/// what it never meets: facets and lines that lie behind single facets, each of which covers a whole cell, are left out of
/// it. A facet left out hides nothing that is not hidden by what covers it.

#include <atomic>
#include <cstdint>
#include <vector>

#include "visibility/common/facet.hpp"
#include "visibility/penetration/penetration.hpp"

namespace ligne::watkins {

class OccluderGrid {
 public:
  /// `margin_steps`: what comes within this distance of a cell counts as in it.
  OccluderGrid(const std::vector<ProjectedVertex>& vertices, const std::vector<Facet>& facets, double margin_steps);

  /// Whether something whose extent on the page is this rectangle, and whose nearest depth is z_near, lies behind covers all
  /// over.
  bool hides(double x0, double y0, double x1, double y1, double z_near) const;
  bool hides(const Facet& facet, const std::vector<ProjectedVertex>& vertices) const;
  /// Whether every point of the segment does.
  bool hides(const PageSegment& segment) const;

 private:
  void add(const Facet& facet, const std::vector<ProjectedVertex>& vertices);
  std::uint32_t column(double x) const;
  std::uint32_t row(double y) const;

  double x_ = 0, y_ = 0, size_ = 1, margin_;
  std::uint32_t columns_ = 1, rows_ = 1;
  bool empty_ = true;                      ///< no facet covers a cell
  std::vector<std::atomic<float>> depth_;  ///< row by row; infinite where there is no cover
};

}  // namespace ligne::watkins
