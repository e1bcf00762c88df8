#pragma once
/// Expands internal entities of an XML document, which the parser does not. Private to plotting.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace ligne::svg {

struct ExpandedDocument {
  std::string text;          ///< has as many lines as the document
  std::size_t external = 0;  ///< references to entities of other files, which are left out
};

/// The document with the texts of its internal entities in place of their names (XML 1.0, 4.4); nothing if it declares
/// none. Names without a declaration stay. Throws std::invalid_argument if entities contain themselves, or if a small
/// document would become a large one.
std::optional<ExpandedDocument> expand_entities(std::string_view xml);

}  // namespace ligne::svg
