#pragma once
/// Errors of the command line.

#include <stdexcept>
#include <string>

namespace ligne {

/// A mistake on the command line: reported in one line on standard error, exit status 2.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
  UsageError(const std::string& option, const std::string& cause) : std::runtime_error(option + ": " + cause) {}
};

}  // namespace ligne
