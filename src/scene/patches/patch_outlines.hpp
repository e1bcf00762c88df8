#pragma once
/// The outlines of patches. A surface found in the midst of a free form is a part of it that lies on one by accident.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"
#include "scene/patches/facet_graph.hpp"

namespace ligne {

struct Patch;

/// The outline of one patch. It runs on smoothly where the facets bend by no more than one surface does (kLargestBend).
struct PatchOutline {
  std::size_t facets = 0;
  double length = 0;
  double into_freeform = 0, into_curved = 0;  ///< lengths where it runs on into a free form, and into one or another patch

  /// A small patch that runs into a free form over most of its outline.
  bool is_speck() const { return facets <= kMostSpeckFacets && into_freeform > kMostOfOutline * length; }
  /// A patch that runs into free forms and other patches over most of its outline, as the bands of a bent tube do.
  bool is_band() const { return into_curved > kMostOfOutline * length; }

 private:
  // Adjustable.
  static constexpr std::size_t kMostSpeckFacets = 24;
  static constexpr double kMostOfOutline = 0.5;
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
