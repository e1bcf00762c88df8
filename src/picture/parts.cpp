#include "picture/parts.hpp"

#include <algorithm>
#include <cstdint>
#include <map>
#include <tuple>
#include <utility>

#include "scene/clean/named_objects.hpp"

namespace ligne {
namespace {

bool groups_objects(const PictureRequest& request) {
  return request.output.group_objects && request.output.format == OutputFormat::svg && !request.plotter.by_pens();
}

/// What is told apart.
struct Part {
  std::string material;
  std::uint32_t object = kNone;
  std::size_t color = 0;  ///< number of the colour from 1 on, 0: none of its own

  bool operator<(const Part& o) const { return std::tie(material, object, color) < std::tie(o.material, o.object, o.color); }
};

/// Which of the colours the object has, from 1 on; 0: none.
std::size_t color_of(const std::vector<ObjectColor>& colors, const std::string& name) {
  for (std::size_t i = colors.size(); i > 0; --i) {
    if (name_fits(colors[i - 1].pattern, name)) return i;
  }
  return 0;
}

std::size_t painting_order(const std::string& layer) {
  std::size_t order = 0;
  while (order < kStrokeLayerCount && stroke_layer_name(order) != layer) ++order;
  return order;
}

}  // namespace

bool tells_parts(const PictureRequest& request) {
  return groups_objects(request) || !request.output.colors.empty() || !request.plotter.pens.pen_of_material.empty() ||
         !request.plotter.pens.pen_of_object.empty();
}

std::vector<std::string> object_names(const Scene& scene) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) names.push_back(object_name(scene.objects[i], i));
  return names;
}

Drawing drawing_by_parts(const SceneStudy& study, const Scene& scene, const PictureRequest& request) {
  const bool by_material = !request.plotter.pens.pen_of_material.empty();
  const bool by_object = groups_objects(request) || !request.plotter.pens.pen_of_object.empty();
  const std::vector<std::string> names = object_names(scene);
  std::vector<std::size_t> colors;
  colors.reserve(names.size());
  for (const std::string& name : names) colors.push_back(color_of(request.output.colors, name));
  const ObjectOfFace object_of(scene);
  const StrokeModel& strokes = *study.result.strokes;
  std::map<Part, StrokeModel> parts;
  for (const Stroke& stroke : strokes.strokes) {
    Part part;
    if (stroke.line_class != LineClass::axes) {
      const std::uint32_t face = study.source(scene, stroke.source).faces[0];
      const std::uint32_t material = face < scene.face_material.size() ? scene.face_material[face] : 0;
      if (by_material && material < scene.materials.size()) part.material = scene.materials[material].name;
      const std::uint32_t object = object_of(face);
      if (by_object) part.object = object;
      if (object < colors.size()) part.color = colors[object];
    }
    StrokeModel& model = parts[part];
    model.lattice = strokes.lattice;
    model.strokes.push_back(stroke);
  }
  Drawing drawing;
  for (const auto& [part, model] : parts) {
    for (Layer& layer : make_drawing(model).layers) {
      layer.material = part.material;
      if (part.object < names.size()) layer.object = names[part.object];
      if (part.color > 0) layer.color = request.output.colors[part.color - 1].color;
      drawing.layers.push_back(std::move(layer));
    }
  }
  if (by_object || !request.output.colors.empty()) {
    std::stable_sort(drawing.layers.begin(), drawing.layers.end(),
                     [](const Layer& a, const Layer& b) { return painting_order(a.name) < painting_order(b.name); });
  }
  return drawing;
}

}  // namespace ligne
