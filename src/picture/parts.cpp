#include "picture/parts.hpp"

#include <algorithm>
#include <cstdint>
#include <map>
#include <tuple>
#include <utility>

#include "base/no_index.hpp"
#include "picture/line_groups.hpp"
#include "scene/clean/named_objects.hpp"

namespace ligne {
namespace {

bool groups_objects(const PictureRequest& request) {
  return request.output.group_objects && request.output.format == OutputFormat::svg && !request.plotter.by_pens();
}

/// Key by which lines are divided into layers.
struct Part {
  std::string material;
  std::uint32_t object = kNone;
  std::size_t color = 0;    ///< number of the colour, from 1; 0: no colour of its own
  std::uint32_t group = 0;  ///< index into LineGroups::groups

  bool operator<(const Part& o) const {
    return std::tie(material, object, color, group) < std::tie(o.material, o.object, o.color, o.group);
  }
};

/// Returns the number of the object's colour, from 1; 0: none.
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

/// A layer with its place in the painting order. Layers of one class are ordered by their group names.
struct OrderedLayer {
  std::size_t order;
  std::string group;
  Layer layer;
};

/// Applies the style of a group to a layer, except to hidden lines. Returns the layer name of the group, or an empty
/// one.
std::string dress(Layer& layer, const LineGroup& group) {
  if (layer.name == stroke_layer_name(0)) return {};
  if (!group.layer.empty()) layer.name = group.layer;
  if (!group.object.empty()) layer.object = group.object;
  if (group.color) layer.color = group.color;
  if (group.width_mm) layer.width_mm = group.width_mm;
  layer.height = group.height;
  return group.layer;
}

}  // namespace

bool has_parts(const PictureRequest& request) {
  return request.groups || groups_objects(request) || !request.output.colors.empty() ||
         !request.plotter.pens.pen_of_material.empty() || !request.plotter.pens.pen_of_object.empty();
}

std::vector<std::string> object_names(const Scene& scene) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) names.push_back(object_name(scene.objects[i], i));
  return names;
}

Drawing drawing_by_parts(const SceneVisibility& study, const Scene& scene, const PictureRequest& request) {
  const bool by_material = !request.plotter.pens.pen_of_material.empty();
  const bool by_object = groups_objects(request) || !request.plotter.pens.pen_of_object.empty();
  const std::vector<std::string> names = object_names(scene);
  std::vector<std::size_t> colors;
  colors.reserve(names.size());
  for (const std::string& name : names) colors.push_back(color_of(request.output.colors, name));
  const ObjectOfFace object_of(scene);
  const StrokeModel& strokes = *study.result.strokes;
  std::map<Part, StrokeModel> parts;
  const std::size_t edges = study.edges.size(), lines = request.groups ? request.groups->lines.size() : 0;
  for (const Stroke& stroke : strokes.strokes) {
    Part part;
    if (stroke.source >= edges && stroke.source - edges < lines) {
      part.group = request.groups->lines[stroke.source - edges].group;
    } else if (stroke.line_class != LineClass::axes) {
      const SourceEdge source = study.source(scene, stroke.source);
      if (request.groups && request.groups->group_of) part.group = request.groups->group_of(source, stroke.line_class);
      const std::uint32_t face = source.faces[0];
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
  std::vector<OrderedLayer> layers;
  for (const auto& [part, model] : parts) {
    for (Layer& layer : make_drawing(model).layers) {
      layer.material = part.material;
      if (part.object < names.size()) layer.object = names[part.object];
      if (part.color > 0) layer.color = request.output.colors[part.color - 1].color;
      const std::size_t order = painting_order(layer.name);
      const std::string group = request.groups ? dress(layer, request.groups->groups[part.group]) : std::string();
      layers.push_back({order, group, std::move(layer)});
    }
  }
  if (by_object || request.groups || !request.output.colors.empty()) {
    std::stable_sort(layers.begin(), layers.end(), [](const OrderedLayer& a, const OrderedLayer& b) {
      return std::tie(a.order, a.group) < std::tie(b.order, b.group);
    });
  }
  Drawing drawing;
  for (OrderedLayer& layer : layers) drawing.layers.push_back(std::move(layer.layer));
  return drawing;
}

}  // namespace ligne
