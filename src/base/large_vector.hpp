#pragma once
/// Vectors so large that the page faults of fresh memory take as long as filling the vector.

#include <cstddef>
#include <vector>

namespace ligne {

/// Touches the pages of freshly allocated memory with all threads, so that page faults happen in parallel. Does nothing
/// for small sizes. The memory must not hold data yet.
void prefault(void* memory, std::size_t bytes);

/// A vector of n value-initialized elements, whose memory was prefaulted.
template <class T>
std::vector<T> large_vector(std::size_t n) {
  std::vector<T> values;
  values.reserve(n);
  prefault(values.data(), n * sizeof(T));
  values.resize(n);
  return values;
}

}  // namespace ligne
