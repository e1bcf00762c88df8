#pragma once
/// Listings of the methods and plotters to choose from, as tables for people and as JSON.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "visibility/method.hpp"

namespace ligne {

/// Names of the products of a method, such as "strokes" and "regions".
std::vector<std::string> product_names(std::uint8_t products);

/// "exact" or "resolution-limited".
std::string precision_name(const MethodTraits& traits);

/// A paragraph for each method: the options that people need, and with `settings` also those for experiments.
std::string methods_text(std::span<const Method* const> methods, bool settings);
/// {"format": "ligne-methods", "version": 1, "methods"}.
std::string methods_json(std::span<const Method* const> methods);

std::string devices_text();
/// {"format": "ligne-devices", "version": 1, "devices"}.
std::string devices_json();

}  // namespace ligne
