#pragma once
/// Memory that the work may take, and what is said where that is not enough.

#include <array>
#include <cstddef>
#include <limits>
#include <new>
#include <string>
#include <string_view>

#include "files/message_text.hpp"

namespace ligne {

/// A stage of the work.
struct Stage {
  std::string name;  ///< as the reports name it
  std::string asks;  ///< what it has to do, "12 faces", for the message; may be empty

  Stage(const char* stage) : name(stage) {}
  Stage(std::string stage, std::string has) : name(std::move(stage)), asks(std::move(has)) {}
};

/// There is not enough memory, or not as much as the work may have. It keeps its text in itself: there may be no memory for
/// another.
class MemoryError : public std::bad_alloc {
 public:
  explicit MemoryError(std::string_view text) noexcept;
  const char* what() const noexcept override { return text_.data(); }

 private:
  std::array<char, kLongestMessage + 1> text_{};
};

/// The error of a stage that ran out of memory: the stage, what it asks memory for, and what takes less.
MemoryError out_of_memory(const Stage& stage);

/// "64M", "1.5G": bytes as people write them, in powers of 1024, with three digits.
std::string bytes_text(double bytes);

/// Bytes that the work may take together. What it will need is estimated from below where counts tell it before, so that
/// nothing that would fit is refused; the rest only the allocations themselves can tell.
struct MemoryLimit {
  double bytes = std::numeric_limits<double>::infinity();

  /// Throws MemoryError when the stage can not do with fewer than `least` bytes, and these are too many.
  void require(double least, const Stage& stage) const;
};

}  // namespace ligne
