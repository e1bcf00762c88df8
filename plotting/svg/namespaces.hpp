#pragma once
/// Names of XML elements, independent of a file's prefixes. Private to plotting.

#include <string_view>

#include <pugixml.hpp>

namespace ligne::svg {

/// Removes the prefixes of elements of SVG ("ns0:path" becomes "path"), gives one to elements of other namespaces, and
/// renames attributes of XLink and Inkscape to "xlink:href" and "inkscape:label". The namespace of the root counts as
/// SVG.
void use_plain_names(pugi::xml_node root);

/// The name of an element of SVG after use_plain_names(); empty for elements of other namespaces.
std::string_view local_name(const pugi::xml_node& node);

}  // namespace ligne::svg
