#include "base/large_vector.hpp"

#include "base/parallel.hpp"

namespace ligne {
namespace {

/// Size of a page in bytes, or less than it: a write to each such block brings its page in.
constexpr std::size_t kPage = 4096;
/// Number of pages per task. A further thread is worth while from two tasks on. Adjustable.
constexpr std::size_t kPagesPerTask = 512;

}  // namespace

void prefault(void* memory, std::size_t bytes) {
  const std::size_t pages = bytes / kPage;
  if (pages < 2 * kPagesPerTask) return;
  auto* const first = static_cast<volatile unsigned char*>(memory);
  parallel_blocks(pages, kPagesPerTask, [&](std::size_t begin, std::size_t end) {
    for (std::size_t page = begin; page < end; ++page) first[page * kPage] = 0;
  });
}

}  // namespace ligne
