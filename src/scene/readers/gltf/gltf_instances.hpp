#pragma once
/// Instances of EXT_mesh_gpu_instancing.

#include <vector>

#include "scene/readers/gltf/gltf_nodes.hpp"

namespace ligne {

/// Puts, for every node with the extension, its instances in the place of the one: each transform of an instance is applied
/// before that of the node. Throws InputError when the attributes disagree, or there are more than `most` in all.
void add_gpu_instances(GltfDocument& document, std::size_t most, std::vector<GltfInstance>& instances);

}  // namespace ligne
