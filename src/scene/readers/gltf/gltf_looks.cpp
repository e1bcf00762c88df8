#include "scene/readers/gltf/gltf_looks.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "scene/readers/gltf/gltf_extensions.hpp"

namespace ligne {
namespace {

/// Smallest opacity of materials with transmission: even if it transmits all light, its lines belong to an object.
constexpr double kTransmissionOpacity = 0.1;

}  // namespace

Material scene_material(const tinygltf::Material& from) {
  Material material;
  material.name = from.name;
  const std::vector<double>& c = from.pbrMetallicRoughness.baseColorFactor;
  material.color = glm::clamp(Point3(c[0], c[1], c[2]), 0.0, 1.0);
  // Only BLEND makes a face transparent: OPAQUE ignores the alpha value, MASK compares it (section 3.9.4).
  if (from.alphaMode == "BLEND") material.opacity = std::clamp(c[3], 0.0, 1.0);
  if (const auto transmission = from.extensions.find(kTransmissionExtension); transmission != from.extensions.end()) {
    const double through = transmission->second.Get("transmissionFactor").GetNumberAsDouble();
    material.opacity = std::min(material.opacity, std::max(1 - through, kTransmissionOpacity));
  }
  return material;
}

std::optional<SceneCamera> scene_camera(const tinygltf::Model& model, const GltfCamera& from, std::size_t number) {
  const tinygltf::Camera& camera = model.cameras[from.camera];
  const tinygltf::Node& node = model.nodes[from.node];
  const auto axis = [&](int k) { return Point3(from.to_world[k][0], from.to_world[k][1], from.to_world[k][2]); };
  SceneCamera to;
  to.name = !node.name.empty() ? node.name : camera.name;
  if (to.name.empty()) to.name = std::to_string(number);
  to.eye = axis(3);
  to.forward = -axis(2);
  to.up = axis(1);
  to.perspective = camera.type != "orthographic";
  if (to.perspective) {
    to.fov_degrees = camera.perspective.yfov * 180 / std::numbers::pi;
    if (camera.perspective.aspectRatio > 0) to.aspect = camera.perspective.aspectRatio;
  }
  const double size = glm::length(to.eye) + glm::length(to.forward) + glm::length(*to.up);
  const bool looks = std::isfinite(size) && glm::length(glm::cross(to.forward, *to.up)) > 0;
  if (!looks || !(to.fov_degrees > 0 && to.fov_degrees < 180)) return std::nullopt;
  return to;
}

}  // namespace ligne
