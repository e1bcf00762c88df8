#include "check.hpp"

#include <nlohmann/json.hpp>

namespace ligne::check {

namespace {

using Json = nlohmann::json;

constexpr std::pair<LineKind, std::string_view> kNames[] = {
    {kOutline, "outline"}, {kBorder, "border"}, {kIntersection, "intersection"}, {kCrease, "crease"}, {kMesh, "mesh"}};

Point2 point2(const Json& j) { return {j.at(0).get<double>(), j.at(1).get<double>()}; }
Point3 point3(const Json& j) { return {j.at(0).get<double>(), j.at(1).get<double>(), j.at(2).get<double>()}; }

DrawnStroke read_stroke(const Json& j) {
  DrawnStroke stroke;
  stroke.kind = kind_of(j.at("class").get_ref<const std::string&>());
  stroke.visible = j.at("visible").get<bool>();
  const Json& source = j.at("source");
  if (!source.at("edge").is_null()) stroke.edge = source.at("edge").get<std::uint32_t>();
  const Json& points = j.at("points");
  for (std::size_t k = 0; k < 2; ++k) {
    stroke.ends[k] = point3(source.at("ends").at(k));
    stroke.interval[k] = j.at("interval").at(k).get<double>();
    if (!source.at("faces").at(k).is_null()) stroke.faces[k] = source.at("faces").at(k).get<std::uint32_t>();
  }
  stroke.points = {point2(points.front()), point2(points.back())};
  return stroke;
}

DrawingFile from_json(const Json& j) {
  if (j.at("format") != "ligne-drawing" || j.at("version") != 2)
    throw std::runtime_error("not a ligne-drawing of version 2");
  DrawingFile drawing;
  const Json& view = j.at("view");
  for (std::size_t i = 0; i < 16; ++i) drawing.model_to_page[i / 4][i % 4] = view.at("matrix").at(i).get<double>();
  const Json& w = view.at("window");
  drawing.window = {{w.at(0).get<double>(), w.at(1).get<double>()}, {w.at(2).get<double>(), w.at(3).get<double>()}};
  if (view.at("perspective").get<bool>()) drawing.near_distance = view.at("near").get<double>();
  for (const Json& stroke : j.at("strokes")) drawing.strokes.push_back(read_stroke(stroke));
  return drawing;
}

}  // namespace

LineKind kind_of(std::string_view name) {
  for (const auto& [kind, text] : kNames)
    if (text == name) return kind;
  throw std::runtime_error("no class of lines is called '" + std::string(name) + "'");
}

std::string_view name_of(LineKind kind) {
  for (const auto& [k, text] : kNames)
    if (k == kind) return text;
  return "";
}

DrawingFile parse_drawing(std::string_view text) {
  try {
    return from_json(Json::parse(text));
  } catch (const Json::exception& e) {
    throw std::runtime_error(e.what());
  }
}

}  // namespace ligne::check
