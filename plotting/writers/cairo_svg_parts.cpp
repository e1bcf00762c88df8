#include "plotting/writers/cairo_svg_parts.hpp"

#include <algorithm>
#include <initializer_list>
#include <map>
#include <stdexcept>

#include <pugixml.hpp>

#include "base/portable.hpp"
#include "plotting/writers/number_text.hpp"

namespace ligne {
namespace {

[[noreturn]] void fail(std::string_view what) {
  constexpr std::size_t kShown = 60;
  throw std::runtime_error("cairo: an SVG of unexpected form: " + std::string(what.substr(0, kShown)));
}

using Attributes = std::map<std::string_view, std::string_view>;

/// The attributes of an element; an unknown one is an error. Cairo 1.16 puts the look of paths and rectangles into one
/// attribute, "style", with a semicolon behind each property.
Attributes attributes_of(const pugi::xml_node& node, std::initializer_list<std::string_view> known) {
  Attributes all;
  const auto add = [&](std::string_view name, std::string_view value) {
    if (std::ranges::find(known, name) == known.end()) fail(name);
    all[name] = value;
  };
  for (const pugi::xml_attribute& attribute : node.attributes()) {
    std::string_view name = attribute.name(), rest = attribute.value();
    if (name != "style") add(name, rest);
    for (std::size_t end; name == "style" && (end = rest.find(';')) != rest.npos; rest.remove_prefix(end + 1)) {
      const std::size_t colon = std::min(rest.find(':'), end - 1);
      add(svg::trimmed(rest.substr(0, colon)), rest.substr(colon + 1, end - colon - 1));
    }
  }
  return all;
}

double number(Attributes& attributes, std::string_view name, double otherwise = 0) {
  return attributes.contains(name) ? svg::Scanner(attributes[name]).number() : otherwise;
}

/// "rgb(50%, 25%, 0%)", or nothing for "none"; a pattern is unknown.
std::optional<std::string> color(std::string_view text) {
  if (text.empty() || text == "none") return {};
  if (!text.starts_with("rgb(") || !text.ends_with("%)")) fail(text);
  return svg::paint(text);
}

/// The width and the ends of a stroke are not read: the caller set them.
CairoSvgPart path_of(const pugi::xml_node& node) {
  Attributes a =
      attributes_of(node, {"d", "transform", "fill", "fill-rule", "fill-opacity", "stroke", "stroke-width", "stroke-opacity",
                           "stroke-linecap", "stroke-linejoin", "stroke-miterlimit", "stroke-dasharray"});
  CairoSvgPart part{svg::transform(a["transform"]), a["d"], color(a["fill"]), color(a["stroke"])};
  part.fill_opacity = number(a, "fill-opacity", 1);
  if (part.fill && a["fill-rule"] != "evenodd") fail(a["fill-rule"]);
  return part;
}

CairoSvgPart image_of(const pugi::xml_node& node, const pugi::xml_node& definitions) {
  Attributes use = attributes_of(node, {"xlink:href", "transform"});
  const std::string id(use["xlink:href"].substr(use["xlink:href"].starts_with('#')));
  Attributes a = attributes_of(definitions.find_child_by_attribute("image", "id", id.c_str()),
                               {"id", "x", "y", "width", "height", "xlink:href"});
  CairoSvgPart part{svg::transform(use["transform"])};
  part.image = a["xlink:href"];
  part.pixels = {number(a, "width"), number(a, "height")};
  if (part.image.empty() || number(a, "x") != 0 || number(a, "y") != 0 || part.to_document.b != 0) fail("image " + id);
  return part;
}

void add_parts(const pugi::xml_node& group, const pugi::xml_node& definitions, std::vector<CairoSvgPart>& parts) {
  for (const pugi::xml_node& node : group.children()) {
    const std::string_view name = node.name();
    if (name == "path") {
      parts.push_back(path_of(node));
    } else if (name == "use") {
      parts.push_back(image_of(node, definitions));
    } else if (name == "g") {
      attributes_of(node, {"id"});
      add_parts(node, definitions, parts);
    } else if (name != "defs") {
      // Definitions draw nothing by themselves. References to them are unknown attributes here, except references to
      // images.
      fail(name);
    }
  }
}

/// Reads a number as Cairo prints it: an optional sign, digits, optional decimals.
double printed_number(const char*& text, const char* end) {
  constexpr std::ptrdiff_t kExactDigits = 15;  // integers and powers of ten with up to 15 digits are exact as doubles
  const char *const start = text, *point = nullptr;
  if (text != end && *text == '-') ++text;
  const char* const first = text;
  std::int64_t digits = 0;
  for (; text != end && text - first <= kExactDigits; ++text) {
    if (*text >= '0' && *text <= '9') {
      digits = 10 * digits + (*text - '0');
    } else if (*text == '.' && !point) {
      point = text;
    } else {
      break;
    }
  }
  if (text - first == (point ? 1 : 0) || text - first > kExactDigits) {  // no number, or a long one
    double value = 0;
    const auto [rest, error] = from_chars(start, end, value);
    if (error != std::errc{}) fail({start, end});
    text = rest;
    return value;
  }
  const double value = static_cast<double>(digits) / static_cast<double>(power_of_ten(point ? text - point - 1 : 0));
  return first == start ? value : -value;
}

}  // namespace

std::vector<CairoSvgPart> cairo_svg_parts(std::string& document, double size) try {
  pugi::xml_document xml;
  if (!xml.load_buffer_inplace(document.data(), document.size(), pugi::parse_minimal)) fail("it is not XML");
  const pugi::xml_node root = xml.child("svg");
  // Lengths are in units of the viewBox, whatever the unit of the width.
  if (svg::numbers(root.attribute("viewBox").value()) != std::vector<double>{0, 0, size, size}) fail("its viewBox");
  std::vector<CairoSvgPart> parts;
  add_parts(root, root.child("defs"), parts);
  return parts;
} catch (const std::invalid_argument& e) {
  fail(e.what());
}

void for_each_command(const CairoSvgPart& part, FunctionRef<void(char, const Point2*)> take) {
  const char *text = part.data.data(), *const end = text + part.data.size();
  const auto skip_blanks = [&] {
    while (text != end && *text == ' ') ++text;
  };
  const auto coordinate = [&] {
    skip_blanks();
    return printed_number(text, end);
  };
  char before = 'Z';
  for (skip_blanks(); text != end; skip_blanks()) {
    const char command = *text++;
    const int count = command == 'M' || command == 'L' ? 1 : command == 'C' ? 3 : command == 'Z' ? 0 : -1;
    if (count < 0 || (before == 'Z' && command != 'M')) fail({text - 1, end});
    before = command;
    Point2 points[3];
    for (int i = 0; i < count; ++i) {
      const double x = coordinate();
      points[i] = part.to_document({x, coordinate()});
    }
    take(command, points);
  }
}

}  // namespace ligne
