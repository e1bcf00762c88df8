#pragma once
/// Archives of one file, and data files that are recognised but not read.

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ligne {

/// Largest number of bytes that an archive is unpacked to.
inline constexpr std::size_t kMostUnpacked = std::size_t{1} << 30;

struct UnpackedFile {
  std::vector<std::byte> bytes;
  std::string name;  ///< name of the file within, if known
};

/// The file in a gzip archive, or in a ZIP archive of one file; nothing for other bytes. Throws InputError for a
/// damaged archive, for one with several files, and for more than kMostUnpacked bytes.
std::optional<UnpackedFile> unpacked(std::span<const std::byte> bytes, const std::string& name);

/// Unpacks zlib's format, which MATLAB uses within its files. Throws InputError.
std::vector<std::byte> inflated(std::span<const std::byte> bytes, const std::string& name);

/// An error text such as "is an HDF5 file, which is not read: ..." for known files without text; nothing for others.
std::optional<std::string> foreign_data_format(std::string_view bytes);

}  // namespace ligne
