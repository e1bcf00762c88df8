// The kernel enforces the limit: RLIMIT_DATA bounds the private writable memory of the process. The allocation that exceeds
// it fails in whatever stage, thread or library, and becomes a std::bad_alloc or an error of that library. Counting in an
// operator new of our own would miss the libraries, and polling the memory in use would react too late.
//
// - Threads start before the limit is set: their stacks count, and oneTBB can not continue if a thread can not be started.
// - The first failures release a reserve: destructors, handlers and tasks in other threads need some memory to finish.

#include "cli/memory_limit.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <fstream>
#include <new>

#include <sys/resource.h>
#include <unistd.h>

#include "plotting/writers/output_file.hpp"

namespace ligne {
namespace {

namespace fs = std::filesystem;

// Settings.
constexpr double kUsualPart = 0.75;  ///< part of the machine's memory
/// The reserve added to the limit when memory runs out: a part of the limit, plus bytes; and how often it is added. A stage
/// may retry with less memory before the command fails.
constexpr double kReservePart = 1.0 / 8;
constexpr rlim_t kReserve = rlim_t{16} << 20;
constexpr int kReserves = 2;

constexpr double kKilo = 1024;

/// State of the handlers; set before they are installed.
struct Shortage {
  std::atomic<int> reserves_left = 0;
  std::atomic<bool> happened = false;
  rlim_t reserve = 0;
  std::array<char, kLongestMessage> line{};  ///< message printed if the exception can not propagate
};
Shortage& shortage() {
  static Shortage instance;
  return instance;
}

/// The std::new_handler. It throws.
void on_no_memory() {
  Shortage& state = shortage();
  state.happened = true;
  rlimit now{};
  if (state.reserves_left.fetch_sub(1) > 0 && ::getrlimit(RLIMIT_DATA, &now) == 0) {
    now.rlim_cur = std::min(now.rlim_max, now.rlim_cur + state.reserve);
    static_cast<void>(::setrlimit(RLIMIT_DATA, &now));
  }
  throw std::bad_alloc();
}

bool for_want_of_memory() {
  if (shortage().happened) return true;
  if (!std::current_exception()) return false;
  try {
    throw;
  } catch (const std::bad_alloc&) {
    return true;
  } catch (...) {
    return false;
  }
}

/// The std::terminate_handler, for an exception that can not propagate, as from a destructor.
[[noreturn]] void on_no_way_out() {
  if (!for_want_of_memory()) std::abort();
  static std::atomic_flag ending;
  while (ending.test_and_set()) ::pause();  // another thread ends the program
  remove_unfinished_output();
  const char* const line = shortage().line.data();
  static_cast<void>(!::write(STDERR_FILENO, line, std::strlen(line)));
  ::_exit(EXIT_FAILURE);
}

/// Bytes that currently count for RLIMIT_DATA; empty if the system does not report them.
std::optional<std::uint64_t> data_in_use() {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    std::uint64_t kilobytes = 0;
    if (word == "VmData:" && status >> kilobytes) return kilobytes * static_cast<std::uint64_t>(kKilo);
  }
  return std::nullopt;
}

std::string with_limit(const char* text, const MemoryLimit& limit) {
  return std::isfinite(limit.bytes) ? text + (" (--max-memory is " + bytes_text(limit.bytes)) + ")" : text;
}

/// Enforces the limit during its lifetime: allocations beyond it fail.
class LimitInForce {
 public:
  explicit LimitInForce(const MemoryLimit& limit);
  ~LimitInForce();
  LimitInForce(const LimitInForce&) = delete;
  LimitInForce& operator=(const LimitInForce&) = delete;

