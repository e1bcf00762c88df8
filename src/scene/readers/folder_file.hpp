#pragma once
/// Files that a model names.

#include <string>

namespace ligne {

/// Whether a name is a relative path that stays in its folder on every system.
bool stays_in_folder(const std::string& path);

}  // namespace ligne
