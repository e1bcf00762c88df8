#pragma once
/// Our binary files as a whole: a mark, a version, a checksum of the contents, the contents.

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "files/bytes.hpp"

namespace ligne {

struct SignedKind {
  std::string_view mark;   ///< contains a line end, which changes if a file is copied as text
  std::uint32_t version;   ///< the version that is written, and the only one read
  std::string_view what;   ///< name in messages: "a compiled model"
  std::string_view again;  ///< advice for another version: "compile the model again"
};

/// Makes a file with the contents `rest`. Equal contents give equal files.
std::string signed_bytes(const SignedKind& kind, std::string_view rest);

/// Writes the checksum of the contents into the bytes of such a file.
void sign(const SignedKind& kind, std::string& bytes);

/// Whether a file begins with the mark.
bool has_mark(const SignedKind& kind, std::span<const std::byte> bytes);

/// Returns a reader of the contents. `name` is used in error messages. Throws InputError if the bytes are no such file,
/// of another version, or damaged.
ByteReader open_signed(const SignedKind& kind, std::span<const std::byte> bytes, const std::string& name);

/// Number of bytes before the contents.
constexpr std::size_t head_size(const SignedKind& kind) {
  return kind.mark.size() + sizeof(std::uint32_t) + sizeof(std::uint64_t);
}

}  // namespace ligne
