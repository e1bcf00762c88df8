#pragma once
/// Internal entities of an XML document, which the parser at hand does not expand. Private to plotting.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace ligne::svg {

struct ExpandedDocument {
  std::string text;          ///< as many lines as the document has
  std::size_t external = 0;  ///< references to entities that stand in other files: left out
};

/// The document with the texts of its internal entities in place of their names (XML 1.0, 4.4); nothing where it declares
/// none. Names without a declaration stay. Throws std::invalid_argument where entities contain themselves, or where a
/// small document would become a large one.
std::optional<ExpandedDocument> expand_entities(std::string_view xml);

}  // namespace ligne::svg
