#pragma once
/// The bytes of the buffers of a glTF file.

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

/// Bytes that a base64 text stands for, or nothing when it is not base64.
std::optional<std::vector<std::byte>> decode_base64(std::string_view text);

/// Buffers are fetched when they are first asked for, so that a missing file that only images use does no harm.
class GltfBuffers {
 public:
  /// `chunk` is the binary chunk of a GLB; it must outlive this object, nothing is copied.
  GltfBuffers(std::vector<GltfBufferEntry> entries, std::span<const std::byte> chunk, std::filesystem::path folder,
              std::string name);

  /// All byteLength bytes of a buffer. Throws InputError.
  std::span<const std::byte> get(std::size_t buffer);

  /// The files that buffers name, whether they are fetched or not.
  InputFiles files() const;

  /// Size of the buffers fetched so far that stand in files of their own or in data uris.
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

}  // namespace ligne
