#pragma once
/// Loops over several threads. Every result is the same whatever the number of threads: work is given out by index, and
/// each index writes to places of its own. The threads are those of the caller's oneTBB arena; this header keeps oneTBB's
/// own headers, which take seconds to compile, out of all sources but one.

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

/// A callable that is borrowed for the time of a call: two pointers, no copy. It must outlive the reference.
template <class Result, class... Arguments>
class FunctionRef<Result(Arguments...)> {
 public:
  template <class Callable>
  requires(!std::is_same_v<std::remove_cvref_t<Callable>, FunctionRef>)
      FunctionRef(Callable&& callable)  // a lambda is handed over as it is
      : object_(const_cast<void*>(static_cast<const void*>(std::addressof(callable)))),
        call_([](void* object, Arguments... arguments) -> Result {
          return (*static_cast<std::remove_reference_t<Callable>*>(object))(arguments...);
        }) {}
  Result operator()(Arguments... arguments) const { return call_(object_, arguments...); }

 private:
  void* object_;
  Result (*call_)(void*, Arguments...);
};

/// Calls work(i) for all i in [0, count). Neighbouring indices may share a task.
void parallel_for(std::size_t count, FunctionRef<void(std::size_t)> work);

/// parallel_for() for few indices whose work is long and uneven: each is a task of its own.
void parallel_tasks(std::size_t count, FunctionRef<void(std::size_t)> work);

/// Calls work(begin, end) for the blocks [0, size), [size, 2 size), ... of [0, count); the last may be shorter. The blocks
/// do not depend on the number of threads. `size` is above 0.
void parallel_blocks(std::size_t count, std::size_t size, FunctionRef<void(std::size_t, std::size_t)> work);

/// Adjustable: sizes of blocks where the work on an index is short, as on a vertex or a triangle, and where it is a search.
inline constexpr std::size_t kShortWorkBlock = 16'384, kSearchBlock = 256;

/// Number of blocks of parallel_blocks(); the block that begins at `begin` has the number begin / size.
inline std::size_t block_count(std::size_t count, std::size_t size) { return (count + size - 1) / size; }

/// The results of work(begin, end) for the blocks, added to `sum` from the first to the last.
template <class Sum, class Work, class Add = std::plus<>>
Sum parallel_reduce(std::size_t count, std::size_t size, Sum sum, Work work, Add add = {}) {
  std::vector<Sum> parts(block_count(count, size), sum);
  parallel_blocks(count, size, [&](std::size_t begin, std::size_t end) { parts[begin / size] = work(begin, end); });
  for (const Sum& part : parts) sum = add(sum, part);
  return sum;
}

/// Number of threads at the most, and the number of the calling one among them: for memory that each thread keeps.
std::size_t thread_count();
std::size_t thread_index();

/// Has all threads of the arena at work once, so that none is started later; gives up when some do not come.
void start_threads();

/// Calls work() with so many threads at the most; 0: as many as there are processors.
void run_with_threads(unsigned threads, FunctionRef<void()> work);

/// Sorts a range of random access. Elements that are alike in `less` may change places, in the same way for any number of
/// threads. O(n log n).
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
