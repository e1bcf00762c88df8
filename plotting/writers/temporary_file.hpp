#pragma once
/// Files that do not outlive a run which ends before its time. Private to plotting.

#include <filesystem>
#include <string_view>

#include <sys/types.h>

namespace ligne {

struct TemporaryFileEntry;

/// A new file in a folder, removed when this object goes, or when a signal that nobody handles (SIGHUP, SIGINT, SIGTERM)
/// ends the program. Such a signal still ends it, so that whoever started it sees by which.
class TemporaryFile {
 public:
  /// Makes the file. Throws std::system_error.
  TemporaryFile(const std::filesystem::path& folder, mode_t mode);
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  int descriptor() const { return descriptor_; }
  const std::filesystem::path& path() const { return path_; }

  /// Closes the file. Throws std::system_error when the bytes did not all arrive.
  void close();
  /// Gives the closed file another name, of which it takes the place. Throws std::system_error.
  void rename_to(const std::filesystem::path& target);

 private:
  std::filesystem::path path_;
  TemporaryFileEntry* entry_;
  int descriptor_ = -1;
};

/// Removes all temporary files that there are; may be called in a signal handler, before the program ends.
void remove_temporary_files();

}  // namespace ligne
