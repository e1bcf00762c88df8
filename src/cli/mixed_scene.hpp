#pragma once
/// Surfaces z = f(x, y) among the models of ligne draw.

#include "picture/models.hpp"
#include "picture/surface_request.hpp"

namespace CLI {
class App;
}

namespace ligne {

void add_mixed_scene_options(CLI::App& draw, SurfaceRequest& request);

/// Throws UsageError for options that need a surface where there is none.
void check_mixed_scene(const SurfaceRequest& request);

/// Adds the surfaces to the models, if there are any, upright as the picture is, and their curves to its lines. Throws
/// RequestError, InputError.
void add_surfaces(const SurfaceRequest& request, LoadedModels& models, PictureRequest& picture, RunReport& run);

}  // namespace ligne
