#include "files/signed_bytes.hpp"

#include <algorithm>
#include <cstring>

#include "base/hash.hpp"
#include "files/input_file.hpp"

namespace ligne {
namespace {

/// Checksum that detects damaged files, not forged ones.
std::uint64_t checksum(std::span<const std::byte> bytes) {
  std::uint64_t sum = bytes.size();
  for (std::size_t i = 0; i < bytes.size(); i += sizeof sum) {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes.data() + i, std::min(sizeof word, bytes.size() - i));
    sum = extend_hash(sum, word);
  }
  return sum;
}

}  // namespace

std::string signed_bytes(const SignedKind& kind, std::string_view rest) {
  ByteWriter head;
  head.number(kind.version);
  head.number(std::uint64_t{0});  // the checksum is set at the end
  std::string bytes;
  bytes.reserve(head_size(kind) + rest.size());
  bytes.append(kind.mark).append(head.bytes()).append(rest);
  sign(kind, bytes);
  return bytes;
}

void sign(const SignedKind& kind, std::string& bytes) {
  if (bytes.size() < head_size(kind)) return;
  const std::uint64_t sum = checksum(std::as_bytes(std::span(bytes)).subspan(head_size(kind)));
  std::memcpy(bytes.data() + head_size(kind) - sizeof sum, &sum, sizeof sum);
}

bool has_mark(const SignedKind& kind, std::span<const std::byte> bytes) {
  return as_characters(bytes).starts_with(kind.mark);
}

ByteReader open_signed(const SignedKind& kind, std::span<const std::byte> bytes, const std::string& name) {
  if (!has_mark(kind, bytes)) throw InputError(name, "not " + std::string(kind.what));
  ByteReader reader(bytes.subspan(kind.mark.size()), name);
  const auto version = reader.number<std::uint32_t>();
  if (version != kind.version) {
    throw InputError(name, std::string(kind.what) + " of version " + std::to_string(version) +
                               "; this program reads version " + std::to_string(kind.version) + ": " +
                               std::string(kind.again));
  }
  const auto sum = reader.number<std::uint64_t>();
  reader.need(sum == checksum(reader.rest()), "the file was changed or cut off since it was written");
  return reader;
}

}  // namespace ligne
