#pragma once
/// ligne surface: draws a surface z = f(x, y) as iso-curves with hidden lines removed.

#include <string>
#include <vector>

#include "cli/commands/surface_options.hpp"

namespace ligne {

void setup_surface(CLI::App& app, SurfaceOptions& options);

/// Puts formulas with a leading minus in parentheses, because CLI11 would take them for options: "-x^2" becomes "(-x^2)".
void protect_formulas(std::vector<std::string>& arguments);

/// Throws UsageError, RequestError, InputError, std::runtime_error.
void run_surface(const SurfaceOptions& options);

}  // namespace ligne
