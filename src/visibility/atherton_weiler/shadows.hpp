#pragma once
/// Cast shadows, after P. Atherton, K. Weiler, D. Greenberg, "Polygon shadow generation", SIGGRAPH 1978: what a light sees is lit.

#include <span>
#include <vector>

#include "drawing/result_models.hpp"
#include "scene/topology.hpp"
#include "view/projected_scene.hpp"

namespace ligne::atherton_weiler {

/// At most so many lights: one bit of Region::lights each.
inline constexpr std::size_t kMostLights = 32;

/// Cuts every region into the parts that the lights reach and those that they do not; Region::lights says which. The study is made once
/// from each light; what it sees of a face is a detail of the face, clipped by what the viewer sees of it. A face is lit on the side that the
/// viewer sees, or not at all. Of more than kMostLights lights the first ones count. Transparent faces cast no shadow.
/// `view` is that in which the regions are seen.
std::vector<Region> cast_shadows(const Scene& scene, const Topology& topology, const View& view, std::span<const Light> lights,
                                 const std::vector<Region>& regions);

}  // namespace ligne::atherton_weiler
