#pragma once
/// Visible faces as strokes: how each is hatched, and what of it is seen.

#include <span>
#include <vector>

#include "cli/hatch_options.hpp"
#include "drawing/drawing.hpp"
#include "drawing/result_models.hpp"
#include "plotting/pens.hpp"
#include "plotting/writers.hpp"
#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"
#include "view/view.hpp"

namespace ligne {

/// Faces that are one surface: their common edges are no creases. Strokes run on over them, and end at the rims of patches.
struct HatchPatches {
  std::vector<std::uint32_t> of_face;
  std::uint32_t count = 0;
};
HatchPatches hatch_patches(const Scene& scene, const Topology& topology, double crease_degrees);

/// What all ways of hatching need to know.
struct HatchScene {
  const HatchRequest& request;
  const Scene& scene;
  const View& view;
  std::span<const Light> lights;  ///< empty: one at the eye
  const HatchPatches& patches;
  const PenTable& pens;
  const PlotOptions& plot;
};

/// Hatches regions that are seen directly. What no light reaches is hatched across too. Layers "hatch": one, or one for each
/// shade or material that pens are told apart by.
std::vector<Layer> hatch_regions(const HatchScene& hatch, const std::vector<Region>& regions);

/// Hatches the spans that a method gives, on scan lines that run along the strokes: the scene is studied once for every
/// direction, turned on the page. Lights cast no shadows.
std::vector<Layer> hatch_spans(const HatchScene& hatch, const Topology& topology, const Method& method,
                               const MethodSettings& settings, bool cull);

}  // namespace ligne
