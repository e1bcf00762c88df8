#pragma once
/// Errors of a request.

#include <stdexcept>
#include <string>

namespace ligne {

/// A request that can not be served: a value that has no meaning for this scene, or two that do not go together. `field` is
/// the name of the command line's option without its dashes ("hatch-spacing"); empty where none is to blame.
class RequestError : public std::runtime_error {
 public:
  RequestError(std::string field, const std::string& cause)
      : std::runtime_error(field.empty() ? cause : field + ": " + cause), field_(std::move(field)) {}
  const std::string& field() const { return field_; }

 private:
  std::string field_;
};

}  // namespace ligne
