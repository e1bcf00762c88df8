#include "scene/readers/gltf/gltf_document.hpp"

#include <cstdint>
#include <limits>

#include "scene/model/diagnostics.hpp"
#include "scene/readers/text_lines.hpp"

namespace ligne {
namespace {

/// GLB: a header of 12 bytes, then chunks: length, kind, bytes (glTF 2.0, section 4.4).
constexpr std::size_t kGlbHeader = 12, kChunkHeader = 8;
constexpr std::uint32_t kGlbMagic = 0x46546c67, kGlbVersion = 2, kJsonChunk = 0x4e4f534a, kBinaryChunk = 0x004e4942;

struct Chunks {
  std::string_view json;
  std::span<const std::byte> binary;
};

std::uint32_t word(std::span<const std::byte> bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value |= std::to_integer<std::uint32_t>(bytes[at + i]) << (8 * i);
  return value;
}

std::string_view as_text(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

Chunks split_glb(std::span<const std::byte> bytes, const std::string& name) {
  if (bytes.size() < kGlbHeader + kChunkHeader) throw InputError(name, "GLB: shorter than its headers");
  if (word(bytes, 0) != kGlbMagic) throw InputError(name, "GLB: does not begin with glTF");
  if (word(bytes, 4) == 1) throw InputError(name, kGltf1);
  if (word(bytes, 4) != kGlbVersion) throw InputError(name, "GLB: version " + std::to_string(word(bytes, 4)) + " is not 2");
  const std::size_t length = word(bytes, 8);
  if (length > bytes.size()) {
    throw InputError(name, "GLB: cut off: " + std::to_string(bytes.size()) + " of " + std::to_string(length) + " bytes");
  }
  Chunks chunks;
  std::size_t at = kGlbHeader;
  for (int i = 0; at + kChunkHeader <= length; ++i) {
    const std::size_t size = word(bytes, at);
    const std::uint32_t kind = word(bytes, at + 4);
    at += kChunkHeader;
    if (size > length - at) {
      throw InputError(
          name, "GLB: chunk " + std::to_string(i) + " of " + std::to_string(size) + " bytes does not fit into the file");
    }
    if (i == 0 && kind != kJsonChunk) throw InputError(name, "GLB: the first chunk is not JSON");
    if (i == 0) chunks.json = as_text(bytes.subspan(at, size));
    if (i == 1 && kind == kBinaryChunk) chunks.binary = bytes.subspan(at, size);
    at += size;
  }
  return chunks;
}

}  // namespace

void GltfDocument::fail(const std::string& place, const std::string& cause) const {
  throw InputError(name, place + ": " + cause);
}

std::span<const std::byte> GltfDocument::view_bytes(std::size_t index) {
  const tinygltf::BufferView& view = model.bufferViews[index];
  if (!compressed[index]) {
    // A view lies inside its buffer (gltf_json.cpp).
    return buffers.get(static_cast<std::size_t>(view.buffer)).subspan(view.byteOffset, view.byteLength);
  }
  std::optional<std::vector<std::byte>>& bytes = decompressed[index];
  if (!bytes) {
    const auto& [range, as] = *compressed[index];
    std::string cause;
    bytes = decode_meshopt(buffers.get(range.buffer).subspan(range.offset, range.length), as, cause);
    if (!cause.empty()) fail("bufferView " + std::to_string(index), "its compressed bytes are " + cause);
  }
  return *bytes;
}

std::size_t GltfDocument::bytes_read() const {
  std::size_t sum = file_bytes + buffers.bytes_read();
  for (const auto& bytes : decompressed) sum += bytes ? bytes->size() : 0;
  return sum;
}

GltfDocument open_gltf(std::span<const std::byte> bytes, bool binary, const std::filesystem::path& folder,
                       const std::string& name) {
  Chunks chunks;
  if (binary) {
    chunks = split_glb(bytes, name);
  } else {
    chunks.json = as_text(bytes);
  }
  CheckedGltf checked = check_gltf(chunks.json, name);
  if (checked.text.size() > std::numeric_limits<unsigned>::max()) throw InputError(name, "JSON: too large");
  GltfDocument document{name,
                        {},
                        GltfBuffers(std::move(checked.buffers), chunks.binary, folder, name),
                        bytes.size(),
                        std::move(checked.left_out),
                        std::move(checked.animation_left_out),
                        std::move(checked.animation_error),
                        std::move(checked.compressed),
                        {}};
  document.decompressed.resize(document.compressed.size());
  tinygltf::TinyGLTF loader;
  std::string error, warning;
  if (!loader.LoadASCIIFromString(&document.model, &error, &warning, checked.text.data(),
                                  static_cast<unsigned>(checked.text.size()), "")) {
    throw InputError(name, "glTF: " + printable(error.substr(0, error.find('\n')), 200));
  }
  return document;
}

}  // namespace ligne
