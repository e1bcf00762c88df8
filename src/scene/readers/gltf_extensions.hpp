#pragma once
/// The glTF extensions that a file may require.

#include <string>

namespace ligne {

inline constexpr char kDracoExtension[] = "KHR_draco_mesh_compression";

/// Throws InputError naming the extension when the geometry can not be understood without it.
void check_required_extension(const std::string& extension, const std::string& name);

}  // namespace ligne
