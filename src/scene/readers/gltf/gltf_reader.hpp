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
#include "scene/readers/read_report.hpp"

namespace ligne {

/// Reads a glTF 2.0 file (`binary`: GLB). Every node with a mesh of the default scene (of all root nodes, when the file
/// names none) becomes one object, in world coordinates, y up; the scene is not cleaned yet. Buffers that the file names are
/// looked up in `folder` and nowhere else; an empty folder means there are none. `name` stands in error messages.
/// Morph targets have their default weights, skins their bind pose, or all of them the moment of an animation that `pose`
/// names. What is left out is counted by name. Images are never looked at. Normals go to `shading`, where there is
/// one. Throws InputError.
/// Source: Khronos glTF 2.0 specification (ISO/IEC 12113:2022), KHR_mesh_quantization, KHR_draco_mesh_compression,
/// EXT_meshopt_compression, EXT_mesh_gpu_instancing, KHR_node_visibility.
Scene read_gltf(std::span<const std::byte> bytes, bool binary, const std::filesystem::path& folder, const std::string& name,
                ReadReport& report, Warnings& warnings, FileShading* shading = nullptr,
                const std::optional<ScenePose>& pose = {});

}  // namespace ligne
