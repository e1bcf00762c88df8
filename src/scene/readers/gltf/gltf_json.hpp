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

/// The parts of a glTF file that a drawing needs: every index is in range, every type is right.
struct CheckedGltf {
  /// JSON with the geometry and its materials alone, without buffers, for tinygltf. The index accessor of a primitive stands
  /// among its attributes as kGltfIndices.
  std::string text;
  std::vector<GltfBufferEntry> buffers;
  std::vector<std::optional<GltfCompressed>> compressed;  ///< by bufferView
  Omissions left_out;
  Omissions animation_left_out;  ///< matters where a pose is asked for
  std::string animation_error;   ///< the same: the error line of animations that are broken
};

/// Says of a glTF 1.0 that it is not read, and what to do.
inline constexpr char kGltf1[] = "is glTF 1.0, which is not read: convert it with gltf-pipeline -i OLD -o NEW.glb";

/// tinygltf refuses index accessors without bufferView, which Draco and sparse accessors need, but takes such attributes.
inline constexpr char kGltfIndices[] = "_LIGNE_INDICES";

/// Parses and checks. Throws InputError(name, "accessor 3: ...").
CheckedGltf check_gltf(std::string_view json, const std::string& name);

}  // namespace ligne
