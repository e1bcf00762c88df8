#pragma once
/// A file that is read in place on the disk, not loaded as a whole.

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>

namespace ligne {

/// Pages that were read stay in memory only while there is room, and are released by forget(). The file must not become
/// shorter while it is mapped: the system ends a program that reads beyond its end.
class MappedFile {
 public:
  /// Returns nothing if the path is not a regular file, or the file is empty or can not be opened or mapped. Reading it
  /// normally reports the cause.
  static std::optional<MappedFile> open(const std::filesystem::path& file);
  MappedFile(MappedFile&& other) noexcept;
  MappedFile& operator=(MappedFile&&) = delete;
  ~MappedFile();

  std::span<const std::byte> bytes() const { return bytes_; }

  /// Releases the memory of the pages that lie entirely in [begin, end); they can be read again.
  void forget(std::size_t begin, std::size_t end) const;

 private:
  explicit MappedFile(std::span<const std::byte> bytes) : bytes_(bytes) {}

  std::span<const std::byte> bytes_;
};

}  // namespace ligne
