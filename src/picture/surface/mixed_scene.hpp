#pragma once
/// Surfaces among models.

#include "picture/models/models.hpp"
#include "picture/surface/surface_request.hpp"

namespace ligne {

/// Throws RequestError for options of surfaces where there is none.
void check_mixed_scene(const SurfaceRequest& request);

/// Adds the surfaces to the models, if there are any, upright as the picture is, and their curves to its lines. Throws
/// RequestError, InputError.
void add_surfaces(const SurfaceRequest& request, LoadedModels& models, PictureRequest& picture, RunReport& run);

}  // namespace ligne