 private:
  bool is_set_ = false;
  rlimit before_{};
  std::new_handler new_handler_ = nullptr;
  std::terminate_handler terminate_handler_ = nullptr;
};

LimitInForce::LimitInForce(const MemoryLimit& limit) {
  const std::optional<std::uint64_t> in_use = data_in_use();
  Shortage& state = shortage();
  state.happened = false;
  if (!std::isfinite(limit.bytes) || !in_use || ::getrlimit(RLIMIT_DATA, &before_) != 0) return;
  is_set_ = true;
  const std::string line = "ligne: " + with_limit("not enough memory", limit) + "\n";
  std::memcpy(state.line.data(), line.data(), std::min(line.size(), state.line.size() - 1));
  state.reserve = kReserve + static_cast<rlim_t>(limit.bytes * kReservePart);
  state.reserves_left = kReserves;
  new_handler_ = std::set_new_handler(on_no_memory);
  terminate_handler_ = std::set_terminate(on_no_way_out);
  const double wanted = static_cast<double>(*in_use) + limit.bytes;
  if (wanted >= static_cast<double>(before_.rlim_cur)) return;
  rlimit lower = before_;
  lower.rlim_cur = static_cast<rlim_t>(wanted);
  static_cast<void>(::setrlimit(RLIMIT_DATA, &lower));
}

LimitInForce::~LimitInForce() {
  if (!is_set_) return;
  static_cast<void>(::setrlimit(RLIMIT_DATA, &before_));
  std::set_new_handler(new_handler_);
  std::set_terminate(terminate_handler_);
}

/// The number in a file of a control group; empty for "max", which means no limit.
std::optional<std::uint64_t> number_in(const fs::path& file) {
  std::ifstream in(file);
  std::uint64_t number = 0;
  return in >> number ? std::optional(number) : std::nullopt;
}

/// Lowers `least` to the limits of the group and of all groups that contain it.
void lower_to_groups(std::optional<std::uint64_t>& least, const fs::path& base, fs::path group, const char* name) {
  for (group = group.relative_path();; group = group.parent_path()) {
    const std::optional<std::uint64_t> most = number_in(base / group / name);
    if (most && (!least || *most < *least)) least = most;
    if (group.empty()) return;
  }
}

}  // namespace

std::optional<std::uint64_t> group_memory(const fs::path& root) {
  std::optional<std::uint64_t> least;
  std::ifstream groups(root / "proc/self/cgroup");
  // "NUMBER:CONTROLLERS:GROUP"; version 2 names no controllers.
  for (std::string line; std::getline(groups, line);) {
    const std::size_t first = line.find(':'), second = line.find(':', first + 1);
    if (first == std::string::npos || second == std::string::npos) continue;
    const std::string controllers = "," + line.substr(first + 1, second - first - 1) + ",";
    const fs::path group = line.substr(second + 1);
    if (controllers == ",,") {
      lower_to_groups(least, root / "sys/fs/cgroup", group, "memory.max");
    } else if (controllers.find(",memory,") != std::string::npos) {
      lower_to_groups(least, root / "sys/fs/cgroup/memory", group, "memory.limit_in_bytes");
    }
  }
  return least;
}

MemoryLimit usual_memory_limit() {
  MemoryLimit limit;
  const long pages = ::sysconf(_SC_PHYS_PAGES), page = ::sysconf(_SC_PAGESIZE);
  if (pages > 0 && page > 0) limit.bytes = static_cast<double>(pages) * static_cast<double>(page);
  if (const auto group = group_memory()) limit.bytes = std::min(limit.bytes, static_cast<double>(*group));
  limit.bytes *= kUsualPart;
  return limit;
}

void check_memory_sufficed() {
  if (shortage().happened) throw MemoryError("not enough memory");
}

void run_within(const MemoryLimit& limit, unsigned threads, FunctionRef<void()> work) {
  run_with_threads(threads, [&] {
    try {
      start_threads();
      const LimitInForce in_force(limit);
      work();
    } catch (const MemoryError& error) {
      throw MemoryError(with_limit(error.what(), limit));
    } catch (const std::bad_alloc&) {
      throw MemoryError(with_limit("not enough memory", limit));
    } catch (const std::length_error&) {
      throw MemoryError(with_limit("not enough memory", limit));
    } catch (const std::exception& error) {
      // The error of a library that failed for lack of memory.
      if (!shortage().happened) throw;
      throw MemoryError(with_limit((std::string("not enough memory: ") + error.what()).c_str(), limit));
    }
  });
}

}  // namespace ligne
