#pragma once
/// Options that say from where the scene is seen.

#include <string>

#include "picture/requests.hpp"

namespace CLI {
class App;
}

namespace ligne {

/// `standard`: what holds when no view is named, for the help text.
void add_view_options(CLI::App& app, ViewRequest& request, const std::string& standard = "iso");

}  // namespace ligne
