#include "scene/readers/gltf/gltf_buffers.hpp"

#include <array>
#include <cstdint>
#include <fstream>
#include <utility>

#include "files/message_text.hpp"
#include "scene/model/diagnostics.hpp"
#include "scene/readers/folder_file.hpp"

namespace ligne {
namespace {

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
    const std::string path = percent_decode(entry.uri);
    if (entry.has_uri && !entry.uri.starts_with("data:") && stays_in_folder(path) && !folder_.empty())
      files.push_back(folder_ / path);
  }
  return files;
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
