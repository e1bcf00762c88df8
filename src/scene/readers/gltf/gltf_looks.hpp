#pragma once
/// Materials and cameras of a glTF file.

#include <cstddef>
#include <optional>

#include "scene/model/scene.hpp"
#include "scene/readers/gltf/gltf_nodes.hpp"

namespace ligne {

Material scene_material(const tinygltf::Material& from);

/// A camera, which looks along -z of its node with y up; nothing if its numbers are meaningless. One without a name is named
/// by `number`, so that it can be selected.
std::optional<SceneCamera> scene_camera(const tinygltf::Model& model, const GltfCamera& from, std::size_t number);

}  // namespace ligne
