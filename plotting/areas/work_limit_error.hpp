#pragma once
/// The error for files that ask for too much work. Private to plotting.

#include <stdexcept>

namespace ligne::svg {

/// A file requires too much work, or more memory than there is. The whole file is refused; other faults only drop an
/// element.
struct WorkLimitError : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

}  // namespace ligne::svg
