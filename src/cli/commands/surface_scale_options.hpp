#pragma once
/// Options of ligne surface for the lengths of its axes.

#include "picture/surface/surface_request.hpp"

namespace CLI {
class App;
}

namespace ligne {

void add_surface_scale_options(CLI::App& surface, SurfaceRequest& request);

}  // namespace ligne
