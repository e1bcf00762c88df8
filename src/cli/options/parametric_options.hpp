#pragma once
/// Surfaces as three formulas in u and v, of ligne surface and among the models of ligne draw.

#include <string>

#include "cli/options/options.hpp"
#include "picture/surface/surface_request.hpp"

namespace ligne {

/// --parametric X Y Z, repeatable.
void add_parametric(OptionGroup& group, SurfaceRequest& request, const std::string& help);

/// -u and -v, repeatable: the ranges of one surface after the other.
void add_parameter_ranges(OptionGroup& group, SurfaceRequest& request);

}  // namespace ligne
