#pragma once
/// Files that are whole or not there.

#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace ligne {

class TemporaryFile;

/// A file can not be written; what() is "FILE: cause".
class OutputError : public std::runtime_error {
 public:
  OutputError(const std::filesystem::path& file, int error);
  const std::filesystem::path& file() const { return file_; }
  int error() const { return error_; }  ///< as errno has it

 private:
  std::filesystem::path file_;
  int error_;
};

/// The files that a run writes, all or none: each is written beside its target, and when all of them stand there they are
/// renamed. What can not be taken back comes between: standard output ("-"), and devices and pipes, which are written as
/// they are. Every function throws OutputError; what was not put in place then is
/// removed.
class OutputFiles {
 public:
  OutputFiles();
  ~OutputFiles();
  OutputFiles(const OutputFiles&) = delete;
  OutputFiles& operator=(const OutputFiles&) = delete;

  /// Writes the bytes beside the file, or keeps them for what is no regular file.
  void add(const std::filesystem::path& file, std::string bytes);
  /// Puts everything in its place; nothing is left to be written afterwards.
  void commit();

 private:
  struct Beside {
    std::filesystem::path file, target;  ///< as named, and what that leads to
    std::unique_ptr<TemporaryFile> temporary;
  };
  struct InPlace {
    std::filesystem::path file;
    std::string bytes;
  };
  std::vector<Beside> beside_;
  std::vector<InPlace> in_place_;
};

/// Removes what is written but not put in its place, when the program has to end at once: it asks for no memory.
void remove_unfinished_output();

/// One file by itself.
void write_output(const std::filesystem::path& file, std::string bytes);

}  // namespace ligne
