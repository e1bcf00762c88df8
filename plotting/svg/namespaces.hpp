#pragma once
/// Names of XML elements whatever prefixes a file gives them. Private to plotting.

#include <string_view>

#include <pugixml.hpp>

namespace ligne::svg {

/// Names the elements of SVG without a prefix ("ns0:path" becomes "path"), those of other namespaces with one, and the
/// attributes of XLink and Inkscape as "xlink:href" and "inkscape:label". What the root belongs to counts as SVG.
void use_plain_names(pugi::xml_node root);

/// The name of an element of SVG after use_plain_names(); empty for elements of other namespaces.
std::string_view local_name(const pugi::xml_node& node);

}  // namespace ligne::svg
