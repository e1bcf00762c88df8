#pragma once
/// Errors of files that the system does not give.

#include <string>

#include "files/input_error.hpp"

namespace ligne {

/// The system does not give the file.
class FileError : public InputError {
 public:
  FileError(const std::string& file, const std::string& cause, int error)
      : InputError(file, cause), file_(file), error_(error) {}
  const std::string& file() const { return file_; }
  int error() const { return error_; }  ///< as errno has it

 private:
  std::string file_;
  int error_;
};

}  // namespace ligne
