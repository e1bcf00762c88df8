#pragma once
/// Rows of facets between parallel edges: pieces of cylinders that cuts have left, and of extruded splines.

#include <cstddef>
#include <cstdint>
#include <span>

#include "scene/patches/facet_graph.hpp"

namespace ligne {

/// Least sine of a bend in a row (half a degree). Facets that bend less form one plane. Adjustable.
inline constexpr double kLeastRowSine = 0.01;

/// Sine of the bend at an arc of a facet: positive where the neighbour falls away from the facet's plane.
double bend_at(const FacetGraph& graph, std::uint32_t f, const FacetGraph::Arc& arc);

/// Finds the rows of facets without a surface.
class FacetRows {
 public:
  /// `patch_of`: per facet its patch, or kNone.
  FacetRows(const Scene& scene, const Topology& topology, const FacetGraph& graph, std::span<const std::uint32_t> patch_of)
      : scene_(scene), topology_(topology), graph_(graph), patch_of_(patch_of) {}

  /// Whether a facet and one behind an edge lie in one row: between parallel edges with the same bends, as wide. By
  /// symmetry, a plane between fillets and the facets of these at its ends have equal edges too, but no common one.
  bool is_in_row(std::uint32_t f) const;

  /// Whether a facet is the last one of a row, as wide as that behind it. It meets a plane at half of the row's bend.
  bool ends_row(std::uint32_t f) const;

  /// Whether a facet belongs to five facets or more between parallel edges that all bend to one side, by little and by
  /// gradually changing angles: a few facets of an extruded spline.
  bool is_in_long_row(std::uint32_t f) const;

 private:
  template <class Condition>
  bool any_row(std::uint32_t f, const Condition& condition) const;
  bool goes_on_behind(std::uint32_t f, const FacetGraph::Arc& arc) const;
  bool are_gradual(std::uint32_t edge, double sine, std::uint32_t other, double other_sine) const;
  std::size_t count_behind(std::uint32_t f, FacetGraph::Arc arc) const;
  Point3 along(std::uint32_t e) const;

  const Scene& scene_;
  const Topology& topology_;
  const FacetGraph& graph_;
  std::span<const std::uint32_t> patch_of_;
};

}  // namespace ligne
