#pragma once
/// An opened glTF file: tinygltf's model and the bytes of the buffers.

#include <tiny_gltf.h>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "files/input_file.hpp"
#include "scene/readers/gltf/gltf_json.hpp"

namespace ligne {

/// Buffers are fetched when first requested, so that a missing file used only by images does no harm.
class GltfBuffers {
 public:
  /// `chunk` is the binary chunk of a GLB. It is not copied and must outlive this object.
  GltfBuffers(std::vector<GltfBufferEntry> entries, std::span<const std::byte> chunk, std::filesystem::path folder,
              std::string name);

  /// All byteLength bytes of a buffer. Throws InputError.
  std::span<const std::byte> get(std::size_t buffer);

  /// The files that buffers refer to, fetched or not.
  InputFiles files() const;
  /// The file of a uri; nothing if it is not in the folder of the model.
  std::optional<std::filesystem::path> file_of(const std::string& uri) const;

  /// Total size of the fetched buffers that come from files of their own or from data URIs.
  std::size_t bytes_read() const;

 private:
  std::vector<std::byte> read(std::size_t buffer) const;
  std::vector<std::byte> read_file(std::size_t buffer) const;
  [[noreturn]] void fail(std::size_t buffer, const std::string& cause) const;

  std::vector<GltfBufferEntry> entries_;
  std::vector<std::optional<std::vector<std::byte>>> bytes_;
  std::span<const std::byte> chunk_;
  std::filesystem::path folder_;
  std::string name_;
};

struct GltfDocument {
  std::string name;       ///< used in error messages
  tinygltf::Model model;  ///< checked geometry and materials only (see gltf_json.hpp); its buffers are empty
  GltfBuffers buffers;
  std::size_t file_bytes;  ///< size of the file itself

  Omissions left_out, animation_left_out;  ///< see CheckedGltf
  std::string animation_error;
  std::vector<std::optional<GltfTexture>> textures;
  std::set<std::size_t> color_textures;
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

/// The bytes of a base64 text, or nothing if it is not base64.
std::optional<std::vector<std::byte>> decode_base64(std::string_view text);

}  // namespace ligne
