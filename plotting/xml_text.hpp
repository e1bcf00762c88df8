#pragma once
/// Text as it can stand in XML.

#include <string>
#include <string_view>

namespace ligne {

/// Escaped; what is not an XML character becomes U+FFFD.
std::string xml_text(std::string_view text);

}  // namespace ligne
