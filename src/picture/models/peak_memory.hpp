#pragma once
/// How much memory a piece of work takes.

#include <optional>

namespace ligne {

/// The most memory that the process held since it was made, beyond what it held then: what the system counts as resident.
/// Where the system does not tell (all but Linux) there is no figure. One at a time.
class PeakMemory {
 public:
  PeakMemory();
  std::optional<double> bytes() const;

 private:
  std::optional<double> before_;
};

}  // namespace ligne
