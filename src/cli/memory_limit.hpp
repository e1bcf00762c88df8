#pragma once
/// The memory limit of a command and its enforcement.

#include <cstdint>
#include <filesystem>
#include <optional>

#include "base/parallel.hpp"
#include "picture/models/memory.hpp"

namespace ligne {

/// The memory limit of this process's control groups, version 1 or 2; empty if there is none. `root` is prepended to /proc
/// and /sys.
std::optional<std::uint64_t> group_memory(const std::filesystem::path& root = "/");

/// Three quarters of the memory of the machine and of this process's control group.
MemoryLimit usual_memory_limit();

/// Calls work() with at most `threads` threads (0: one per processor) and at most `limit` of memory. Throws MemoryError with
/// the limit if the memory does not suffice. If the exception can not propagate, as from a destructor in a library, the
/// program ends with one line and exit status 1. Calls must not overlap: limit and handlers belong to the process.
void run_within(const MemoryLimit& limit, unsigned threads, FunctionRef<void()> work);

/// Throws MemoryError if memory ran out at any time, even if the work continued: a library may have omitted something.
void check_memory_sufficed();

}  // namespace ligne
