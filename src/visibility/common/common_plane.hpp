#pragma once
/// The plane in which several facets lie: none of them hides what lies in it, and no two of them penetrate.

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "visibility/common/cell_facet.hpp"
#include "visibility/common/facet.hpp"
#include "visibility/common/hidden_interval.hpp"

namespace ligne {

/// A plane such that every corner of some facets lies within half of each one's depth tolerance of it.
///
/// Another facet's corner is then, with W the sum of its absolute weights over a facet, no farther from that facet's plane
/// than (1 + W) / 2 of the tolerance: it is on it.
class CommonPlane {
 public:
  /// Adjustable: for more facets than that the plane nearest to all corners is tried, too.
  static constexpr std::size_t kLongList = 24;

  /// The plane of the facets with these numbers in `facets`, if there is one; for few of them none is found now and then.
  static std::optional<CommonPlane> of(const ProjectedScene& scene, const std::vector<Facet>& facets,
                                       std::span<const CellFacet> list);

  /// Whether the line lies within half the tolerance of the plane, all along: it is no deeper than the tolerance behind any
  /// place of any of the facets, so that none of them hides a part of it.
  bool holds(const PageLine& line) const;

 private:
  CommonPlane() = default;
  static CommonPlane of_facet(const ProjectedScene& scene, const Facet& facet);
  /// By least squares of depths; none where all corners lie on one line of the page.
  static std::optional<CommonPlane> nearest_to(const ProjectedScene& scene, const std::vector<Facet>& facets,
                                               std::span<const CellFacet> list);
  /// How far from it a corner of the facets lies at the most, over the least tolerance; or that of the first corners beyond
  /// `enough`.
  double farthest(const ProjectedScene& scene, const std::vector<Facet>& facets, std::span<const CellFacet> list,
                  double enough);
  /// How far from it the place may lie, roundings included.
  double distance(LatticePoint p, double z) const;

  double zx_ = 0, zy_ = 0, z_ = 0;  ///< depth zx x + zy y + z
  double touch_ = 0;                ///< the least tolerance
};

}  // namespace ligne
