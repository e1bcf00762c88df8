#pragma once
/// Makes text from outside safe.

#include <string>
#include <string_view>

namespace ligne {

/// The characters of a UTF-8 text. Every byte that is not part of a well-formed sequence becomes U+FFFD; control characters
/// become blanks.
std::u32string decode_utf8(std::string_view text);

/// The text as well-formed UTF-8.
std::string clean_utf8(std::string_view text);

/// Text escaped for XML. Characters that XML does not have become U+FFFD.
std::string xml_text(std::string_view text);

}  // namespace ligne
