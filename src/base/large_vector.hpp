#pragma once
/// Vectors so large that to get their memory from the system takes as long as to fill them.

#include <cstddef>
#include <vector>

namespace ligne {

/// Has the pages of memory that was allocated and holds nothing yet brought in, by all threads; small memory is left as
/// it is.
void prefault(void* memory, std::size_t bytes);

/// n values, whose memory all threads have brought in.
template <class T>
std::vector<T> large_vector(std::size_t n) {
  std::vector<T> values;
  values.reserve(n);
  prefault(values.data(), n * sizeof(T));
  values.resize(n);
  return values;
}

}  // namespace ligne
