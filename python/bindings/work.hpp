#pragma once
/// Runs interruptible work without the interpreter's lock.

#include <functional>

#include <pybind11/pybind11.h>

namespace ligne::python {

/// Called with the completed fraction; throws to stop the work.
using Progress = std::function<void(double)>;

/// Calls work(progress) in a separate thread, with at most the given number of threads (0: all processors). Meanwhile
/// the calling thread releases the interpreter's lock, checks for signals (Ctrl-C) at intervals, and calls `progress`,
/// a Python callable or None, with the completed fraction. Rethrows exceptions of work(). Exceptions of signal handlers
/// and of the callable are thrown after work() has ended.
void run(const pybind11::object& progress, unsigned threads, const std::function<void(const Progress&)>& work);

}  // namespace ligne::python
