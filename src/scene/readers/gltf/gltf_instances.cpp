#include "scene/readers/gltf/gltf_instances.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "scene/readers/gltf/gltf_accessor.hpp"
#include "scene/readers/gltf/gltf_extensions.hpp"

namespace ligne {
namespace {

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

}  // namespace

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

}  // namespace ligne
