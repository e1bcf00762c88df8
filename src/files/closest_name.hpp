#pragma once
/// The name that somebody meant who wrote it wrong.

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace ligne {

/// The one of `names` that differs least from `word`, as far as slips of the keys go: letters left out, added, replaced, or
/// exchanged with their neighbours; none in up to two letters, one in up to five, two in more. How many dashes lead does
/// not count, nor does what follows a "=". Of several the longest, as letters are left out more often than added, and of
/// those the first. Where none is so near: the longest that the word begins with, or else the first that begins with the
/// word, of three letters at least. Nothing where there is none either.
std::optional<std::string_view> closest_name(std::string_view word, std::span<const std::string_view> names);

/// " (NAME?)" for messages, behind a word that is not known; empty where no name is near.
std::string suggestion(std::string_view word, std::span<const std::string_view> names);

}  // namespace ligne
