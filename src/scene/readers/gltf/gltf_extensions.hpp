#pragma once
/// Classifies the extensions of glTF: those that are read, those that affect no drawing, and all others.

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "files/omissions.hpp"

namespace ligne {

inline constexpr char kDracoExtension[] = "KHR_draco_mesh_compression";
inline constexpr char kMeshoptExtension[] = "EXT_meshopt_compression";
inline constexpr char kInstancingExtension[] = "EXT_mesh_gpu_instancing";
inline constexpr char kVisibilityExtension[] = "KHR_node_visibility";
inline constexpr char kTransmissionExtension[] = "KHR_materials_transmission";
inline constexpr char kGlossinessExtension[] = "KHR_materials_pbrSpecularGlossiness";

/// Throws InputError with the name of the extension if the geometry can not be read without it.
void check_required_extension(const std::string& extension, const std::string& name);

/// Counts objects with extensions that are not read, but that a drawing might show: "nodes with EXT_foo".
void count_extensions(const nlohmann::json& root, Omissions& left_out);

}  // namespace ligne
