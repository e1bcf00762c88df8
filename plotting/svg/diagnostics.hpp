#pragma once
/// Diagnostics about parts of an SVG that can not be drawn. Private to plotting.

#include <functional>
#include <string>
#include <string_view>

#include <pugixml.hpp>

namespace ligne::svg {

struct Diagnostics {
  /// A part of SVG can not be drawn as strokes; `name` is its name in kSkippable (drawing_reader.hpp).
  std::function<void(std::string_view name, const pugi::xml_node& node)> refuse;
  /// The value of an attribute or a property is invalid; the attribute or property is ignored.
  std::function<void(std::string_view property, const pugi::xml_node& node, const std::string& cause)> bad_value;
  /// The data of a path or a list of points is wrong from some place on; the part before is drawn.
  std::function<void(const pugi::xml_node& node, const std::string& cause)> cut_short;
};

}  // namespace ligne::svg
