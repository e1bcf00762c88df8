#pragma once
/// Cast shadows, after P. Atherton, K. Weiler, D. Greenberg, "Polygon shadow generation", SIGGRAPH 1978: surfaces
/// visible from a light are lit.

#include <span>
#include <vector>

#include "drawing/result_models.hpp"
#include "linework/stroke.hpp"
#include "scene/model/topology.hpp"
#include "view/projected_scene.hpp"

namespace ligne {

/// Largest number of lights, one bit of Region::lights each.
inline constexpr std::size_t kMostLights = 32;

/// A straight piece of the border between more and less light on a face.
struct ShadowBorder {
  std::uint32_t face = 0;
  std::uint32_t level = 0;  ///< level of the region that it lies on
  LatticePoint from, to;    ///< on the viewer's page
};

struct CastShadows {
  std::vector<Region> regions;
  std::vector<ShadowBorder> borders;
};

/// Cuts every region into parts by the lights that reach them, and sets Region::lights.
///
/// Visibility is computed once from each light. The visible parts of a face are mapped onto the viewer's page and
/// clipped against the regions of the face. A face is lit on the side that the viewer sees, or not at all. Of more than
/// kMostLights lights the first ones count. Behind a transparent face a light has the share 1 - opacity, behind several
/// faces the product of their shares (Region::light_shares). If a scene has several opacities, visibility is computed
/// for each of them, and only faces of that opacity reduce the light. Borders along the region's own border are left
/// out, since other lines are drawn there. `view` is the view of the regions.
CastShadows cast_shadows(const Scene& scene, const Topology& topology, const View& view, std::span<const Light> lights,
                         const std::vector<Region>& regions);

/// Adds the borders as strokes of class `shadow`. `model` must belong to the same view.
void add_shadow_strokes(const Scene& scene, const View& view, const std::vector<ShadowBorder>& borders, StrokeModel& model);

}  // namespace ligne
