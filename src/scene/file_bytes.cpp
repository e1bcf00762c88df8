#include "scene/file_bytes.hpp"

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <system_error>

#include "scene/diagnostics.hpp"

namespace ligne {
namespace {

namespace fs = std::filesystem;

/// More than any model whose corners 32-bit indices can number takes in a binary format, and any grid that memory holds.
constexpr std::uintmax_t kLargestFile = std::uintmax_t{1} << 36;

}  // namespace

std::vector<std::byte> read_bytes(const std::filesystem::path& file, const std::string& name) {
  std::error_code failure;
  const fs::file_status status = fs::status(file, failure);
  if (!fs::exists(status)) {
    const bool absent = failure == std::errc::no_such_file_or_directory || failure == std::errc::not_a_directory;
    if (failure && !absent) throw InputError(name, failure.message());
    throw InputError(name, "there is no such file");
  }
  if (fs::is_directory(status)) throw InputError(name, "is a directory, not a file");
  std::ifstream in(file, std::ios::binary);
  if (!in) throw InputError(name, "can not be opened for reading");

  std::vector<std::byte> bytes;
  if (fs::is_regular_file(status)) {
    const std::uintmax_t size = fs::file_size(file, failure);
    if (!failure && size > kLargestFile) throw InputError(name, "is larger than 64 GiB");
    if (!failure) bytes.reserve(static_cast<std::size_t>(size) + 1);
  }
  // Read in pieces: what stands in /proc or comes through a pipe has no size.
  constexpr std::size_t kPiece = std::size_t{1} << 20;
  while (in) {
    const std::size_t begin = bytes.size();
    bytes.resize(std::max(std::min(begin + kPiece, bytes.capacity()), begin + 1));
    in.read(reinterpret_cast<char*>(bytes.data() + begin), static_cast<std::streamsize>(bytes.size() - begin));
    bytes.resize(begin + static_cast<std::size_t>(in.gcount()));
  }
  if (in.bad()) throw InputError(name, "can not be read to its end");
  return bytes;
}

}  // namespace ligne
