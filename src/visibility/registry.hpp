#pragma once
/// The one list of visibility methods.

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "visibility/method.hpp"

namespace ligne {

/// All methods, in the order in which lists show them.
std::span<const Method* const> all_methods();

/// The method for lines if nothing is known about the scene.
const Method& default_method();

/// The method of that name, or nullptr. "auto" is the default method.
const Method* find_method(std::string_view name);

/// The first method that produces regions. It draws fills, hatching and shadows if the request names no method.
const Method& region_method();

/// The parameter of that name of the first method that has it, or nullptr. Its kind, meaning and values may differ in
/// another.
const MethodParameter* find_parameter(std::string_view name);

/// The names of the methods that produce at least one of the products, as "a, b".
std::string methods_with(std::uint8_t products);

}  // namespace ligne
