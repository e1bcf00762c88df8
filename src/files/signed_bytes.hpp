#pragma once
/// Binary files of ours as a whole: a mark, a version, a checksum of the rest, the rest.

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "files/bytes.hpp"

namespace ligne {

struct SignedKind {
  std::string_view mark;   ///< with a line end, which is lost where a file is copied as text
  std::uint32_t version;   ///< that is read and written
  std::string_view what;   ///< in messages: "a compiled model"
  std::string_view again;  ///< what to do with another version: "compile the model again"
};

/// The file with `rest` in it. The same bytes give the same file.
std::string signed_bytes(const SignedKind& kind, std::string_view rest);

/// Puts the checksum of the rest into the bytes of such a file.
void sign(const SignedKind& kind, std::string& bytes);

/// Whether a file begins with the mark.
bool has_mark(const SignedKind& kind, std::span<const std::byte> bytes);

/// A reader of the rest. `name` stands in error messages. Throws InputError for what is no such file, is of another version,
/// or has another checksum.
ByteReader open_signed(const SignedKind& kind, std::span<const std::byte> bytes, const std::string& name);

/// How many bytes stand before the rest.
constexpr std::size_t head_size(const SignedKind& kind) {
  return kind.mark.size() + sizeof(std::uint32_t) + sizeof(std::uint64_t);
}

}  // namespace ligne
