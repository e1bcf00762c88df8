#pragma once
/// Output files, written completely or not at all.

#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace ligne {

class TemporaryFile;

/// A file can not be written; what() is "FILE: cause".
class OutputError : public std::runtime_error {
 public:
  OutputError(const std::filesystem::path& file, int error);
  const std::filesystem::path& file() const { return file_; }
  int error() const { return error_; }  ///< value of errno

 private:
  std::filesystem::path file_;
  int error_;
};

/// The files that a run writes: all or none. Each is written to a temporary file in the directory of its target. When
/// all are complete, standard output ("-"), devices and pipes are written, since they can not be undone, and then the
/// temporary files are renamed. Every function may throw OutputError; the remaining temporary files are then removed.
class OutputFiles {
 public:
  OutputFiles();
  ~OutputFiles();
  OutputFiles(const OutputFiles&) = delete;
  OutputFiles& operator=(const OutputFiles&) = delete;

  /// Writes the bytes to a temporary file; if the target is not a regular file, keeps them in memory.
  void add(const std::filesystem::path& file, std::string bytes);
  /// Renames all temporary files to their targets, after the kept bytes were written.
  void commit();

 private:
  struct Beside {
    std::filesystem::path file, target;  ///< the name that was given; the file to which its links lead
    std::unique_ptr<TemporaryFile> temporary;
  };
  struct InPlace {
    std::filesystem::path file;
    std::string bytes;
  };
  std::vector<Beside> beside_;
  std::vector<InPlace> in_place_;
};

/// Removes all temporary files when the program must end at once. It allocates no memory.
void remove_unfinished_output();

/// Writes a single file.
void write_output(const std::filesystem::path& file, std::string bytes);

}  // namespace ligne
