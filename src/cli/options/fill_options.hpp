#pragma once
/// Options that say how faces are filled, and where light comes from.

#include "picture/requests.hpp"

namespace CLI {
class App;
}

namespace ligne {

void add_fill_options(CLI::App& app, FillRequest& request);

}  // namespace ligne
