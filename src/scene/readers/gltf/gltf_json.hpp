#pragma once
/// The JSON part of a glTF file, checked.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "files/omissions.hpp"
#include "scene/readers/gltf/meshopt_codec.hpp"

namespace ligne {

/// A buffer as the file describes it.
struct GltfBufferEntry {
  std::size_t byte_length = 0;
  bool has_uri = false;  ///< a buffer without uri is the binary chunk of a GLB
  std::string uri;
};

/// A range of bytes of a buffer.
struct GltfRange {
  std::size_t buffer = 0, offset = 0, length = 0;
};

/// A buffer view compressed by EXT_meshopt_compression.
struct GltfCompressed {
  GltfRange bytes;
  MeshoptView view;
};

/// The parts of a glTF file that a drawing needs. Every index is in range and every type is right.
struct CheckedGltf {
  /// JSON for tinygltf with only the geometry and its materials, without buffers. The index accessor of a primitive is
  /// among its attributes as kGltfIndices.
  std::string text;
  std::vector<GltfBufferEntry> buffers;
  std::vector<std::optional<GltfCompressed>> compressed;  ///< by bufferView
  Omissions left_out;
  Omissions animation_left_out;  ///< reported only if a pose is requested
  std::string animation_error;   ///< error line of broken animations; likewise
};

/// Message for glTF 1.0: it is not read, and how to convert it.
inline constexpr char kGltf1[] = "is glTF 1.0, which is not read: convert it with gltf-pipeline -i OLD -o NEW.glb";

/// Attribute for index accessors. tinygltf refuses them without a bufferView, as Draco and sparse accessors have them,
/// but accepts such attributes.
inline constexpr char kGltfIndices[] = "_LIGNE_INDICES";

/// Parses and checks. Throws InputError(name, "accessor 3: ...").
CheckedGltf check_gltf(std::string_view json, const std::string& name);

}  // namespace ligne
