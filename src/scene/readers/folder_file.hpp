#pragma once
/// Checks the files that a model refers to.

#include <string>

namespace ligne {

/// Whether a name is a relative path that stays within its folder on every system.
bool stays_in_folder(const std::string& path);

}  // namespace ligne
