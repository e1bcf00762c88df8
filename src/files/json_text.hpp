#pragma once
/// Strings of JSON files that are written as a stream.

#include <string>
#include <string_view>

namespace ligne {

/// The text as a JSON string, with quotes. Bytes that are not UTF-8 are replaced.
std::string json_string(std::string_view text);

}  // namespace ligne
