#pragma once
/// The one list of visibility methods.

#include <span>
#include <string_view>

#include "visibility/method.hpp"

namespace ligne {

/// All methods, in the order in which people are shown them.
std::span<const Method* const> all_methods();

/// The method of that name, or nullptr. "auto" is the default method.
const Method* find_method(std::string_view name);

}  // namespace ligne
