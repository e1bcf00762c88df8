/// Geometry that CSS gives: the properties of SVG 2, 7, which are attributes as well.

#include <stdexcept>

#include "plotting/svg/reader.hpp"

namespace ligne::svg {
namespace {

struct GeometryProperty {
  std::string_view name;
  std::string_view elements;  ///< elements to which it applies, each between blanks
};

constexpr std::string_view kFrames = " svg rect image foreignObject use ";
constexpr GeometryProperty kGeometry[] = {{"cx", " circle ellipse "},
                                          {"cy", " circle ellipse "},
                                          {"r", " circle "},
                                          {"rx", " ellipse rect "},
                                          {"ry", " ellipse rect "},
                                          {"x", kFrames},
                                          {"y", kFrames},
                                          {"width", kFrames},
                                          {"height", kFrames},
                                          {"d", " path "}};

const GeometryProperty* geometry_property(std::string_view name) {
  for (const GeometryProperty& property : kGeometry) {
    if (property.name == name) return &property;
  }
  return nullptr;
}

/// The data in "path('M0 0')", with or without a fill rule; nothing in "none".
std::string_view path_in(std::string_view value) {
  if (value == "none") return {};
  const std::size_t open = value.find_first_of("'\""), close = value.find_last_of("'\"");
  if (!value.starts_with("path(") || !value.ends_with(")") || open == close) fail_value(value, "is not a path");
  return value.substr(open + 1, close - open - 1);
}

}  // namespace

bool depends_on_window(std::string_view length) {
  // Words such as "auto" and "fit-content", and units from vw to dvh.
  return length.find_first_of("%vV") != length.npos || length.find_first_of("0123456789") == length.npos;
}

/// Writes a property to the attribute that it overrides. An invalid one is reported and ignored.
void SvgReader::apply_geometry(pugi::xml_node node, const Declaration& declaration) {
  const GeometryProperty* property = geometry_property(declaration.name);
  const std::string element = " " + std::string(local_name(node)) + " ";
  if (!property || property->elements.find(element) == std::string_view::npos) return;
  try {
    const bool is_path = declaration.name == "d";
    const std::string value(is_path ? path_in(trimmed(declaration.value)) : trimmed(declaration.value));
    const bool is_root = node.parent().type() == pugi::node_document;
    if (is_root && depends_on_window(value)) return;
    if (!is_path && value != "auto" && length_px(value, Viewport{}, 1) != 0 && value.back() <= '9' && value.back() != '%')
      fail_value(value, "has no unit, which CSS requires");
    pugi::xml_attribute attribute = node.attribute(declaration.name.c_str());
    if (!attribute) attribute = node.append_attribute(declaration.name.c_str());
    attribute.set_value(value.c_str());
  } catch (const std::invalid_argument& e) {
    diagnostics_.bad_value(declaration.name, node, e.what());
  }
}

/// Applies the geometry in style attributes and style sheets to all elements. survey() must have read the sheets.
void SvgReader::apply_geometry_properties(const pugi::xml_node& root) {
  const bool in_sheet = std::ranges::any_of(kGeometry, [&](const GeometryProperty& p) { return sheet_.sets(p.name); });
  for_each_element(root, [&](const pugi::xml_node& node) {
    std::vector<Declaration> own;
    if (const pugi::xml_attribute attribute = node.attribute("style")) own = declarations(attribute.value());
    const std::vector<const Declaration*> rules = in_sheet ? sheet_.of(node) : std::vector<const Declaration*>();
    for (const bool important : {false, true}) {
      for (const Declaration* rule : rules) {
        if (rule->important == important) apply_geometry(node, *rule);
      }
      for (const Declaration& declaration : own) {
        if (declaration.important == important) apply_geometry(node, declaration);
      }
    }
  });
}

}  // namespace ligne::svg
