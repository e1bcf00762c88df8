#pragma once
/// How much memory a command may take, and how that is kept.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "base/parallel.hpp"
#include "picture/models/memory.hpp"

namespace ligne {

/// The memory that the control groups of this process, of version 1 or 2, may take; nothing where they are not limited.
/// `root` stands in front of /proc and /sys.
std::optional<std::uint64_t> group_memory(const std::filesystem::path& root = "/");

/// Three quarters of what the machine and the control group of this process have.
MemoryLimit usual_memory_limit();

/// Calls work() with so many threads at the most (0: as many as there are processors) that may not take more memory than
/// the limit. Where that is not enough a MemoryError says so, with the limit; and where it can not come through, as out of
/// the destructor of a library, the program ends at once with one line and exit status 1. To be called once, and by a
/// program only: the limit and the handlers are those of the process, and they stay.
void run_within(const MemoryLimit& limit, unsigned threads, FunctionRef<void()> work);

/// Throws MemoryError when memory ran out at any time, though the work went on: a library may have made do without what it
/// asked for, and left something out.
void check_memory_sufficed();

}  // namespace ligne
