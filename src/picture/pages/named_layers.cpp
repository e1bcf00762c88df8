#include "picture/pages/named_layers.hpp"

#include <algorithm>
#include <iterator>
#include <string_view>

#include "files/message_text.hpp"
#include "picture/errors.hpp"

namespace ligne {
namespace {

/// Whether a drawing of this program may have such a layer. A pen for it is then allowed, even if the layer is empty.
bool is_layer_of_ours(const std::string& name) {
  for (std::size_t l = 0; l < kStrokeLayerCount; ++l) {
    if (stroke_layer_name(l) == name) return true;
  }
  constexpr std::string_view others[] = {"underside", "contour-base", "contour-index", "shore",  "water", "text",
                                         "debug",     "hatch",        "frame",         "legend", "points"};
  return std::find(std::begin(others), std::end(others), name) != std::end(others);
}

/// Names for a message, separated by commas; a long list is cut off.
std::string listed_names(const std::set<std::string>& names) {
  constexpr std::size_t kMostListed = 20;
  std::string text;
  std::size_t n = 0;
  for (const std::string& name : names) {
    if (n++ == kMostListed) return text + " and " + std::to_string(names.size() - kMostListed) + " more";
    text += (text.empty() ? "" : ", ") + printable(name);
  }
  return text;
}

/// `map` has an entry for each layer that an option names.
template <typename Map>
std::string absent_layers(const Map& map, const Drawing& drawing, std::string_view option) {
  const std::set<std::string> present = layer_names(drawing);
  std::set<std::string> absent;
  for (const auto& [layer, value] : map) {
    if (!present.contains(layer)) absent.insert(layer);
  }
  if (absent.empty() || present.empty()) return {};
  return "has no layer " + listed_names(absent) + " for " + std::string(option) + "; there are " + listed_names(present);
}

}  // namespace

std::set<std::string> layer_names(const Drawing& drawing) {
  std::set<std::string> names;
  for (const Layer& layer : drawing.layers) names.insert(layer.name);
  return names;
}

void check_pens(const PenTable& pens, const Drawing& drawing) {
  if (drawing.layers.empty()) return;
  const std::set<std::string> layers = layer_names(drawing);
  for (const auto& [layer, number] : pens.pen_of_layer) {
    if (layers.contains(layer) || is_layer_of_ours(layer)) continue;
    throw RequestError("pen", "there is no layer " + shown(layer, '"') + "; there are " + listed_names(layers) +
                                  "; and object:NAME, material:NAME, shade:N, rest");
  }
  // For a scene, require_parts() checked its materials and objects before; hidden ones are not errors.
  const bool has_materials = std::ranges::any_of(drawing.layers, [](const Layer& l) { return !l.material.empty(); });
  for (const auto& [material, number] : pens.pen_of_material) {
    if (!has_materials)
      throw RequestError("pen", "the drawing has no materials, so there is no material " + shown(material, '"'));
  }
  const bool has_objects = std::ranges::any_of(drawing.layers, [](const Layer& l) { return !l.object.empty(); });
  for (const auto& [object, number] : pens.pen_of_object) {
    if (!has_objects) throw RequestError("pen", "the drawing has no objects, so there is no object " + shown(object, '"'));
  }
}

std::string absent_pen_layers(const PenTable& pens, const Drawing& drawing) {
  return absent_layers(pens.pen_of_layer, drawing, "--pen");
}

std::string absent_width_layers(const LineWidths& widths_mm, const Drawing& drawing) {
  return absent_layers(widths_mm, drawing, "--width");
}

}  // namespace ligne
