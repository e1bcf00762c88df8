#pragma once
/// Measures the peak memory of a piece of work.

#include <optional>

namespace ligne {

/// The growth of the process's resident memory, from the construction of this object to its peak. Only Linux reports
/// it. Only one object may exist at a time.
class PeakMemory {
 public:
  PeakMemory();
  std::optional<double> bytes() const;

 private:
  std::optional<double> before_;
};

}  // namespace ligne
