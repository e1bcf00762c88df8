#pragma once
/// Complaints about parts of an SVG that can not be drawn. Private to plotting.

#include <functional>
#include <string>
#include <string_view>

#include <pugixml.hpp>

namespace ligne::svg {

struct Complaints {
  /// Something of SVG that can not be drawn as strokes, by its name in drawing_reader.hpp.
  std::function<void(std::string_view name, const pugi::xml_node& node)> refuse;
  /// The value of an attribute or a property has no meaning: it is as if it were not there.
  std::function<void(std::string_view property, const pugi::xml_node& node, const std::string& cause)> bad_value;
  /// The data of a path or a list of points is wrong from some place on: what stands before is drawn.
  std::function<void(const pugi::xml_node& node, const std::string& cause)> cut_short;
};

}  // namespace ligne::svg
