#pragma once
/// Archives of one file, and files of data that are known and not read.

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ligne {

/// The most bytes that an archive is unpacked to.
inline constexpr std::size_t kMostUnpacked = std::size_t{1} << 30;

struct UnpackedFile {
  std::vector<std::byte> bytes;
  std::string name;  ///< that of the file within, as far as it is known
};

/// The file in a gzip archive, or in a ZIP archive of one file; nothing for other bytes. Throws InputError for a damaged
/// archive, for one of several files, and for more than kMostUnpacked bytes.
std::optional<UnpackedFile> unpacked(std::span<const std::byte> bytes, const std::string& name);

/// Bytes of zlib's format, as MATLAB has them within its files. Throws InputError.
std::vector<std::byte> inflated(std::span<const std::byte> bytes, const std::string& name);

/// "is an HDF5 file, which is not read: ..." for known files that hold no text; nothing for others.
std::optional<std::string> data_stranger(std::string_view bytes);

}  // namespace ligne
