#pragma once
/// A file whose bytes are looked at where they stand on the disk, and not read as a whole.

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>

#include "files/input_error.hpp"

namespace ligne {

/// Pages that were looked at stay in memory only as long as there is room, and after forget() not even that. A file must not
/// become shorter while it is mapped: the system ends a program that looks at what is no longer there.
class MappedFile {
 public:
  /// Nothing for what is no file, is empty, or can not be opened or mapped: reading it says why.
  static std::optional<MappedFile> open(const std::filesystem::path& file);
  MappedFile(MappedFile&& other) noexcept;
  MappedFile& operator=(MappedFile&&) = delete;
  ~MappedFile();

  std::span<const std::byte> bytes() const { return bytes_; }

  /// Gives back the memory of the pages that lie wholly in [begin, end); they can be looked at again.
  void forget(std::size_t begin, std::size_t end) const;

 private:
  explicit MappedFile(std::span<const std::byte> bytes) : bytes_(bytes) {}

  std::span<const std::byte> bytes_;
};

}  // namespace ligne
