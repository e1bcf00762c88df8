#include "plotting/svg/shapes.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "areas/work_limit_error.hpp"

namespace ligne::svg {
namespace {

/// The radii of a rectangle's corners or of an ellipse. A radius that is missing, "auto" or negative equals the other
/// one (SVG 2, 7.4).
std::pair<double, double> radii(const pugi::xml_node& node, const Attributes& attributes) {
  const double rx = attributes.x(node, "rx"), ry = attributes.y(node, "ry");
  const bool has_rx = Attributes::has(node, "rx") && rx >= 0, has_ry = Attributes::has(node, "ry") && ry >= 0;
  return {has_rx ? rx : std::max(ry, 0.0), has_ry ? ry : std::max(rx, 0.0)};
}

void outline_rect(const pugi::xml_node& node, const Attributes& attributes, Outline& outline) {
  const double x = attributes.x(node, "x"), y = attributes.y(node, "y");
  const double w = attributes.x(node, "width"), h = attributes.y(node, "height");
  if (!(w > 0 && h > 0)) return;
  const std::pair<double, double> wanted = radii(node, attributes);
  const double rx = std::clamp(wanted.first, 0.0, w / 2), ry = std::clamp(wanted.second, 0.0, h / 2);
  if (rx == 0 || ry == 0) {
    outline.move_to({x, y});
    for (const Point2 p : {Point2{x + w, y}, {x + w, y + h}, {x, y + h}}) outline.line_to(p);
  } else {
    outline.move_to({x + rx, y});
    const auto corner = [&](Point2 from, Point2 to) {
      if (outline.at() != from) outline.line_to(from);
      outline.arc_to(rx, ry, 0, false, true, to);
    };
    corner({x + w - rx, y}, {x + w, y + ry});
    corner({x + w, y + h - ry}, {x + w - rx, y + h});
    corner({x + rx, y + h}, {x, y + h - ry});
    corner({x, y + ry}, {x + rx, y});
  }
  outline.close();
}

/// Adds pairs of coordinates, up to the first error (SVG 1.1, 9.6).
void outline_points(const pugi::xml_node& node, const Attributes& attributes, Outline& outline) {
  Scanner scanner(node.attribute("points").value());
  bool first = true;
  try {
    while (!scanner.done()) {
      const double x = scanner.number();
      scanner.skip_separator();
      if (scanner.done()) throw std::invalid_argument("points: an odd number of numbers");
      const Point2 p{x, scanner.number()};
      scanner.skip_separator();
      first ? outline.move_to(p) : outline.line_to(p);
      first = false;
    }
  } catch (const CoordinateRangeError&) {
    throw;
  } catch (const WorkLimitError&) {
    throw;
  } catch (const std::invalid_argument& e) {
    attributes.diagnostics().cut_short(node, e.what());
  }
}

}  // namespace

bool Attributes::has(const pugi::xml_node& node, const char* name) {
  const pugi::xml_attribute attribute = node.attribute(name);
  return attribute && trimmed(attribute.value()) != "auto";
}

double Attributes::length(const pugi::xml_node& node, const char* name, double whole, double otherwise) const {
  if (!has(node, name)) return otherwise;
  try {
    return length_px(node.attribute(name).value(), port_, whole);
  } catch (const std::invalid_argument& e) {
    diagnostics_.bad_value(name, node, e.what());
    return otherwise;
  }
}

std::optional<std::array<double, 4>> Attributes::view_box(const pugi::xml_node& node) const {
  const pugi::xml_attribute given = node.attribute("viewBox");
  if (!given || std::string_view(given.value()) == "none") return {};
  try {
    const std::vector<double> box = numbers(given.value());
    if (box.size() == 4 && box[2] > 0 && box[3] > 0) return std::array{box[0], box[1], box[2], box[3]};
    throw std::invalid_argument("is not x y width height");
  } catch (const std::invalid_argument& e) {
    diagnostics_.bad_value("viewBox", node, e.what());
    return {};
  }
}

Matrix view_box_to(const pugi::xml_node& node, const Attributes& attributes, double width, double height, Viewport& inside) {
  inside.width = width;
  inside.height = height;
  const std::optional<std::array<double, 4>> view_box = attributes.view_box(node);
  if (!view_box) return {};
  const std::array<double, 4>& box = *view_box;
  inside.width = box[2];
  inside.height = box[3];
  double sx = width / box[2], sy = height / box[3], dx = 0, dy = 0;
  const std::string aspect = node.attribute("preserveAspectRatio").value();
  if (!aspect.starts_with("none")) {
    sx = sy = aspect.find("slice") != std::string::npos ? std::max(sx, sy) : std::min(sx, sy);
    const auto share = [&](const char* low, const char* high) {
      return aspect.find(low) != std::string::npos ? 0.0 : aspect.find(high) != std::string::npos ? 1.0 : 0.5;
    };
    dx = (width - sx * box[2]) * share("xMin", "xMax");
    dy = (height - sy * box[3]) * share("YMin", "YMax");
  }
  return {sx, 0, 0, sy, dx - sx * box[0], dy - sy * box[1]};
}

bool outline_shape(std::string_view name, const pugi::xml_node& node, const Attributes& attributes, Outline& outline) {
  if (name == "path") {
    if (const std::string cause = add_path(outline, node.attribute("d").value()); !cause.empty())
      attributes.diagnostics().cut_short(node, cause);
  } else if (name == "line") {
    outline.move_to({attributes.x(node, "x1"), attributes.y(node, "y1")});
    outline.line_to({attributes.x(node, "x2"), attributes.y(node, "y2")});
  } else if (name == "polyline" || name == "polygon") {
    outline_points(node, attributes, outline);
    if (name == "polygon") outline.close();
  } else if (name == "rect") {
    outline_rect(node, attributes, outline);
  } else if (name == "circle" || name == "ellipse") {
    const Point2 center{attributes.x(node, "cx"), attributes.y(node, "cy")};
    const auto [rx, ry] =
        name == "circle" ? std::pair(attributes.along(node, "r"), attributes.along(node, "r")) : radii(node, attributes);
    if (rx > 0 && ry > 0) {
      outline.ellipse(center, rx, ry);
    }
  } else {
    return false;
  }
  outline.end();
  return true;
}

}  // namespace ligne::svg
