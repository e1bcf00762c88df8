#pragma once
/// Counts what the tests compare: a number of tests alone does not tell how much they look at.

#include <cstdint>

namespace ligne::test {

enum class Check : std::uint8_t {
  drawings,   ///< drawings of a method held against the oracle
  intervals,  ///< intervals of lines on which the oracle's answer was compared with a drawing
  pairs,      ///< drawings held against another drawing, or against known answers
};
inline constexpr int kChecks = 3;

/// May be called from any thread.
void count_checks(Check check, std::uint64_t number = 1);
std::uint64_t checks_made(Check check);

}  // namespace ligne::test
