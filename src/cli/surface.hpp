#pragma once
/// ligne surface: a surface z = f(x, y) as iso-curves, hidden parts removed.

#include "cli/surface_options.hpp"

namespace ligne {

void setup_surface(CLI::App& app, SurfaceOptions& options);

/// Throws UsageError, RequestError, InputError, std::runtime_error.
void run_surface(const SurfaceOptions& options);

}  // namespace ligne
