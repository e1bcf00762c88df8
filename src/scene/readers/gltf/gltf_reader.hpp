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

/// Reads a glTF 2.0 file (`binary`: GLB). Every node with a mesh of the default scene (of all root nodes, when the file
/// names none) becomes one object, in world coordinates, y up; the scene is not cleaned yet. Morph targets have their
/// default weights, skins their bind pose, or all of them the moment of an animation that `pose` names. What is left out is
/// counted by name. Images are never looked at. Normals go to `shading`, where there is one. Throws InputError. Source:
/// Khronos glTF 2.0 specification (ISO/IEC 12113:2022), KHR_mesh_quantization, KHR_draco_mesh_compression,
/// EXT_meshopt_compression, EXT_mesh_gpu_instancing, KHR_node_visibility.
Scene read_gltf(const ModelBytes& file, bool binary, ReadReport& report, Warnings& warnings, FileShading* shading = nullptr,
                const std::optional<ScenePose>& pose = {});

}  // namespace ligne
