#pragma once
/// Rows of facets: strips of a mesh side by side, as tessellators cut a curved surface.

#include <cstdint>
#include <span>
#include <vector>

#include "base/no_index.hpp"
#include "scene/patches/facet_graph.hpp"

namespace ligne {

/// The rows in which the facets of an object follow one another.
class FacetRows {
 public:
  FacetRows(const Scene& scene, const Topology& topology, const FacetGraph& graph)
      : scene_(scene), topology_(topology), graph_(graph) {}

  /// The last facet before the next edge of a row, and the arc there. A facet of the row may be two triangles.
  struct Step {
    std::uint32_t last = kNone;
    FacetGraph::Arc arc{kNone, kNone};
    explicit operator bool() const { return last != kNone; }
  };

  /// The angle at an arc from f, in radians: positive where the neighbour falls away.
  double bend(std::uint32_t f, const FacetGraph::Arc& arc) const;

  /// The next edge of the row behind an edge of f: nearly parallel, and with an angle like `angle`, the one at the edge.
  Step next(std::uint32_t f, std::uint32_t edge, double angle) const;

  /// Whether there is a next edge on both sides of an arc from f.
  bool goes_on(std::uint32_t f, const FacetGraph::Arc& arc) const {
    const double angle = bend(f, arc);
    return next(f, arc.edge, angle) && next(arc.facet, arc.edge, angle);
  }

  /// Number of facets across the patch of f behind an arc from f, `most` + 1 if there are more. `patch_of`: per facet.
  int depth(std::uint32_t f, const FacetGraph::Arc& arc, std::span<const std::uint32_t> patch_of, int most) const;

  /// Largest distance of a corner of a facet from the line of an edge, model units.
  double width(std::uint32_t f, std::uint32_t edge) const;

 private:
  Step next(std::uint32_t f, std::uint32_t edge, double angle, int rest) const;
  Point3 direction(std::uint32_t edge) const;

  const Scene& scene_;
  const Topology& topology_;
  const FacetGraph& graph_;
};

/// Whether two angles or widths of a row, not negative, are alike.
bool are_alike_in_row(double a, double b);

/// The edges of the topology between two patches at which one row of facets goes on, alike in width on both sides, and
/// one of the patches is one or two facets deep. The bands of an ellipsoid are such patches: each lies on some cone or
/// sphere by accident, and tells nothing of the curvature across its borders. `patch_of`: per facet. Ascending;
/// O(n log n).
std::vector<std::uint32_t> row_edges(const Scene& scene, const Topology& topology, const FacetGraph& graph,
                                     std::span<const std::uint32_t> patch_of);

}  // namespace ligne
