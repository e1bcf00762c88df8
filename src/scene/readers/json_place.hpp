#pragma once
/// Where in a JSON text the parser gives up.

#include <cstddef>
#include <string_view>

namespace ligne {

/// Number of the line, from 1, on which a byte lies; the last line for bytes beyond the text.
std::size_t line_of_byte(std::string_view text, std::size_t byte);

/// Number of the line on which the first number stands that is too large for a double. Its exception does not say; so the
/// text, which must have such a number, is gone through once more.
std::size_t line_of_number_out_of_range(std::string_view text);

}  // namespace ligne
