#pragma once
/// Options for surfaces given by three formulas in u and v, of ligne surface and ligne draw.

#include <string>

#include "cli/options/options.hpp"
#include "picture/surface/surface_request.hpp"

namespace ligne {

/// Adds --parametric X Y Z, repeatable.
void add_parametric(OptionGroup& group, SurfaceRequest& request, const std::string& help);

/// Adds -u and -v, repeatable: one range per surface, in order.
void add_parameter_ranges(OptionGroup& group, SurfaceRequest& request);

}  // namespace ligne
