#pragma once
/// The common plane of several facets: none of them hides a line in the plane, and no two of them penetrate.

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "visibility/common/cell_facet.hpp"
#include "visibility/common/facet.hpp"
#include "visibility/common/hidden_interval.hpp"

namespace ligne {

/// A plane from which every corner of the facets is at most half the least of their depth tolerances away.
///
/// Let W be the sum of the absolute weights of a corner over another of the facets. Then the corner is no farther from
/// the plane of that facet than (1 + W) / 2 of the tolerance, so it counts as in the plane.
class CommonPlane {
 public:
  /// Number of facets above which the least-squares plane of all corners is tried, too. Adjustable.
  static constexpr std::size_t kLongList = 24;

  /// The common plane of the listed facets, if there is one. For short lists it may miss a plane that exists.
  static std::optional<CommonPlane> of(const ProjectedScene& scene, const std::vector<Facet>& facets,
                                       std::span<const CellFacet> list);

  /// Whether the whole line lies within half the tolerance of the plane. Then it is nowhere farther behind a facet than
  /// the tolerance, so no facet hides a part of it.
  bool holds(const PageLine& line) const;

 private:
  CommonPlane() = default;
  static CommonPlane of_facet(const ProjectedScene& scene, const Facet& facet);
  /// The plane of least squares of depths; none if all corners lie on one line of the page.
  static std::optional<CommonPlane> nearest_to(const ProjectedScene& scene, const std::vector<Facet>& facets,
                                               std::span<const CellFacet> list);
  /// Largest distance of a corner from the plane, in units of the least tolerance. It stops at the first facet beyond
  /// `enough`.
  double farthest(const ProjectedScene& scene, const std::vector<Facet>& facets, std::span<const CellFacet> list,
                  double enough);
  /// Upper bound of the distance in depth of the point from the plane, rounding included.
  double distance(LatticePoint p, double z) const;

  double zx_ = 0, zy_ = 0, z_ = 0;  ///< depth zx x + zy y + z
  double touch_ = 0;                ///< least depth tolerance of the facets
};

}  // namespace ligne
