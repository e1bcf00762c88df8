#pragma once
/// The limit of memory, and the error when it is exceeded.

#include <array>
#include <limits>
#include <new>
#include <optional>
#include <string>
#include <string_view>

#include "files/message_text.hpp"

namespace ligne {

/// A stage of a run.
struct Stage {
  std::string name;  ///< name as in reports
  std::string asks;  ///< amount of work for the message, such as "12 faces"; may be empty

  Stage(const char* stage) : name(stage) {}
  Stage(std::string stage, std::string has) : name(std::move(stage)), asks(std::move(has)) {}
};

/// Out of memory, or above the limit. The text is stored in the object, since there may be no memory to allocate it.
class MemoryError : public std::bad_alloc {
 public:
  explicit MemoryError(std::string_view text) noexcept;
  const char* what() const noexcept override { return text_.data(); }

 private:
  std::array<char, kLongestMessage + 1> text_{};
};

/// Returns the error of a stage that ran out of memory: the stage, its amount of work, and how to make it need less.
MemoryError out_of_memory(const Stage& stage);

/// Returns a number of bytes in powers of 1024 with three digits, such as "64M" or "1.5G".
std::string bytes_text(double bytes);

/// The most bytes that the program may take. Where counts are known beforehand, stages compare a lower bound of their
/// needs with the limit, so that nothing that would fit is refused. Beyond that, only failing allocations stop the
/// program.
struct MemoryLimit {
  double bytes = std::numeric_limits<double>::infinity();

  /// Throws MemoryError if the limit is below `least`, the fewest bytes that the stage needs.
  void require(double least, const Stage& stage) const;
};

/// Measures the peak memory of a piece of work.

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
