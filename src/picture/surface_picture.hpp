#pragma once
/// Pictures of surfaces z = f(x, y) and of parametric ones.

#include "picture/surface_request.hpp"
#include "picture/write_picture.hpp"

namespace ligne {

/// Draws the surfaces by the floating horizon where it can, else as meshes. Warnings go to `run`, as do the grids that were
/// read. Throws RequestError, InputError, std::runtime_error.
Picture draw_surface(const SurfaceRequest& request, RunReport& run);

}  // namespace ligne
