#pragma once
/// Visible faces as strokes: how each is hatched, and what of it is seen.

#include <string_view>
#include <vector>

#include "drawing/drawing.hpp"
#include "drawing/result_models.hpp"
#include "picture/hatching/hatch_patches.hpp"
#include "picture/prepared_scene.hpp"
#include "plotting/writers/writers.hpp"
#include "scene/form/form_mesh.hpp"

namespace ligne {

/// The data that all ways of hatching need. `prepared` is as it was before the study.
struct HatchScene {
  const PreparedScene& prepared;
  const PlotOptions& plot;
  HatchPatches patches;  ///< none where nothing is hatched, now or later
  FormMesh form;         ///< where strokes follow the form

  const HatchRequest& request() const { return prepared.request.hatch; }
  const PenTable& pens() const { return prepared.request.plotter.pens; }
};

HatchScene hatch_scene(const PreparedScene& prepared, const PlotOptions& plot);

/// Throws the RequestError of a method that gives nothing to hatch.
[[noreturn]] void refuse_hatching(std::string_view method);

/// Hatches regions that are seen directly. What no light reaches is hatched across too. Layers "hatch": one, or one for each
/// shade or material that pens are chosen by; none where regions are not hatched. Throws RequestError.
std::vector<Layer> hatch_regions(const HatchScene& hatch, const std::vector<Region>& regions, RunReport& run);

/// Hatches the spans that a method gives, on scan lines that run along the strokes: the scene is studied once for every
/// direction, turned on the page. Back faces are left out, and lights cast no shadows. No layers where spans are not
/// hatched. To be called before the topology is given up. Throws RequestError.
std::vector<Layer> hatch_spans(const HatchScene& hatch, RunReport& run);

}  // namespace ligne
