#pragma once
/// Entries of a ZIP archive in memory: stored or deflated, with or without the fields of ZIP64.

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ligne {

struct ZipEntry {
  std::string name{};  ///< with / between folders
  std::uint16_t method = 0;
  std::uint64_t packed = 0, size = 0, header = 0;  ///< size in the archive, size of the entry, offset of its own header
  bool is_encrypted = false;
};

class ZipArchive {
 public:
  /// Reads the directory at the archive's end. `bytes` must outlive this object. Throws InputError with `name`.
  ZipArchive(std::span<const std::byte> bytes, std::string name);

  const std::vector<ZipEntry>& entries() const { return entries_; }
  /// The entry with this name in any case of letters; null if there is none.
  const ZipEntry* find(std::string_view name) const;
  /// The contents of an entry. Never allocates more memory than its bytes in the archive can expand to. Throws
  /// InputError.
  std::vector<std::byte> read(const ZipEntry& entry) const;

 private:
  std::uint64_t number(std::uint64_t at, int bytes) const;
  void read_directory();
  void read_entry(std::uint64_t& at);
  [[noreturn]] void fail(const std::string& cause) const;

  std::span<const std::byte> bytes_;
  std::string name_;
  std::vector<ZipEntry> entries_;
};

}  // namespace ligne
