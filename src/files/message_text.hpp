#pragma once
/// Makes text from files and command lines fit for messages: one line of bounded length, whatever it contains.

#include <cstddef>
#include <string>
#include <string_view>

namespace ligne {

/// Largest length of a message in bytes; with "ligne: " and the line end, an error line stays below 500.
inline constexpr std::size_t kLongestMessage = 490;

/// Largest length of a piece of input in a message, in bytes.
inline constexpr std::size_t kLongestShown = 40;

/// Largest length of a file name within a message, in bytes; the name at its beginning may be longer.
inline constexpr std::size_t kLongestPath = 200;

/// Makes a piece of input printable. Control characters, line ends of any kind, marks of direction and bytes that are
/// not UTF-8 are escaped (\n, \x1b). A text longer than `longest` bytes then ends in "...". Other texts stay unchanged.
std::string printable(std::string_view text, std::size_t longest = kLongestShown);

/// The printable text in quotes.
std::string shown(std::string_view text, char quote = '\'');

/// Makes a whole message printable in the same way. If it is too long its middle is left out, since it begins with the
/// place and ends with the cause. White space at its end is removed.
std::string message_line(std::string_view text, std::size_t longest = kLongestMessage);

/// The text with the letters A to Z in lower case.
std::string lower_case(std::string_view text);

/// The shortest decimal number that reads back as the same double.
std::string shortest(double value);

/// The number with `digits` significant digits: for people, not for programs.
std::string rounded(double value, int digits = 6);

/// "3 faces with holes", "1 face with holes". `plural` begins with a plural noun, behind two words at most
/// ("missing libraries"); " that are " in it becomes " that is ".
std::string counted(std::size_t n, std::string_view plural);

/// Seconds as "12.3 ms" or "4.56 s".
std::string duration(double seconds);

}  // namespace ligne
