#pragma once
/// Small pieces of text for people.

#include <string>
#include <string_view>

namespace ligne {

/// The shortest decimal number that reads back as the same double.
std::string shortest(double value);

/// The number with `digits` digits that count: for people, not for programs.
std::string rounded(double value, int digits = 6);

/// Seconds as "12.3 ms" or "4.56 s".
std::string duration(double seconds);

/// Writes "ligne: TEXT" and a line end to standard error: one line of bounded length, whatever the text holds.
void say(std::string_view text);

}  // namespace ligne
