/// Draws markers at the vertices of paths.

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "plotting/svg/reader.hpp"

namespace ligne::svg {
namespace {

/// Width and height of a marker that gives none.
constexpr double kUsualSide = 3;

Point2 unit(Point2 v) {
  const double length = glm::length(v);
  return length > 0 ? v / length : Point2{0, 0};
}

/// Direction at a vertex, radians: halfway between the directions on both sides.
double angle_at(const PathVertex& vertex) {
  const Point2 in = unit(vertex.in), out = unit(vertex.out);
  // At a turning point the direction is across; SVG leaves open to which side.
  const Point2 way = in + out == Point2{0, 0} ? Point2{-in.y, in.x} : in + out;
  return std::atan2(way.y, way.x);
}

Matrix rotation(double radians) {
  const double c = std::cos(radians), s = std::sin(radians);
  return {c, s, -s, c, 0, 0};
}

}  // namespace

void SvgReader::draw_markers(const pugi::xml_node& node, const std::vector<PathVertex>& vertices, const Context& context) {
  if (vertices.empty()) return;
  if (skip_.contains("marker")) return refuse("marker", node);
  const auto draw = [&](std::size_t kind, const PathVertex& vertex) {
    const auto found = ids_.find(context.style.markers[kind]);
    if (found == ids_.end() || local_name(found->second) != "marker") return;
    draw_marker(found->second, node, vertex, kind == 0, context);
  };
  draw(0, vertices.front());
  for (std::size_t i = 1; i + 1 < vertices.size(); ++i) draw(1, vertices[i]);
  draw(2, vertices.back());
}

/// Draws a marker. It inherits the style of the place where it is defined, not of the shape that it marks.
void SvgReader::draw_marker(const pugi::xml_node& marker, const pugi::xml_node& node, const PathVertex& vertex, bool start,
                            const Context& around) {
  if (!marker.first_child()) return;
  if (around.links >= kMostLinks || open_.contains(marker.internal_object())) {
    return omit("self-referring markers", node,
                "has markers that lead on more than " + std::to_string(kMostLinks) + " times, or back to themselves");
  }
  Context context = around;
  ++context.depth;
  ++context.links;
  bool displayed = true;
  context.style = style_around(marker, context.port);
  context.style.context_fill = around.style.fill;
  context.style.context_stroke = around.style.stroke;
  context.style = styled(marker, context.style, context.port, displayed);  // display has no effect on markers
  context.port.em = context.style.font_size;
  const double width = attributes(context).x(marker, "markerWidth", kUsualSide),
               height = attributes(context).y(marker, "markerHeight", kUsualSide);
  if (!(width > 0 && height > 0)) return;
  const std::string_view orient = marker.attribute("orient").value();
  double angle = 0;
  if (orient.starts_with("auto")) {
    angle = angle_at(vertex) + (start && orient == "auto-start-reverse" ? std::numbers::pi : 0);
  } else {
    angle = angle_degrees(orient).value_or(0) * std::numbers::pi / 180;
  }
  const bool own_units = std::string_view(marker.attribute("markerUnits").value()) == "userSpaceOnUse";
  const double scale = own_units ? 1 : around.style.stroke_width;
  const Matrix inside = view_box_to(marker, attributes(around), width, height, context.port);
  const Point2 reference = inside({attributes(around).x(marker, "refX"), attributes(around).y(marker, "refY")});
  context.to_mm = around.to_mm * Matrix{1, 0, 0, 1, vertex.at.x, vertex.at.y} * rotation(angle) *
                  Matrix{scale, 0, 0, scale, 0, 0} * Matrix{1, 0, 0, 1, -reference.x, -reference.y};
  if (!context.style.overflow.value_or(false)) context.clip = frame_clip(width, height, context);
  context.to_mm = context.to_mm * inside;
  walk_children(marker, context);
}

}  // namespace ligne::svg
