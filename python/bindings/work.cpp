#include "bindings/work.hpp"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>

#include "base/parallel.hpp"
#include "base/stop.hpp"

namespace py = pybind11;

namespace ligne::python {
namespace {

/// Adjustable: interval between checks for signals, short for a user who presses Ctrl-C, long compared to the cost of a
/// check.
constexpr std::chrono::milliseconds kLook{50};

/// The state that the two threads share.
struct Shared {
  std::mutex mutex;
  std::condition_variable changed;
  bool done = false;
  std::exception_ptr failure;
  std::atomic<bool> stop = false;
  std::atomic<double> fraction = 0;
};

/// Runs signal handlers and the callable; returns their exception.
std::optional<py::error_already_set> look(const py::object& progress, double fraction, double& told) {
  try {
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    if (!progress.is_none() && fraction != told) progress(told = fraction);
  } catch (py::error_already_set& raised) {
    return std::move(raised);
  }
  return std::nullopt;
}

}  // namespace

void run(const py::object& progress, unsigned threads, const std::function<void(const Progress&)>& work) {
  Shared shared;
  std::optional<py::error_already_set> raised;
  const Progress report = [&shared](double fraction) {
    shared.fraction = fraction;
    if (shared.stop) throw Stopped();
  };
  {
    const py::gil_scoped_release released;
    std::thread worker([&] {
      try {
        run_with_threads(threads, [&] { run_until(shared.stop, [&] { work(report); }); });
      } catch (...) {
        shared.failure = std::current_exception();
      }
      const std::lock_guard lock(shared.mutex);
      shared.done = true;
      shared.changed.notify_one();
    });
    double told = 0;
    std::unique_lock lock(shared.mutex);
    while (!shared.changed.wait_for(lock, kLook, [&] { return shared.done; })) {
      if (raised) continue;
      lock.unlock();
      {
        const py::gil_scoped_acquire acquired;
        raised = look(progress, shared.fraction, told);
      }
      if (raised) shared.stop = true;
      lock.lock();
    }
    lock.unlock();
    worker.join();
  }
  if (raised) throw std::move(*raised);
  if (shared.failure) std::rethrow_exception(shared.failure);
  if (!progress.is_none() && shared.fraction > 0) progress(1.0);
}

}  // namespace ligne::python
