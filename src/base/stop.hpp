#pragma once
/// Cancellation of work by another thread.

#include <atomic>

#include "base/parallel.hpp"

namespace ligne {

/// Thrown by work that was cancelled.
struct Stopped {};

/// Calls work(). Once `stop` is true, the loops of parallel.hpp and check_stop() throw Stopped in all threads that take
/// part in the work, and this function throws it to its caller. `stop` must outlive the call.
void run_until(const std::atomic<bool>& stop, FunctionRef<void()> work);

/// For long loops of one thread: throws Stopped if the work that calls it was cancelled.
void check_stop();

/// While it exists, the calling thread takes part in the work that `stop` cancels. The constructor throws Stopped if
/// that work was cancelled already.
class StopScope {
 public:
  explicit StopScope(const std::atomic<bool>* stop);
  ~StopScope();
  StopScope(const StopScope&) = delete;
  StopScope& operator=(const StopScope&) = delete;

  /// The stop flag of the work of the calling thread; null if that work can not be cancelled.
  static const std::atomic<bool>* current();

 private:
  const std::atomic<bool>* before_;
};

}  // namespace ligne
