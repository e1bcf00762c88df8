#pragma once
/// Options of ligne surface for lines in addition to the curves, and for their occluder.

#include "picture/surface/surface_request.hpp"

namespace CLI {
class App;
}

namespace ligne {

void add_curve_options(CLI::App& app, CurveRequest& request);

}  // namespace ligne
