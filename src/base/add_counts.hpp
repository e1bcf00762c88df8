#pragma once
/// Sums of structs of counts.

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace ligne {

/// Adds each member of `more` to that of `sum`. All members of `Counts` are of type std::uint64_t.
template <class Counts>
void add_counts(Counts& sum, const Counts& more) {
  using Values = std::array<std::uint64_t, sizeof(Counts) / sizeof(std::uint64_t)>;
  auto values = std::bit_cast<Values>(sum);
  const auto added = std::bit_cast<Values>(more);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] += added[i];
  sum = std::bit_cast<Counts>(values);
}

}  // namespace ligne
