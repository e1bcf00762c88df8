#include "base/parallel.hpp"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>
#include <oneapi/tbb/task_group.h>

#include <atomic>
#include <chrono>
#include <thread>

#include "base/stop.hpp"

namespace ligne {
namespace {

/// Calls work(i) for all i. Every task first checks whether the work was cancelled. Throws Stopped if the caller is part of
/// a loop that ends with an exception: then this one may not have made all calls.
template <class Partitioner>
void loop(std::size_t count, FunctionRef<void(std::size_t)> work, const Partitioner& partitioner) {
  // A single call wakes no other threads: in the study of a small scene they would only look for work.
  if (count == 0) return;
  if (count == 1) {
    const StopScope scope(StopScope::current());
    return work(0);
  }
  const auto task = [work, stop = StopScope::current()](const tbb::blocked_range<std::size_t>& range) {
    const StopScope scope(stop);
    for (std::size_t i = range.begin(); i != range.end(); ++i) work(i);
  };
  tbb::task_group_context context;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count), task, partitioner, context);
  // The exception of a task beside the caller cancels this loop, which then returns before its end.
  if (context.is_group_execution_cancelled()) throw Stopped();
}

}  // namespace

void parallel_for(std::size_t count, FunctionRef<void(std::size_t)> work) { loop(count, work, tbb::auto_partitioner{}); }

void parallel_tasks(std::size_t count, FunctionRef<void(std::size_t)> work) { loop(count, work, tbb::simple_partitioner{}); }

void parallel_tasks_apart(std::size_t count, FunctionRef<void(std::size_t)> work) {
  if (count <= 1) return parallel_tasks(count, work);
  tbb::this_task_arena::isolate([&] { parallel_tasks(count, work); });
}

void parallel_blocks(std::size_t count, std::size_t size, FunctionRef<void(std::size_t, std::size_t)> work) {
  const auto block = [=](std::size_t i) { work(i * size, std::min(count, (i + 1) * size)); };
  loop(block_count(count, size), block, tbb::auto_partitioner{});
}

std::size_t thread_count() { return static_cast<std::size_t>(tbb::this_task_arena::max_concurrency()); }

std::size_t thread_index() { return static_cast<std::size_t>(std::max(0, tbb::this_task_arena::current_thread_index())); }

void start_threads() {
  // Longest time to wait: longer than a busy machine takes to start threads, but not noticeable. Adjustable.
  constexpr std::chrono::milliseconds kPatience{200};
  const std::size_t count = thread_count();
  const auto until = std::chrono::steady_clock::now() + kPatience;
  std::atomic<std::size_t> here = 0;
  parallel_tasks(count, [&](std::size_t) {
    ++here;
    while (here < count && std::chrono::steady_clock::now() < until) std::this_thread::yield();
  });
}

void run_with_threads(unsigned threads, FunctionRef<void()> work) {
  if (threads == 0) {
    // If each calling thread had an arena of its own, the arena would stay until the last worker has left it.
    static tbb::task_arena shared;
    return shared.execute([work] { work(); });
  }
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  tbb::task_arena arena(static_cast<int>(threads));
  arena.execute([work] { work(); });
}

}  // namespace ligne
