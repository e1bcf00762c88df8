#pragma once
/// A drawing's pixels against a z-buffer.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "picture/z_buffer.hpp"

namespace ligne::test {

/// Dark pixels of a drawing, kWidth x kHeight; 1 where the paper is more than half covered.
using Ink = std::vector<std::uint8_t>;

/// Throws std::runtime_error when the file is no PNG of that size.
Ink read_ink(const std::filesystem::path& png);

struct Disagreement {
  std::size_t ink = 0, jumps = 0;  ///< pixels looked at
  std::size_t stray = 0;           ///< dark pixels that have no line near them
  std::size_t missing = 0;         ///< strong jumps that have no ink near them
  Pixel first_stray, first_missing;

  bool none() const { return ink > 0 && jumps > 0 && stray == 0 && missing == 0; }
  std::string words() const;
};

Disagreement compare(const Ink& ink, const ZBuffer& picture);

}  // namespace ligne::test
