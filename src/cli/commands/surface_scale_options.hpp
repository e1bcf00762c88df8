#pragma once
/// The options of ligne surface that say how long its axes are.

#include "picture/surface/surface_request.hpp"

namespace CLI {
class App;
}

namespace ligne {

void add_surface_scale_options(CLI::App& surface, SurfaceRequest& request);

}  // namespace ligne
