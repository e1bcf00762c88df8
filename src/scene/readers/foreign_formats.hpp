#pragma once
/// Recognises files of models and others that people have, but that are not read.

#include <cstddef>
#include <optional>
#include <span>
#include <string>

namespace ligne {

/// A message for a file that is known by its first bytes but not read: its kind, and how to convert it. Nothing for
/// unknown files.
std::optional<std::string> find_foreign_format(std::span<const std::byte> bytes);

}  // namespace ligne
