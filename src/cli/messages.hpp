#pragma once
/// Lines for people on standard error.

#include <string>
#include <string_view>

#include "scene/model/diagnostics.hpp"

namespace ligne {

/// Writes "ligne: TEXT" and a line end: one line of bounded length, whatever the text holds.
void say(std::string_view text);

/// Writes "ligne: PLACE: warning: TEXT".
void warn(const std::string& place, const std::string& text);

/// Warns of faults mended while reading: one line for each kind, with its count.
void warn(const std::string& place, const Warnings& warnings);

}  // namespace ligne
