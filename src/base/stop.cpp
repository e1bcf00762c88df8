#include "base/stop.hpp"

namespace ligne {
namespace {

thread_local const std::atomic<bool>* current_stop = nullptr;

}  // namespace

StopScope::StopScope(const std::atomic<bool>* stop) : before_(current_stop) {
  if (stop && stop->load(std::memory_order_relaxed)) throw Stopped();
  current_stop = stop;
}

StopScope::~StopScope() { current_stop = before_; }

const std::atomic<bool>* StopScope::current() { return current_stop; }

void run_until(const std::atomic<bool>& stop, FunctionRef<void()> work) {
  const StopScope scope(&stop);
  work();
}

void check_stop() {
  if (current_stop && current_stop->load(std::memory_order_relaxed)) throw Stopped();
}

}  // namespace ligne
