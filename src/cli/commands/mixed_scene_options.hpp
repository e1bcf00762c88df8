#pragma once
/// Surfaces z = f(x, y) among the models of ligne draw.

#include "picture/surface/mixed_scene.hpp"

namespace CLI {
class App;
}

namespace ligne {

void add_mixed_scene_options(CLI::App& draw, SurfaceRequest& request);

}  // namespace ligne
