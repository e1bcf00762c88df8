#pragma once
/// Instances of EXT_mesh_gpu_instancing.

#include <vector>

#include "scene/readers/gltf/gltf_nodes.hpp"

namespace ligne {

/// Replaces the instance of every node with the extension by the instances of the extension. Their transforms are
/// applied before that of the node. Throws InputError if the attributes disagree, or if there are more than `most` in
/// all.
void add_gpu_instances(GltfDocument& document, std::size_t most, std::vector<GltfInstance>& instances);

}  // namespace ligne
