#pragma once
/// Finds the place in a JSON text where the parser stops.

#include <cstddef>
#include <string_view>

namespace ligne {

/// Number of the line, from 1, on which a byte lies; the last line for bytes beyond the text.
std::size_t line_of_byte(std::string_view text, std::size_t byte);

/// Number of the line with the first number that is too large for a double. The parser's exception does not tell it, so
/// the text, which must have such a number, is parsed again.
std::size_t line_of_number_out_of_range(std::string_view text);

}  // namespace ligne
