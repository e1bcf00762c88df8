#include "plotting/svg/shapes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace ligne::svg {
namespace {

void outline_rect(const pugi::xml_node& node, const Viewport& port, Outline& outline) {
  const double x = length(node, "x", 0, port.width), y = length(node, "y", 0, port.height);
  const double w = length(node, "width", 0, port.width), h = length(node, "height", 0, port.height);
  if (!(w > 0 && h > 0)) return;
  const bool has_rx = node.attribute("rx"), has_ry = node.attribute("ry");
  double rx = length(node, "rx"), ry = length(node, "ry");
  if (!has_rx) rx = ry;
  if (!has_ry) ry = rx;
  rx = std::clamp(rx, 0.0, w / 2);
  ry = std::clamp(ry, 0.0, h / 2);
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

}  // namespace

double length(const pugi::xml_node& node, const char* attribute, double otherwise, double whole) {
  const pugi::xml_attribute found = node.attribute(attribute);
  if (!found) return otherwise;
  try {
    return length_px(found.value(), whole > 0 ? std::optional(whole) : std::nullopt);
  } catch (const std::invalid_argument& e) {
    throw std::invalid_argument(std::string(attribute) + ": " + e.what());
  }
}

Matrix view_box_to(const pugi::xml_node& node, double width, double height, Viewport& inside) {
  inside = {width, height};
  const pugi::xml_attribute view_box = node.attribute("viewBox");
  if (!view_box) return {};
  const std::vector<double> box = numbers(view_box.value());
  if (box.size() != 4 || !(box[2] > 0 && box[3] > 0)) throw std::invalid_argument("viewBox is not x y width height");
  inside = {box[2], box[3]};
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

bool outline_shape(std::string_view name, const pugi::xml_node& node, const Viewport& port, Outline& outline) {
  if (name == "path") {
    add_path(outline, node.attribute("d").value());
  } else if (name == "line") {
    outline.move_to({length(node, "x1", 0, port.width), length(node, "y1", 0, port.height)});
    outline.line_to({length(node, "x2", 0, port.width), length(node, "y2", 0, port.height)});
  } else if (name == "polyline" || name == "polygon") {
    const std::vector<double> v = numbers(node.attribute("points").value());
    if (v.size() % 2 == 1) throw std::invalid_argument("points: an odd number of numbers");
    for (std::size_t i = 0; i + 1 < v.size(); i += 2)
      i == 0 ? outline.move_to({v[0], v[1]}) : outline.line_to({v[i], v[i + 1]});
    if (name == "polygon") outline.close();
  } else if (name == "rect") {
    outline_rect(node, port, outline);
  } else if (name == "circle" || name == "ellipse") {
    const Point2 center{length(node, "cx", 0, port.width), length(node, "cy", 0, port.height)};
    const double diagonal = std::hypot(port.width, port.height) / std::sqrt(2.0);
    const double rx = name == "circle" ? length(node, "r", 0, diagonal) : length(node, "rx", 0, port.width);
    const double ry = name == "circle" ? rx : length(node, "ry", 0, port.height);
    if (rx > 0 && ry > 0) {
      outline.move_to({center.x + rx, center.y});
      outline.arc(center, rx, ry, 0, 0, 2 * std::numbers::pi);
      outline.close();
    }
  } else {
    return false;
  }
  outline.end();
  return true;
}

}  // namespace ligne::svg
