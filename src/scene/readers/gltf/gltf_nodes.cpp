#include "scene/readers/gltf/gltf_nodes.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <numbers>
#include <string>
#include <utility>

#include "base/no_index.hpp"
#include "scene/readers/gltf/gltf_accessor.hpp"
#include "scene/readers/gltf/gltf_extensions.hpp"

namespace ligne {
namespace {

std::string place_of(std::size_t node) { return "node " + std::to_string(node); }

/// Linear part of a quaternion (x, y, z, w), which is normalized first.
glm::dmat3 rotation_matrix(const std::vector<double>& q) {
  double x = q[0], y = q[1], z = q[2], w = q[3];
  const double length = std::sqrt(x * x + y * y + z * z + w * w);
  if (!(length > 0)) return glm::dmat3(1);
  x /= length, y /= length, z /= length, w /= length;
  return {{1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w)},
          {2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w)},
          {2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y)}};
}

glm::dmat4 local_matrix(const tinygltf::Node& node) {
  if (node.matrix.size() != 16) return matrix_of(node.translation, node.rotation, node.scale);
  glm::dmat4 m(1);
  for (int i = 0; i < 16; ++i) m[i / 4][i % 4] = node.matrix[static_cast<std::size_t>(i)];
  return m;
}

/// World matrices of all nodes, including those outside all scenes.
std::vector<glm::dmat4> world_matrices(const std::vector<tinygltf::Node>& nodes, const std::vector<std::uint32_t>& parent) {
  std::vector<glm::dmat4> to_world(nodes.size());
  std::vector<std::size_t> stack;
  for (std::size_t root = 0; root < nodes.size(); ++root) {
    if (parent[root] == kNone) stack.push_back(root);
    while (!stack.empty()) {
      const std::size_t n = stack.back();
      stack.pop_back();
      const glm::dmat4 local = local_matrix(nodes[n]);
      to_world[n] = parent[n] == kNone ? local : to_world[parent[n]] * local;
      for (const int child : nodes[n].children) stack.push_back(static_cast<std::size_t>(child));
    }
  }
  return to_world;
}

/// Parent of each node, kNone for roots. Checks that every node has at most one and none is its own ancestor.
std::vector<std::uint32_t> find_parents(const GltfDocument& document) {
  const std::vector<tinygltf::Node>& nodes = document.model.nodes;
  std::vector<std::uint32_t> parent(nodes.size(), kNone);
  for (std::uint32_t n = 0; n < nodes.size(); ++n) {
    for (const int child : nodes[n].children) {
      std::uint32_t& of_child = parent[static_cast<std::size_t>(child)];
      if (static_cast<std::uint32_t>(child) == n) document.fail(place_of(n), "is its own child");
      if (of_child != kNone) {
        document.fail(place_of(static_cast<std::size_t>(child)),
                      "is a child twice, of node " + std::to_string(of_child) + " and of node " + std::to_string(n));
      }
      of_child = n;
    }
  }
  // Climbs from each node to a node that is known to be below a root.
  std::vector<std::uint32_t> climbed_from(nodes.size(), kNone);
  for (std::uint32_t n = 0; n < nodes.size(); ++n) {
    for (std::uint32_t at = n; at != kNone && climbed_from[at] == kNone; at = parent[at]) {
      climbed_from[at] = n;
      if (parent[at] != kNone && climbed_from[parent[at]] == n) document.fail(place_of(parent[at]), "is its own ancestor");
    }
  }
  return parent;
}

/// The transforms of a node's instances.
std::vector<glm::dmat4> instance_matrices(GltfDocument& document, const std::string& place,
                                          const tinygltf::Value& attributes) {
  std::size_t count = 0;
  bool any = false;
  const auto values_of = [&](const char* key, std::size_t width) {
    std::vector<double> values;
    if (!attributes.Has(key)) return values;
    values = read_values(document, static_cast<std::size_t>(attributes.Get(key).GetNumberAsInt()), width);
    if (any && values.size() != width * count) document.fail(place, "its instances' attributes have different lengths");
    count = values.size() / width;
    any = true;
    return values;
  };
  const std::vector<double> translations = values_of("TRANSLATION", 3), rotations = values_of("ROTATION", 4),
                            scales = values_of("SCALE", 3);
  std::vector<glm::dmat4> matrices;
  const auto part = [](const std::vector<double>& values, std::size_t i, std::size_t width) {
    return values.empty() ? std::vector<double>() : std::vector<double>(&values[width * i], &values[width * i] + width);
  };
  for (std::size_t i = 0; i < count; ++i) {
    matrices.push_back(matrix_of(part(translations, i, 3), part(rotations, i, 4), part(scales, i, 3)));
  }
  return matrices;
}

