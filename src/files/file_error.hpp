#pragma once
/// Errors of files that the system can not open or read.

#include <string>

#include "files/input_error.hpp"

namespace ligne {

/// Thrown if the system can not open or read the file.
class FileError : public InputError {
 public:
  FileError(const std::string& file, const std::string& cause, int error)
      : InputError(file, cause), file_(file), error_(error) {}
  const std::string& file() const { return file_; }
  int error() const { return error_; }  ///< number as in errno

 private:
  std::string file_;
  int error_;
};

}  // namespace ligne
