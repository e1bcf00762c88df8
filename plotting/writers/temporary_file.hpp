#pragma once
/// Temporary files, removed even when a signal ends the program. Private to plotting.

#include <filesystem>

#include <sys/types.h>

namespace ligne {

struct TemporaryFileEntry;

/// A new file in a folder. It is removed with this object, or when a signal that nobody handles (SIGHUP, SIGINT,
/// SIGTERM) ends the program. The program still ends by that signal, so that its parent sees which.
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
  /// Renames the closed file; a file of the new name is replaced. Throws std::system_error.
  void rename_to(const std::filesystem::path& target);

 private:
  std::filesystem::path path_;
  TemporaryFileEntry* entry_;
  int descriptor_ = -1;
};

/// Removes all temporary files that there are; may be called in a signal handler, before the program ends.
void remove_temporary_files();

}  // namespace ligne
