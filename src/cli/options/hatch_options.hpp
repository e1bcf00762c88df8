#pragma once
/// Options that say how faces are hatched.

#include "picture/requests.hpp"

namespace CLI {
class App;
}

namespace ligne {

void add_hatch_options(CLI::App& app, HatchRequest& request);

}  // namespace ligne
