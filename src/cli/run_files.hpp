#pragma once
/// The files of a run.

#include <filesystem>
#include <string>
#include <vector>

#include "files/input_file.hpp"
#include "plotting/writers/output_file.hpp"

namespace ligne {

/// Knows what a run reads and what it writes: no file that was read is written over, and all that is written comes into its
/// place together, when the work is done. Files are compared by what they are, whatever names lead to them.
class RunFiles {
 public:
  /// The option names a file that will be written; empty: none. Throws UsageError when another option names it too, or when
  /// it was read.
  void will_write(const std::string& option, const std::filesystem::path& file);
  /// Files that were read, or belong to what was read. Throws UsageError when one of them is to be written.
  void were_read(const InputFiles& files);
  /// Bytes of a file of will_write.
  void write(const std::filesystem::path& file, std::string bytes) { outputs_.add(file, std::move(bytes)); }
  /// Puts everything in its place.
  void commit() { outputs_.commit(); }

 private:
  struct Written {
    std::string option;
    std::filesystem::path file;
  };
  std::vector<Written> written_;
  InputFiles read_;
  OutputFiles outputs_;
};

}  // namespace ligne
