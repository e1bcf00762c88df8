#pragma once
/// The frame of our binary files: magic bytes, a version, a checksum of the contents, the contents.

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "files/bytes.hpp"

namespace ligne {

struct ChecksummedFormat {
  std::string_view magic;   ///< first bytes; they contain a line end, which changes if a file is copied as text
  std::uint32_t version;    ///< written, and the only one read
  std::string_view name;    ///< in messages: "a compiled model"
  std::string_view advice;  ///< for files of another version: "compile the model again"
};

/// Returns the bytes of a file. Equal contents give equal files.
std::string checksummed_file(const ChecksummedFormat& format, std::string_view contents);

/// Updates the checksum after the contents of a file were changed.
void write_checksum(const ChecksummedFormat& format, std::string& bytes);

bool has_magic(const ChecksummedFormat& format, std::span<const std::byte> bytes);

/// Returns a reader of the contents. `name` is used in error messages. Throws InputError if the bytes are not such a file,
/// have another version, or are damaged.
ByteReader open_checksummed(const ChecksummedFormat& format, std::span<const std::byte> bytes, const std::string& name);

/// Number of bytes before the contents.
constexpr std::size_t header_size(const ChecksummedFormat& format) {
  return format.magic.size() + sizeof(std::uint32_t) + sizeof(std::uint64_t);
}

}  // namespace ligne
