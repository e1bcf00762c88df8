#pragma once
/// The files that a run reads and writes.

#include <filesystem>
#include <string>
#include <vector>

#include "files/input_file.hpp"
#include "plotting/writers/output_file.hpp"

namespace ligne {

/// The files that a run reads and writes. No file that was read is overwritten, and all written files are moved into place
/// together at the end. Files are compared by identity, not by name.
class RunFiles {
 public:
  /// Registers the output file of an option; empty: none. Throws UsageError if another option names the file too, or if it
  /// was read.
  void will_write(const std::string& option, const std::filesystem::path& file);
  /// Registers files that were read or belong to them. Throws UsageError if one of them is an output file.
  void were_read(const InputFiles& files);
  /// Stores the contents of a file registered with will_write().
  void write(const std::filesystem::path& file, std::string bytes) { outputs_.add(file, std::move(bytes)); }
  /// Moves all files into place.
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
