#pragma once
/// Work without the interpreter's lock, that can be interrupted.

#include <functional>

#include <pybind11/pybind11.h>

namespace ligne::python {

/// Called with the fraction done; throws when the work is to end.
using Progress = std::function<void(double)>;

/// Calls work(progress) in a thread of its own, with so many threads at the most (0: all processors), while the calling
/// thread gives up the interpreter's lock and looks every now and then for signals (Ctrl-C) and calls `progress`, a Python
/// callable or None, with the fraction done. What work() throws is thrown here; so is what a signal handler or the callable
/// raises, after work() has come to an end.
void run(const pybind11::object& progress, unsigned threads, const std::function<void(const Progress&)>& work);

}  // namespace ligne::python
