#pragma once
/// Options for hatched faces.

#include "picture/requests.hpp"

namespace CLI {
class App;
}

namespace ligne {

void add_hatch_options(CLI::App& app, HatchRequest& request);

}  // namespace ligne
