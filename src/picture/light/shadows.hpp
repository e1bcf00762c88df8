#pragma once
/// Cast shadows, after P. Atherton, K. Weiler, D. Greenberg, "Polygon shadow generation", SIGGRAPH 1978: what a light sees
/// is lit.

#include <span>
#include <vector>

#include "drawing/result_models.hpp"
#include "linework/stroke.hpp"
#include "scene/model/topology.hpp"
#include "view/projected_scene.hpp"

namespace ligne {

/// At most so many lights: one bit of Region::lights each.
inline constexpr std::size_t kMostLights = 32;

/// A straight piece of the border between more light and less on one face.
struct ShadowBorder {
  std::uint32_t face = 0;
  std::uint32_t level = 0;  ///< of the region that it lies on
  LatticePoint from, to;    ///< on the viewer's page
};

struct CastShadows {
  std::vector<Region> regions;
  std::vector<ShadowBorder> borders;
};

/// Cuts every region into the parts that the lights reach and those that they do not; Region::lights says which. The study
/// is made once from each light; what it sees of a face is a detail of the face, clipped by what the viewer sees of it. A
/// face is lit on the side that the viewer sees, or not at all. Of more than kMostLights lights the first ones count. Behind
/// a transparent face the light has the share 1 - opacity, behind several the product of their shares
/// (Region::light_shares): where scenes have several opacities the study is made for each of them, with only the faces of
/// that opacity in the way. Borders along the region's own border are left out: where a face ends, or begins to be hidden,
/// there are other lines. `view` is that in which the regions are seen.
CastShadows cast_shadows(const Scene& scene, const Topology& topology, const View& view, std::span<const Light> lights,
                         const std::vector<Region>& regions);

/// The borders as strokes of class `shadow`. `model` is that of the same view.
void add_shadow_strokes(const Scene& scene, const View& view, const std::vector<ShadowBorder>& borders, StrokeModel& model);

}  // namespace ligne
