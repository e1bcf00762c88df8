#pragma once
/// Work that can be told to end.

#include <atomic>

#include "base/parallel.hpp"

namespace ligne {

/// Thrown by work that was told to end.
struct Stopped {};

/// Calls work(). Once `stop` is true its loops of parallel.hpp throw Stopped, and so does check_stop(), in all threads that
/// work for it; whoever calls this has it thrown. `stop` must outlive the call.
void run_until(const std::atomic<bool>& stop, FunctionRef<void()> work);

/// For long loops of one thread: throws Stopped when the work that calls it is to end.
void check_stop();

/// Has the calling thread work for the same as another one for a while, and checks whether that is to end.
class StopScope {
 public:
  explicit StopScope(const std::atomic<bool>* stop);
  ~StopScope();
  StopScope(const StopScope&) = delete;
  StopScope& operator=(const StopScope&) = delete;

  /// The stop flag of the calling thread's work; null where nobody can tell it to end.
  static const std::atomic<bool>* current();

 private:
  const std::atomic<bool>* before_;
};

}  // namespace ligne
