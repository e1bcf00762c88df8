#pragma once
/// The JSON part of a glTF file, checked.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace ligne {

/// A buffer as the file describes it.
struct GltfBufferEntry {
  std::size_t byte_length = 0;
  bool has_uri = false;  ///< a buffer without uri is the binary chunk of a GLB
  std::string uri;
};

/// What a drawing needs of a glTF file: every index is in range, every type is right.
struct CheckedGltf {
  /// JSON with the geometry and its materials alone, without buffers, for tinygltf. The index accessor of a primitive stands
  /// among its attributes as kGltfIndices.
  std::string text;
  std::vector<GltfBufferEntry> buffers;
};

/// tinygltf refuses index accessors without bufferView, which Draco and sparse accessors need, but takes such attributes.
inline constexpr char kGltfIndices[] = "_LIGNE_INDICES";

/// Parses and checks. Throws InputError(name, "accessor 3: ...").
CheckedGltf check_gltf(std::string_view json, const std::string& name);

}  // namespace ligne
