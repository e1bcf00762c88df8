#pragma once
/// Files of models, and others, that people have and that are not read here.

#include <cstddef>
#include <optional>
#include <span>
#include <string>

namespace ligne {

/// The message of a file that is known by its first bytes and is not read: what it is, and how to convert it. Nothing when
/// it is not known.
std::optional<std::string> known_stranger(std::span<const std::byte> bytes);

}  // namespace ligne
