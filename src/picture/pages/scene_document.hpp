#pragma once
/// The JSON drawing of a scene: strokes with their sources, regions, surfaces and the view. docs/drawing-format.md.

#include <string>

#include "plotting/writers/writers.hpp"

namespace ligne {

class DrawnScene;

/// `drawn` can tell sources. Throws std::runtime_error.
std::string scene_json(const DrawnScene& drawn, const PlotOptions& plot);

}  // namespace ligne
