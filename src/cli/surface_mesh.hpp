#pragma once
/// ligne surface by the mesh methods: whatever the floating horizon can not draw, and the surface as a mesh file.

#include "cli/run_files.hpp"
#include "cli/surface_options.hpp"

namespace ligne {

/// Draws the surfaces, or writes their mesh. Throws UsageError, InputError, std::runtime_error.
void run_surface_mesh(const SurfaceOptions& options, RunFiles& files);

}  // namespace ligne
