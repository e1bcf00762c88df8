#pragma once
/// Errors of input.

#include <stdexcept>
#include <string>

#include "files/message_text.hpp"

namespace ligne {

/// The input can not be used. what() is one line of bounded length, "FILE[:LINE]: what is wrong and where".
class InputError : public std::runtime_error {
 public:
  explicit InputError(const std::string& line) : std::runtime_error(message_line(line)) {}
  InputError(const std::string& place, const std::string& cause) : InputError(place + ": " + cause) {}
};

}  // namespace ligne
