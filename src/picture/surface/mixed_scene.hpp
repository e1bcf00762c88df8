#pragma once
/// Surfaces among models.

#include "picture/models/models.hpp"
#include "picture/surface/surface_request.hpp"

namespace ligne {

/// Throws RequestError for options of surfaces if there are no surfaces.
void check_mixed_scene(const SurfaceRequest& request);

/// Adds the surfaces, if any, to the models, rotated to the up axis of the picture, and their curves to its lines.
/// Throws RequestError, InputError.
void add_surfaces(const SurfaceRequest& request, LoadedModels& models, PictureRequest& picture, RunReport& run);

}  // namespace ligne
