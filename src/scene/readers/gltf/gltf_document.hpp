#pragma once
/// A glTF file taken apart: tinygltf's model and the bytes of the buffers.

#include <tiny_gltf.h>

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>

#include "scene/readers/gltf/gltf_buffers.hpp"

namespace ligne {

struct GltfDocument {
  std::string name;       ///< stands in error messages
  tinygltf::Model model;  ///< geometry and materials alone, checked (see gltf_json.hpp); its buffers are empty
  GltfBuffers buffers;
  std::size_t file_bytes;  ///< size of the file itself

  Omissions left_out, animation_left_out;  ///< see CheckedGltf
  std::string animation_error;
  std::vector<std::optional<GltfCompressed>> compressed;            ///< by bufferView
  std::vector<std::optional<std::vector<std::byte>>> decompressed;  ///< by bufferView, those that were asked for

  /// The bytes of a bufferView, decompressed where they are not stored as they are. Throws InputError.
  std::span<const std::byte> view_bytes(std::size_t view);
  /// Size of everything that was read so far: the file, the buffers that were asked for, and what came out of them.
  std::size_t bytes_read() const;
  [[noreturn]] void fail(const std::string& place, const std::string& cause) const;
};

/// Opens a file. `bytes` must outlive the document: the binary chunk of a GLB is not copied. Throws InputError.
GltfDocument open_gltf(std::span<const std::byte> bytes, bool binary, const std::filesystem::path& folder,
                       const std::string& name);

}  // namespace ligne
