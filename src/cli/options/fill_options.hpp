#pragma once
/// Options for filled faces and light sources.

#include "picture/requests.hpp"

namespace CLI {
class App;
}

namespace ligne {

void add_fill_options(CLI::App& app, FillRequest& request);

}  // namespace ligne
