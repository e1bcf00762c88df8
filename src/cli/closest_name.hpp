#pragma once
/// What somebody meant who wrote a name wrong.

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace ligne {

/// The one of `names` that differs least from `word`, as far as slips of the keys go: letters left out, added, replaced, or
/// exchanged with their neighbours; none in up to two letters, one in up to five, two in more. How many dashes lead does
/// not count, nor does what follows a "=". Of several the longest, as letters are left out more often than added, and of
/// those the first. Nothing where none is near.
std::optional<std::string> closest_name(std::string_view word, std::span<const std::string> names);

}  // namespace ligne
