#include "main/checks.hpp"

#include <array>
#include <atomic>

namespace ligne::test {
namespace {

std::array<std::atomic<std::uint64_t>, kChecks> counts;

}  // namespace

void count_checks(Check check, std::uint64_t number) { counts[static_cast<std::size_t>(check)] += number; }

std::uint64_t checks_made(Check check) { return counts[static_cast<std::size_t>(check)]; }

}  // namespace ligne::test
