#pragma once
/// Reader of glTF 2.0 and GLB.

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "scene/creases/file_shading.hpp"
#include "scene/model/diagnostics.hpp"
#include "scene/model/scene.hpp"
#include "scene/readers/model_bytes.hpp"
#include "scene/readers/read_report.hpp"

namespace ligne {

/// Reads a glTF 2.0 file (`binary`: GLB). Every node with a mesh in the default scene (below all root nodes if the file
/// has no scene) becomes one object, in world coordinates, y up; the scene is not cleaned yet. Morph targets have their
/// default weights and skins their bind pose, unless `pose` gives a moment of an animation. Omissions are counted by
/// name. Images are never read. Normals go to `shading` unless it is null. Throws InputError. Source: Khronos glTF 2.0
/// specification (ISO/IEC 12113:2022), KHR_mesh_quantization, KHR_draco_mesh_compression, EXT_meshopt_compression,
/// EXT_mesh_gpu_instancing, KHR_node_visibility.
Scene read_gltf(const ModelBytes& file, bool binary, ReadReport& report, Warnings& warnings, FileShading* shading = nullptr,
                const std::optional<ScenePose>& pose = {});

}  // namespace ligne
