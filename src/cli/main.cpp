/// The command `ligne`.

#include <csignal>

#if defined(__GLIBC__)
#include <malloc.h>
#endif

#include "cli/command_line.hpp"

namespace {

/// Keeps freed arrays of up to 32 MB, the most that the C library allows, for the next ones: fresh pages from the system
/// take as long as filling them.
void keep_freed_memory() {
#if defined(__GLIBC__)
  constexpr int kLargestKept = 32 << 20, kMostKept = 64 << 20;  // bytes
  mallopt(M_MMAP_THRESHOLD, kLargestKept);
  mallopt(M_TRIM_THRESHOLD, kMostKept);
#endif
}

}  // namespace

int main(int argc, char** argv) {
  keep_freed_memory();
  // A closed pipe is reported as a write error, not as a signal.
  std::signal(SIGPIPE, SIG_IGN);
  return ligne::run_command_line(argc, argv);
}
