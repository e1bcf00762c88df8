#pragma once
/// Text from files and command lines as it can stand in a message: one line of bounded length, whatever it holds.

#include <cstddef>
#include <string>
#include <string_view>

namespace ligne {

/// Bytes of the longest message; with "ligne: " and the line end an error line stays below 500.
inline constexpr std::size_t kLongestMessage = 490;

/// Bytes that are shown of a piece of input.
inline constexpr std::size_t kLongestShown = 40;

/// Bytes that are shown of the name of a file, where it is not the place that a message begins with.
inline constexpr std::size_t kLongestPath = 200;

/// A piece of input for a message. Control characters, line ends of any kind, marks of direction and bytes that are not
/// UTF-8 are escaped (\n, \x1b); what is longer than `longest` bytes then ends in "...". A text without such characters,
/// and not too long, stays as it is.
std::string printable(std::string_view text, std::size_t longest = kLongestShown);

/// The text as messages show it, in quotes.
std::string shown(std::string_view text, char quote = '\'');

/// A whole message, escaped in the same way; one that is too long loses its middle, since it begins with the place and ends
/// with the cause. White space at its end is left out.
std::string message_line(std::string_view text, std::size_t longest = kLongestMessage);

/// The text with the letters A to Z made small.
std::string lower_case(std::string_view text);

/// The shortest decimal number that reads back as the same double.
std::string shortest(double value);

/// The number with `digits` digits that count: for people, not for programs.
std::string rounded(double value, int digits = 6);

/// Seconds as "12.3 ms" or "4.56 s".
std::string duration(double seconds);

}  // namespace ligne
