#include "scene/readers/gltf/gltf_document.hpp"

#include <array>
#include <cstdint>
#include <fstream>
#include <limits>
#include <utility>

#include "files/message_text.hpp"
#include "scene/readers/folder_file.hpp"

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

constexpr std::uint8_t kNotBase64 = 0xff;

constexpr std::array<std::uint8_t, 256> base64_table() {
  std::array<std::uint8_t, 256> table{};
  table.fill(kNotBase64);
  constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  for (std::size_t i = 0; i < letters.size(); ++i)
    table[static_cast<unsigned char>(letters[i])] = static_cast<std::uint8_t>(i);
  return table;
}

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

/// RFC 3986 percent decoding; a '%' that begins no escape stays.
std::string percent_decode(std::string_view uri) {
  std::string out;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    if (uri[i] == '%' && i + 2 < uri.size() && hex_digit(uri[i + 1]) >= 0 && hex_digit(uri[i + 2]) >= 0) {
      out += static_cast<char>(16 * hex_digit(uri[i + 1]) + hex_digit(uri[i + 2]));
      i += 2;
    } else {
      out += uri[i];
    }
  }
  return out;
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
                        std::move(checked.textures),
                        std::move(checked.color_textures),
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

std::optional<std::vector<std::byte>> decode_base64(std::string_view text) {
  static constexpr std::array<std::uint8_t, 256> kTable = base64_table();
  for (int i = 0; i < 2 && !text.empty() && text.back() == '='; ++i) text.remove_suffix(1);
  if (text.size() % 4 == 1) return std::nullopt;
  std::vector<std::byte> out;
  out.reserve(text.size() / 4 * 3 + 3);
  std::uint32_t bits = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const std::uint8_t six = kTable[static_cast<unsigned char>(text[i])];
    if (six == kNotBase64) return std::nullopt;
    bits = bits << 6 | six;
    if (i % 4 == 0) continue;
    // The second, third and fourth letter of four each complete another eight bits.
    out.push_back(static_cast<std::byte>(bits >> (6 - 2 * (i % 4)) & 0xff));
  }
  return out;
}

GltfBuffers::GltfBuffers(std::vector<GltfBufferEntry> entries, std::span<const std::byte> chunk,
                         std::filesystem::path folder, std::string name)
    : entries_(std::move(entries)),
      bytes_(entries_.size()),
      chunk_(chunk),
      folder_(std::move(folder)),
      name_(std::move(name)) {}

std::span<const std::byte> GltfBuffers::get(std::size_t buffer) {
  const GltfBufferEntry& entry = entries_[buffer];
  if (!entry.has_uri) {
    if (buffer != 0 || chunk_.empty()) fail(buffer, "has no uri, and there is no binary chunk for it");
    if (entry.byte_length > chunk_.size()) {
      fail(buffer, "byteLength " + std::to_string(entry.byte_length) + " is more than the " + std::to_string(chunk_.size()) +
                       " bytes of the binary chunk");
    }
    return chunk_.first(entry.byte_length);
  }
  if (!bytes_[buffer]) bytes_[buffer] = read(buffer);
  return *bytes_[buffer];
}

std::size_t GltfBuffers::bytes_read() const {
  std::size_t sum = 0;
  for (const auto& bytes : bytes_) sum += bytes ? bytes->size() : 0;
  return sum;
}

InputFiles GltfBuffers::files() const {
  InputFiles files;
  for (const GltfBufferEntry& entry : entries_) {
    if (auto file = entry.has_uri ? file_of(entry.uri) : std::nullopt) files.push_back(*std::move(file));
  }
  return files;
}

std::optional<std::filesystem::path> GltfBuffers::file_of(const std::string& uri) const {
  const std::string path = percent_decode(uri);
  if (uri.starts_with("data:") || folder_.empty() || !stays_in_folder(path)) return std::nullopt;
  return folder_ / path;
}

std::vector<std::byte> GltfBuffers::read(std::size_t buffer) const {
  const GltfBufferEntry& entry = entries_[buffer];
  if (!entry.uri.starts_with("data:")) return read_file(buffer);
  const std::size_t comma = entry.uri.find(',');
  if (comma == std::string::npos || !std::string_view(entry.uri).substr(0, comma).ends_with(";base64")) {
    fail(buffer, "its data uri is not base64");
  }
  std::optional<std::vector<std::byte>> bytes = decode_base64(std::string_view(entry.uri).substr(comma + 1));
  if (!bytes) fail(buffer, "its data uri is broken base64");
  if (bytes->size() < entry.byte_length) {
    fail(buffer, "byteLength " + std::to_string(entry.byte_length) + " is more than the " + std::to_string(bytes->size()) +
                     " bytes of its data uri");
  }
  bytes->resize(entry.byte_length);
  return *std::move(bytes);
}

std::vector<std::byte> GltfBuffers::read_file(std::size_t buffer) const {
  const GltfBufferEntry& entry = entries_[buffer];
  const std::string path = percent_decode(entry.uri);
  if (!stays_in_folder(path)) fail(buffer, "uri " + shown(entry.uri, '"') + " is not a file in the folder of the model");
  if (folder_.empty()) fail(buffer, "uri " + shown(entry.uri, '"') + " can not be read: the model has no folder");
  const std::filesystem::path file = folder_ / path;
  std::error_code error;
  // Reading a pipe or a device might never end.
  if (!std::filesystem::is_regular_file(file, error)) fail(buffer, "there is no file " + shown(entry.uri, '"'));
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  if (error) fail(buffer, "file " + shown(entry.uri, '"') + " can not be read");
  if (size < entry.byte_length) {
    fail(buffer, "byteLength " + std::to_string(entry.byte_length) + " is more than the " + std::to_string(size) +
                     " bytes of file " + shown(entry.uri, '"'));
  }
  std::vector<std::byte> bytes(entry.byte_length);
  std::ifstream stream(file, std::ios::binary);
  if (!stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()))) {
    fail(buffer, "file " + shown(entry.uri, '"') + " can not be read");
  }
  return bytes;
}

void GltfBuffers::fail(std::size_t buffer, const std::string& cause) const {
  throw InputError(name_, "buffer " + std::to_string(buffer) + ": " + cause);
}

}  // namespace ligne
