#pragma once
/// Work that the XML parser leaves: internal entities, and names independent of a file's prefixes. Private to plotting.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include <pugixml.hpp>

namespace ligne::svg {

struct ExpandedDocument {
  std::string text;          ///< has as many lines as the document
  std::size_t external = 0;  ///< references to entities of other files, which are left out
};

/// The document with the texts of its internal entities in place of their names (XML 1.0, 4.4); nothing if it declares
/// none. Names without a declaration stay. Throws std::invalid_argument if entities contain themselves, or if a small
/// document would become a large one.
std::optional<ExpandedDocument> expand_entities(std::string_view xml);

/// Removes the prefixes of elements of SVG ("ns0:path" becomes "path"), gives one to elements of other namespaces, and
/// renames attributes of XLink and Inkscape to "xlink:href" and "inkscape:label". The namespace of the root counts as
/// SVG.
void use_plain_names(pugi::xml_node root);

/// The name of an element of SVG after use_plain_names(); empty for elements of other namespaces.
std::string_view local_name(const pugi::xml_node& node);

/// The id of the element of this document to which an element links; empty: none.
std::string_view link_of(const pugi::xml_node& node);

}  // namespace ligne::svg
