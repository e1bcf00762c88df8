#pragma once
/// The end of patience with a file. Private to plotting.

#include <stdexcept>

namespace ligne::svg {

/// A file asks for endless work, or for more than fits: it is refused as a whole, where other faults cost an element.
struct EndlessWork : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

}  // namespace ligne::svg
