#pragma once
/// An opened glTF file: tinygltf's model and the bytes of the buffers.

#include <tiny_gltf.h>

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>

#include "scene/readers/gltf/gltf_buffers.hpp"

namespace ligne {

struct GltfDocument {
  std::string name;       ///< used in error messages
  tinygltf::Model model;  ///< checked geometry and materials only (see gltf_json.hpp); its buffers are empty
  GltfBuffers buffers;
  std::size_t file_bytes;  ///< size of the file itself

  Omissions left_out, animation_left_out;  ///< see CheckedGltf
  std::string animation_error;
  std::vector<std::optional<GltfCompressed>> compressed;            ///< by bufferView
  std::vector<std::optional<std::vector<std::byte>>> decompressed;  ///< by bufferView; the requested ones

  /// The bytes of a bufferView, decompressed if necessary. Throws InputError.
  std::span<const std::byte> view_bytes(std::size_t view);
  /// Total size of the data read so far: the file, the requested buffers, and their decompressed contents.
  std::size_t bytes_read() const;
  [[noreturn]] void fail(const std::string& place, const std::string& cause) const;
};

/// Opens a file. `bytes` must outlive the document, since the binary chunk of a GLB is not copied. Throws InputError.
GltfDocument open_gltf(std::span<const std::byte> bytes, bool binary, const std::filesystem::path& folder,
                       const std::string& name);

}  // namespace ligne
