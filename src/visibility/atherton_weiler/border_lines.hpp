#pragma once
/// Matches the borders of regions to the edges of the scene.

#include <cstdint>
#include <span>
#include <vector>

#include "visibility/common/open_parts.hpp"
#include "visibility/polygons/visible_faces.hpp"

namespace ligne::atherton_weiler {

class BorderLines {
 public:
  /// Assigns every border part to its candidate edge, if it has one.
  BorderLines(const ProjectedScene& scene, const Facets& facets, const VisibleFaces& visible);

  /// The visible parts of a candidate edge, sorted and disjoint, where regions border on it. Each part has the lowest level
  /// of these regions: farther regions are seen through more transparent faces.
  std::span<const LinePart> parts(std::size_t edge) const {
    return std::span(parts_).subspan(begin_[edge], begin_[edge + 1] - begin_[edge]);
  }
  /// True if borders do not give the whole edge: a face of it has no area on the page, or touches another face, which may
  /// take its region but does not hide its lines.
  bool needs_study(std::size_t edge) const { return needs_study_[edge] != 0; }

 private:
  std::vector<std::uint32_t> begin_;
  std::vector<LinePart> parts_;
  std::vector<std::uint8_t> needs_study_;
};

}  // namespace ligne::atherton_weiler
