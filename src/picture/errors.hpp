#pragma once
/// The exception for requests that can not be served.

#include <stdexcept>
#include <string>

namespace ligne {

/// A request that can not be served: a value that is invalid for this scene, or two values that contradict each other.
/// `field` is the name of the command line option without its dashes ("hatch-spacing"), or empty if no single option is
/// the cause.
class RequestError : public std::runtime_error {
 public:
  RequestError(std::string field, const std::string& cause)
      : std::runtime_error(field.empty() ? cause : field + ": " + cause), field_(std::move(field)) {}
  const std::string& field() const { return field_; }

 private:
  std::string field_;
};

/// A parameter of methods that the method does not have, or whose value it does not accept. The field is its name.
class SettingError : public RequestError {
 public:
  using RequestError::RequestError;
};

}  // namespace ligne
