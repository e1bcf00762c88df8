#pragma once
/// The traits of a scene for people and for programs.

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <utility>
#include <vector>

#include "picture/choice/scene_traits.hpp"

namespace ligne {

/// Names and values, in their order.
std::vector<std::pair<std::string, std::string>> lines_of(const SceneTraits& traits);

/// A count that was given up is {"at_least": N}.
nlohmann::ordered_json json_of(const SceneTraits& traits);

}  // namespace ligne
