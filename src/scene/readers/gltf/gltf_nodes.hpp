#pragma once
/// The node hierarchy of a glTF file.

#include <cstddef>
#include <glm/mat4x4.hpp>
#include <vector>

#include "scene/readers/gltf/gltf_document.hpp"

namespace ligne {

/// A mesh as it stands in the world.
struct GltfInstance {
  std::size_t node = 0;
  std::size_t mesh = 0;
  glm::dmat4 to_world{1};
};

/// A camera as it stands in the world.
struct GltfCamera {
  std::size_t node = 0;
  std::size_t camera = 0;
  glm::dmat4 to_world{1};
};

struct GltfNodes {
  std::vector<GltfInstance> instances;
  std::vector<GltfCamera> cameras;
  std::vector<glm::dmat4> to_world;  ///< of every node of the file
};

/// The transform of a translation, a rotation (quaternion x, y, z, w) and a scale, applied from the last to the first. Lists
/// that are empty change nothing.
glm::dmat4 matrix_of(const std::vector<double>& translation, const std::vector<double>& rotation,
                     const std::vector<double>& scale);

/// The nodes with a mesh or a camera of the default scene, or below all root nodes when the file names no scene, parents
/// before children. Meshes of nodes that KHR_node_visibility hides, and of those below them, are not among them. Throws
/// InputError when the nodes are not a strict tree.
GltfNodes list_nodes(const GltfDocument& document);

/// Largest stretch of a direction by the linear part of a transform: its largest singular value.
double largest_stretch(const glm::dmat4& m);

}  // namespace ligne
