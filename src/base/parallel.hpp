#pragma once
/// Parallel loops. Results must not depend on the number of threads: the work is divided by index, and the work on an
/// index writes only to its own memory. The threads are those of the caller's oneTBB arena. The headers of oneTBB take
/// seconds to compile, so only the source of this header includes them.

#include <algorithm>
#include <cstddef>
#include <functional>
#include <iterator>
#include <memory>
#include <type_traits>
#include <vector>

namespace ligne {

template <class Signature>
class FunctionRef;

/// A non-owning reference to a callable: two pointers, no copy. The callable must outlive the reference.
template <class Result, class... Arguments>
class FunctionRef<Result(Arguments...)> {
 public:
  template <class Callable>
  requires(!std::is_same_v<std::remove_cvref_t<Callable>, FunctionRef>)
      FunctionRef(Callable&& callable)  // implicit, so that a lambda can be passed directly
      : object_(const_cast<void*>(static_cast<const void*>(std::addressof(callable)))),
        call_([](void* object, Arguments... arguments) -> Result {
          return (*static_cast<std::remove_reference_t<Callable>*>(object))(arguments...);
        }) {}
  Result operator()(Arguments... arguments) const { return call_(object_, arguments...); }

 private:
  void* object_;
  Result (*call_)(void*, Arguments...);
};

/// Calls work(i) for all i in [0, count). Consecutive indices may share a task. Throws what work() throws. A call from
/// within a task also throws Stopped (stop.hpp), if another task of that loop has thrown or the work was cancelled. Some
/// calls of work() are not made then.
void parallel_for(std::size_t count, FunctionRef<void(std::size_t)> work);

/// parallel_for() for few indices with long and uneven work: each index is a separate task.
void parallel_tasks(std::size_t count, FunctionRef<void(std::size_t)> work);

/// parallel_tasks() for a call from within a task: while it waits, the calling thread runs only tasks of this call.
void parallel_tasks_apart(std::size_t count, FunctionRef<void(std::size_t)> work);

/// Calls work(begin, end) for the blocks [0, size), [size, 2 size), ... of [0, count); the last may be shorter. The
/// blocks do not depend on the number of threads. `size` must be positive.
void parallel_blocks(std::size_t count, std::size_t size, FunctionRef<void(std::size_t, std::size_t)> work);

/// Block sizes, in indices. kShortWorkBlock is for short work per index, such as on a vertex or a triangle;
/// kSearchBlock is for a search per index. Adjustable.
inline constexpr std::size_t kShortWorkBlock = 4096, kSearchBlock = 256;

/// Number of blocks of parallel_blocks(); the block that begins at `begin` has the number begin / size.
inline std::size_t block_count(std::size_t count, std::size_t size) { return (count + size - 1) / size; }

/// Calls work(begin, end) for the blocks of `size` indices in parallel, and adds the results to `sum` in the order of
/// the blocks.
template <class Sum, class Work, class Add = std::plus<>>
Sum parallel_reduce(std::size_t count, std::size_t size, Sum sum, Work work, Add add = {}) {
  std::vector<Sum> parts(block_count(count, size), sum);
  parallel_blocks(count, size, [&](std::size_t begin, std::size_t end) { parts[begin / size] = work(begin, end); });
  for (const Sum& part : parts) sum = add(sum, part);
  return sum;
}

/// Largest number of threads, and the index of the calling thread, in [0, thread_count()). For memory that each thread
/// owns.
std::size_t thread_count();
std::size_t thread_index();

/// Starts all threads of the arena, so that no later loop has to. Waits for them at most a fifth of a second.
void start_threads();

/// Calls work() with at most `threads` threads; 0: as many as there are processors.
void run_with_threads(unsigned threads, FunctionRef<void()> work);

/// Sorts a random access range. The sort is not stable, but the order of equivalent elements is the same for any number
/// of threads. O(n log n).
template <class Iterator, class Less = std::less<>>
void parallel_sort(Iterator begin, Iterator end, Less less = {}) {
  constexpr std::size_t kShort = 4096, kRuns = 16;
  const auto count = static_cast<std::size_t>(std::distance(begin, end));
  if (count < kShort) {
    std::sort(begin, end, less);
    return;
  }
  const auto at = [&](std::size_t run) { return begin + static_cast<std::ptrdiff_t>(count * run / kRuns); };
  parallel_for(kRuns, [&](std::size_t run) { std::sort(at(run), at(run + 1), less); });
  for (std::size_t merged = 1; merged < kRuns; merged *= 2) {
    parallel_for(kRuns / (2 * merged), [&](std::size_t pair) {
      const std::size_t first = pair * 2 * merged;
      std::inplace_merge(at(first), at(first + merged), at(first + 2 * merged), less);
    });
  }
}

}  // namespace ligne
