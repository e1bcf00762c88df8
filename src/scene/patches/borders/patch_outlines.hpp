#pragma once
/// The boundary lines of patches. They show which patches are parts of a free form that fit a surface only by accident.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"
#include "scene/patches/facet_graph.hpp"

namespace ligne {

struct Patch;

/// The outline of one patch. The patch continues smoothly across an edge of its outline if the angle between the facets
/// is at most kLargestBend.
struct PatchOutline {
  std::size_t facets = 0;  ///< number of facets of the patch
  double length = 0;       ///< of the outline, model units
  /// Lengths of the parts across which the patch continues smoothly: into a free form; into a free form or another
  /// patch.
  double into_freeform = 0, into_curved = 0;
  /// Length along which its surface, not its facets, has the direction of planes beside it. A free form has no such
  /// surfaces by accident.
  double into_planes = 0;
  bool is_piece = false;  ///< it continues into a piece of the same bent tube (are_tube_pieces())

  /// Whether it is a small patch that continues into a free form along most of its outline, and exactly into no plane.
  bool is_speck() const {
    return facets <= kMostSpeckFacets && into_freeform > kMostOfOutline * length &&
           into_planes < kTangentPartOfOutline * length;
  }
  /// Whether it continues into free forms or other patches along most of its outline, like the bands of a bent tube, or is
  /// such a band next to another one: most of its outline may lie where the tube was cut.
  bool is_band() const { return is_piece || into_curved > kMostOfOutline * length; }

 private:
  // Adjustable.
  static constexpr std::size_t kMostSpeckFacets = 24;  ///< largest number of facets of a speck
  static constexpr double kMostOfOutline = 0.5;        ///< "most" of an outline: larger fractions of its length
  /// Least fraction of the outline of a fillet at a plane. A fillet has four sides, and the two at its ends may be the
  /// longer ones.
  static constexpr double kTangentPartOfOutline = 0.15;
};

/// The surfaces on which the facets of an object lie.
struct FacetSurfaces {
  std::span<const Patch> patches;
  std::span<const std::uint32_t> patch_of;    ///< by facet: index in `patches`, or kNone
  std::span<const std::uint8_t> is_freeform;  ///< by facet, as freeform_facets() says
};

/// The outlines of the patches. `edges` are those of the object.
std::vector<PatchOutline> patch_outlines(const Scene& scene, std::span<const Edge> edges, const Object& object,
                                         const FacetGraph& graph, const FacetSurfaces& surfaces);

}  // namespace ligne