/// Smallest opacity of materials with transmission: even if it transmits all light, its lines belong to an object.
constexpr double kTransmissionOpacity = 0.1;

}  // namespace

glm::dmat4 matrix_of(const std::vector<double>& translation, const std::vector<double>& rotation,
                     const std::vector<double>& scale) {
  glm::dmat4 m(1);
  const glm::dmat3 turn = rotation.size() == 4 ? rotation_matrix(rotation) : glm::dmat3(1);
  for (int i = 0; i < 3; ++i) {
    m[i] = glm::dvec4(turn[i] * (scale.size() == 3 ? scale[static_cast<std::size_t>(i)] : 1.0), 0);
    if (translation.size() == 3) m[3][i] = translation[static_cast<std::size_t>(i)];
  }
  return m;
}

GltfNodes list_nodes(const GltfDocument& document) {
  const tinygltf::Model& model = document.model;
  const std::vector<std::uint32_t> parent = find_parents(document);
  struct Visit {
    std::size_t node;
    bool is_hidden;
  };
  std::vector<Visit> stack;
  if (model.defaultScene >= 0) {
    for (const int root : model.scenes[static_cast<std::size_t>(model.defaultScene)].nodes) {
      stack.push_back({static_cast<std::size_t>(root), false});
    }
  } else {
    for (std::size_t n = 0; n < parent.size(); ++n) {
      if (parent[n] == kNone) stack.push_back({n, false});
    }
  }
  std::reverse(stack.begin(), stack.end());
  std::vector<std::uint8_t> visited(model.nodes.size(), 0);
  GltfNodes found;
  found.to_world = world_matrices(model.nodes, parent);
  while (!stack.empty()) {
    const Visit visit = stack.back();
    stack.pop_back();
    // Parents are unique, so only a scene that lists a node twice, or a node and its ancestor, gets here again.
    if (visited[visit.node]) document.fail(place_of(visit.node), "is in the scene twice");
    visited[visit.node] = 1;
    const tinygltf::Node& node = model.nodes[visit.node];
    const glm::dmat4& to_world = found.to_world[visit.node];
    const bool is_hidden = visit.is_hidden || node.extensions.contains(kVisibilityExtension);
    if (node.mesh >= 0 && !is_hidden) found.instances.push_back({visit.node, static_cast<std::size_t>(node.mesh), to_world});
    const auto camera = static_cast<std::size_t>(node.camera);
    if (node.camera >= 0 && camera < model.cameras.size()) found.cameras.push_back({visit.node, camera, to_world});
    for (auto child = node.children.rbegin(); child != node.children.rend(); ++child) {
      stack.push_back({static_cast<std::size_t>(*child), is_hidden});
    }
  }
  return found;
}

double largest_stretch(const glm::dmat4& matrix) {
  // Largest eigenvalue of the symmetric matrix A^T A in closed form (Smith, "Eigenvalues of a symmetric 3 x 3 matrix",
  // 1961).
  const glm::dmat3 a(matrix);
  const glm::dmat3 s = glm::transpose(a) * a;
  const double mean = (s[0][0] + s[1][1] + s[2][2]) / 3;
  const double off = s[0][1] * s[0][1] + s[0][2] * s[0][2] + s[1][2] * s[1][2];
  const double x = s[0][0] - mean, y = s[1][1] - mean, z = s[2][2] - mean;
  const double p = std::sqrt((x * x + y * y + z * z + 2 * off) / 6);
  if (!(p > 0) || !std::isfinite(p)) return std::sqrt(mean);
  const double r = std::clamp(glm::determinant((s - glm::dmat3(mean)) / p) / 2, -1.0, 1.0);
  return std::sqrt(mean + 2 * p * std::cos(std::acos(r) / 3));
}

void add_gpu_instances(GltfDocument& document, std::size_t most, std::vector<GltfInstance>& instances) {
  std::vector<GltfInstance> all;
  for (const GltfInstance& instance : instances) {
    const auto& extensions = document.model.nodes[instance.node].extensions;
    const auto extension = extensions.find(kInstancingExtension);
    if (extension == extensions.end()) {
      all.push_back(instance);
      continue;
    }
    const std::string place = "node " + std::to_string(instance.node);
    for (const glm::dmat4& matrix : instance_matrices(document, place, extension->second.Get("attributes"))) {
      all.push_back({instance.node, instance.mesh, instance.to_world * matrix});
    }
    if (all.size() > most) document.fail(place, "has more than " + std::to_string(most) + " instances");
  }
  instances = std::move(all);
}

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
