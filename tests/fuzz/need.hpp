#pragma once
/// Invariants of the fuzzers.

#include <cstdio>
#include <cstdlib>

namespace ligne {

/// Ends the program where an invariant does not hold.
inline void need(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "broken invariant: %s\n", what);
  std::abort();
}

}  // namespace ligne
