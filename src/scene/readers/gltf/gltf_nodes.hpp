#pragma once
/// The node hierarchy of a glTF file, its cameras and its materials.

#include <cstddef>
#include <glm/mat4x4.hpp>
#include <optional>
#include <vector>

#include "scene/model/scene.hpp"
#include "scene/readers/gltf/gltf_document.hpp"

namespace ligne {

/// A mesh placed in the world.
struct GltfInstance {
  std::size_t node = 0;
  std::size_t mesh = 0;
  glm::dmat4 to_world{1};
};

/// A camera placed in the world.
struct GltfCamera {
  std::size_t node = 0;
  std::size_t camera = 0;
  glm::dmat4 to_world{1};
};

struct GltfNodes {
  std::vector<GltfInstance> instances;
  std::vector<GltfCamera> cameras;
  std::vector<glm::dmat4> to_world;  ///< per node of the file
};

/// The transform that applies a scale, then a rotation (quaternion x, y, z, w), then a translation. Empty lists change
/// nothing.
glm::dmat4 matrix_of(const std::vector<double>& translation, const std::vector<double>& rotation,
                     const std::vector<double>& scale);

/// The nodes with a mesh or a camera of the default scene, or of all root nodes if the file has no scene, parents
/// before children. Omits meshes of nodes hidden by KHR_node_visibility and of their descendants. Throws InputError
/// unless the nodes are a strict tree.
GltfNodes list_nodes(const GltfDocument& document);

/// Largest stretch of a direction by the linear part of a transform: its largest singular value.
double largest_stretch(const glm::dmat4& m);

/// Instances of EXT_mesh_gpu_instancing.

/// Replaces the instance of every node with the extension by the instances of the extension. Their transforms are
/// applied before that of the node. Throws InputError if the attributes disagree, or if there are more than `most` in
/// all.
void add_gpu_instances(GltfDocument& document, std::size_t most, std::vector<GltfInstance>& instances);

Material scene_material(const tinygltf::Material& from);

/// A camera, which looks along -z of its node with y up; nothing if its numbers are meaningless. One without a name is named
/// by `number`, so that it can be selected.
std::optional<SceneCamera> scene_camera(const tinygltf::Model& model, const GltfCamera& from, std::size_t number);

}  // namespace ligne
