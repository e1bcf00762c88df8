#pragma once
/// Messages on standard error.

#include <string>
#include <string_view>

#include "scene/model/diagnostics.hpp"

namespace ligne {

/// Writes "ligne: TEXT" as one line of bounded length, whatever the text contains.
void say(std::string_view text);

/// Writes "ligne: PLACE: warning: TEXT".
void warn(const std::string& place, const std::string& text);

/// Warns of faults repaired while reading, one line per kind with its count; `with_areas` as in Warnings::lines().
void warn(const std::string& place, const Warnings& warnings, bool with_areas = true);

}  // namespace ligne
