#include "files/checksummed_file.hpp"

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

std::string checksummed_file(const ChecksummedFormat& format, std::string_view contents) {
  ByteWriter header;
  header.number(format.version);
  header.number(std::uint64_t{0});  // the checksum is set at the end
  std::string bytes;
  bytes.reserve(header_size(format) + contents.size());
  bytes.append(format.magic).append(header.bytes()).append(contents);
  write_checksum(format, bytes);
  return bytes;
}

void write_checksum(const ChecksummedFormat& format, std::string& bytes) {
  if (bytes.size() < header_size(format)) return;
  const std::uint64_t sum = checksum(std::as_bytes(std::span(bytes)).subspan(header_size(format)));
  std::memcpy(bytes.data() + header_size(format) - sizeof sum, &sum, sizeof sum);
}

bool has_magic(const ChecksummedFormat& format, std::span<const std::byte> bytes) {
  return as_characters(bytes).starts_with(format.magic);
}

ByteReader open_checksummed(const ChecksummedFormat& format, std::span<const std::byte> bytes, const std::string& name) {
  if (!has_magic(format, bytes)) throw InputError(name, "not " + std::string(format.name));
  ByteReader reader(bytes.subspan(format.magic.size()), name);
  const auto version = reader.number<std::uint32_t>();
  if (version != format.version) {
    throw InputError(name, std::string(format.name) + " of version " + std::to_string(version) +
                               "; this program reads version " + std::to_string(format.version) + ": " +
                               std::string(format.advice));
  }
  const auto sum = reader.number<std::uint64_t>();
  reader.need(sum == checksum(reader.rest()), "the file was changed or cut off since it was written");
  return reader;
}

}  // namespace ligne
