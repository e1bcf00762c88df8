#pragma once
/// The JSON drawing of a scene: strokes with their sources, regions, surfaces and the view. docs/drawing-format.md.

#include <string>

#include "plotting/writers/writers.hpp"

namespace ligne {

class DrawnScene;

/// Returns the JSON. `drawn` must have the source edges of strokes. Throws std::runtime_error.
std::string scene_json(const DrawnScene& drawn, const PlotOptions& plot);

}  // namespace ligne
