#pragma once
/// Hatches visible faces.

#include <string_view>
#include <vector>

#include "drawing/drawing.hpp"
#include "drawing/result_models.hpp"
#include "picture/hatching/hatch_patches.hpp"
#include "picture/prepared_scene.hpp"
#include "plotting/writers/writers.hpp"
#include "scene/form/form_mesh.hpp"

namespace ligne {

/// The data for all kinds of hatching. `prepared` must not have been passed to compute_visibility() yet.
struct HatchScene {
  const PreparedScene& prepared;
  const PlotOptions& plot;
  HatchPatches patches;  ///< empty if nothing is hatched, now or later
  FormMesh form;         ///< empty unless strokes follow the form

  const HatchRequest& request() const { return prepared.request.hatch; }
  const PenTable& pens() const { return prepared.request.plotter.pens; }
};

HatchScene hatch_scene(const PreparedScene& prepared, const PlotOptions& plot);

/// Throws the RequestError for a method that returns nothing to hatch.
[[noreturn]] void refuse_hatching(std::string_view method);

/// Hatches the directly visible regions, crosswise where no light reaches. Returns layers "hatch": one, or one for each
/// shade or material that selects pens; none if regions are not hatched. Throws RequestError.
std::vector<Layer> hatch_regions(const HatchScene& hatch, const std::vector<Region>& regions, RunReport& run);

/// Hatches the spans of a method, on scan lines along the strokes: for each direction, the scene is turned on the page
/// and its visibility computed once. Back faces are left out, and lights cast no shadows. Returns no layers if spans
/// are not hatched. Call it while the topology exists. Throws RequestError.
std::vector<Layer> hatch_spans(const HatchScene& hatch, RunReport& run);

}  // namespace ligne
