#pragma once
/// From the borders of regions back to the edges of the scene.

#include <cstdint>
#include <span>
#include <vector>

#include "visibility/common/open_parts.hpp"
#include "visibility/polygons/visible_faces.hpp"

namespace ligne::atherton_weiler {

class BorderLines {
 public:
  /// Leads every border part back to its candidate edge, if it has one.
  BorderLines(const ProjectedScene& scene, const Facets& facets, const VisibleFaces& visible);

  /// The visible parts of a candidate edge: where regions border on it, each at the lowest level that one of them has there:
  /// what is farther is seen through more. In order and disjoint.
  std::span<const LinePart> parts(std::size_t edge) const {
    return std::span(parts_).subspan(begin_[edge], begin_[edge + 1] - begin_[edge]);
  }
  /// Whether borders do not give all of the edge: a face of it has no area on the page, or touches another face somewhere,
  /// which takes what lies on it, but does not hide its lines.
  bool needs_study(std::size_t edge) const { return needs_study_[edge] != 0; }

 private:
  std::vector<std::uint32_t> begin_;
  std::vector<LinePart> parts_;
  std::vector<std::uint8_t> needs_study_;
};

}  // namespace ligne::atherton_weiler
