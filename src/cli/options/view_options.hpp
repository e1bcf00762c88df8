#pragma once
/// Options for the view of the scene.

#include <string>

#include "picture/requests.hpp"

namespace CLI {
class App;
}

namespace ligne {

/// `standard`: the default view shown in the help text.
void add_view_options(CLI::App& app, ViewRequest& request, const std::string& standard = "iso");

}  // namespace ligne
