#pragma once
/// The JSON part of a glTF file, checked.

#include <array>
#include <cstddef>
#include <glm/mat3x2.hpp>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "files/omissions.hpp"
#include "scene/readers/gltf/meshopt_codec.hpp"
#include "scene/readers/textures/palette_texture.hpp"

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

/// The texture of a material's base colour.
struct GltfTexture {
  std::size_t number = 0;           ///< index of the texture
  std::optional<std::size_t> view;  ///< the bufferView of the PNG; otherwise it is in `uri`
  std::string uri;
  std::size_t coordinates = 0;  ///< the n of TEXCOORD_n
  std::array<TextureWrap, 2> wrap{TextureWrap::repeat, TextureWrap::repeat};
  glm::dmat3x2 transform{1};  ///< of coordinates, by KHR_texture_transform

  std::string attribute() const { return "TEXCOORD_" + std::to_string(coordinates); }
};

/// The parts of a glTF file that a drawing needs. Every index is in range and every type is right.
struct CheckedGltf {
  /// JSON for tinygltf with only the geometry and its materials, without buffers. The index accessor of a primitive is
  /// among its attributes as kGltfIndices.
  std::string text;
  std::vector<GltfBufferEntry> buffers;
  std::vector<std::optional<GltfCompressed>> compressed;  ///< by bufferView
  std::vector<std::optional<GltfTexture>> textures;       ///< by material; those that may be palettes
  std::set<std::size_t> color_textures;                   ///< indices of all textures of base colours
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
