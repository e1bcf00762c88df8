// The kernel keeps the limit: what a process may map for itself alone and write to is bounded (RLIMIT_DATA), so that the
// allocation that goes past it fails, in whatever stage, thread or library, and becomes a std::bad_alloc or that library's
// own error. Counting by an operator new of ours would not see the libraries, and looking at the memory in use now and then
// would come too late.
//
// - Threads are started before: their stacks count, and oneTBB can not go on where a thread can not be started.
// - The first failure gives back some of what is withheld: destructors and handlers on the way out need a little memory, and
//   tasks in other threads come to their end.

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
#include <utility>

#include <sys/resource.h>
#include <unistd.h>

#include "plotting/writers/output_file.hpp"

namespace ligne {
namespace {

namespace fs = std::filesystem;

// Adjustable.
constexpr double kUsualPart = 0.75;  ///< of the machine
/// The reserve given back when memory runs out, and how often: a stage may try again with less, and only then fail.
constexpr double kReservePart = 1.0 / 8;
constexpr rlim_t kReserve = rlim_t{16} << 20;
constexpr int kReserves = 2;

constexpr double kKilo = 1024;

/// The state that the handlers know; written before they stand.
struct Shortage {
  std::atomic<int> reserves_left = 0;
  std::atomic<bool> happened = false;
  rlim_t reserve = 0;
  std::array<char, kLongestMessage> line{};  ///< for an end without a way out
};
Shortage& shortage() {
  static Shortage instance;
  return instance;
}

/// As std::new_handler: throws.
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

/// As std::terminate_handler: an exception that could not come through, as from a destructor.
[[noreturn]] void on_no_way_out() {
  if (!for_want_of_memory()) std::abort();
  static std::atomic_flag ending;
  while (ending.test_and_set()) ::pause();  // another thread ends the program
  remove_unfinished_output();
  const char* const line = shortage().line.data();
  static_cast<void>(!::write(STDERR_FILENO, line, std::strlen(line)));
  ::_exit(EXIT_FAILURE);
}

/// Bytes that count for RLIMIT_DATA now; nothing where the system does not tell.
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

/// While it lives, allocations past the limit fail.
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

/// The number in a file of a control group; "max" is none.
std::optional<std::uint64_t> number_in(const fs::path& file) {
  std::ifstream in(file);
  std::uint64_t number = 0;
  return in >> number ? std::optional(number) : std::nullopt;
}

/// A group may not take more than those that it is part of.
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
      // The message of a part of the program that made do without the memory.
      if (!shortage().happened) throw;
      throw MemoryError(with_limit((std::string("not enough memory: ") + error.what()).c_str(), limit));
    }
  });
}

}  // namespace ligne
