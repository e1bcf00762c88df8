#pragma once
/// Options of ligne surface that say which lines are drawn beside plain curves, and what hides.

#include "picture/surface/surface_request.hpp"

namespace CLI {
class App;
}

namespace ligne {

void add_curve_options(CLI::App& app, CurveRequest& request);

}  // namespace ligne
