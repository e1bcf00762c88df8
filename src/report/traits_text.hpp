#pragma once
/// Formats the traits of a scene for people and for programs.

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <utility>
#include <vector>

#include "picture/choice/scene_traits.hpp"

namespace ligne {

/// Returns names and values, in order.
std::vector<std::pair<std::string, std::string>> lines_of(const SceneTraits& traits);

/// Formats the traits as JSON. A count that was stopped is {"at_least": N}.
nlohmann::ordered_json json_of(const SceneTraits& traits);

}  // namespace ligne
