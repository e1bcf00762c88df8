#pragma once
/// Finds the name meant by a misspelt word.

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace ligne {

/// The name that differs least from `word` by typing slips: letters left out, added, replaced, or exchanged with their
/// neighbours. None are allowed in up to two letters, one in up to five, two in more. Leading dashes and text after a
/// "=" are ignored. Of equally near names the longest wins, since letters are left out more often than added, and then
/// the first. If none is so near: the longest name with which the word begins, or else the first that begins with the
/// word, with at least three letters. Nothing if there is none either.
std::optional<std::string_view> closest_name(std::string_view word, std::span<const std::string_view> names);

/// " (NAME?)", to follow an unknown word in a message; empty if no name is near.
std::string suggestion(std::string_view word, std::span<const std::string_view> names);

}  // namespace ligne
