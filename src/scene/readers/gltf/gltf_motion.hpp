#pragma once
/// Checks the parts of a glTF file that move vertices: morph targets, skins, animations and instances.

#include <cstddef>
#include <nlohmann/json.hpp>

#include "files/omissions.hpp"
#include "scene/readers/gltf/gltf_item.hpp"

namespace ligne {

/// Lengths of the arrays to which these parts refer.
struct GltfCounts {
  std::size_t nodes = 0, accessors = 0, skins = 0;
};

/// The targets of a primitive, with their positions and normals.
nlohmann::json checked_targets(const GltfItem& primitive, const GltfCounts& counts);
/// Adds JOINTS_0, WEIGHTS_0 and so on to the attributes in `to`.
void add_skin_attributes(const GltfItem& attributes, const GltfCounts& counts, nlohmann::json& to);
nlohmann::json checked_skin(const GltfItem& skin, const GltfCounts& counts);
/// The channels that move nodes or change weights of morph targets; others are counted as left out.
nlohmann::json checked_animation(const GltfItem& animation, const GltfCounts& counts, Omissions& left_out);
/// The attributes of EXT_mesh_gpu_instancing.
nlohmann::json checked_instancing(const GltfItem& extension, const GltfCounts& counts);

}  // namespace ligne
