// A signal handler can walk the list of all temporary files: entries are added and reused, never freed, and the flags
// that say whether one is in use are atomic. An entry is made before its file and stays until the file is gone, so that
// no signal comes in between. Names are random enough that an entry never names the file of another program.

#include "plotting/writers/temporary_file.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <climits>
#include <csignal>
#include <mutex>
#include <random>
#include <string>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

namespace ligne {

struct TemporaryFileEntry {
  using Entry = TemporaryFileEntry;
  std::atomic<bool> taken = false, named = false;
  std::array<char, PATH_MAX> name{};
  Entry* next = nullptr;

  static std::atomic<Entry*> first;

  /// Unlinks every file. It calls only functions that a signal handler may call.
  static void remove_all() {
    for (const Entry* entry = first; entry; entry = entry->next) {
      if (entry->named) ::unlink(entry->name.data());
    }
  }
  static Entry* take() {
    for (Entry* entry = first; entry; entry = entry->next) {
      if (!entry->taken.exchange(true)) return entry;
    }
    auto* const entry = new Entry;
    entry->taken = true;
    entry->next = first;
    while (!first.compare_exchange_weak(entry->next, entry)) {
    }
    return entry;
  }
  void give_back() {
    named = false;
    taken = false;
  }
};

std::atomic<TemporaryFileEntry*> TemporaryFileEntry::first = nullptr;

namespace {

static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<void*>::is_always_lock_free);

constexpr std::array kSignals{SIGHUP, SIGINT, SIGTERM};

extern "C" void remove_files_and_end(int signal) {
  TemporaryFileEntry::remove_all();
  std::signal(signal, SIG_DFL);
  // The signal is blocked while its handler runs. Unblocked, it ends the program here, before anything goes on without
  // its files.
  sigset_t self;
  sigemptyset(&self);
  sigaddset(&self, signal);
  ::pthread_sigmask(SIG_UNBLOCK, &self, nullptr);
  ::raise(signal);
}

/// Installs signal handlers while there are temporary files, and only for signals that the program itself does not
/// handle.
class Handlers {
 public:
  void need() {
    const std::lock_guard lock(mutex_);
    if (users_++ > 0) return;
    for (std::size_t i = 0; i < kSignals.size(); ++i) {
      struct sigaction old {};
      installed_[i] = ::sigaction(kSignals[i], nullptr, &old) == 0 && old.sa_handler == SIG_DFL &&
                      std::signal(kSignals[i], remove_files_and_end) != SIG_ERR;
    }
  }
  void let_go() {
    const std::lock_guard lock(mutex_);
    if (--users_ > 0) return;
    for (std::size_t i = 0; i < kSignals.size(); ++i) {
      struct sigaction now {};
      // A handler that the program has installed meanwhile stays.
      if (installed_[i] && ::sigaction(kSignals[i], nullptr, &now) == 0 && now.sa_handler == remove_files_and_end)
        std::signal(kSignals[i], SIG_DFL);
    }
  }

 private:
  std::mutex mutex_;
  int users_ = 0;
  std::array<bool, kSignals.size()> installed_{};
};

Handlers& handlers() {
  static Handlers instance;
  return instance;
}

/// ".ligne-PID-" and 64 random bits.
std::string temporary_name() {
  std::random_device chance;
  std::string name = ".ligne-" + std::to_string(::getpid()) + "-";
  constexpr std::string_view kDigits = "0123456789abcdef";
  for (int i = 0; i < 2; ++i) {
    const unsigned bits = chance();
    for (unsigned shift = 0; shift < 32; shift += 4) name += kDigits[bits >> shift & 15u];
  }
  return name;
}

[[noreturn]] void fail(int error) { throw std::system_error(error, std::generic_category()); }

}  // namespace

TemporaryFile::TemporaryFile(const std::filesystem::path& folder, mode_t mode) : path_(folder / temporary_name()) {
  const std::string& name = path_.native();
  if (name.size() >= PATH_MAX) fail(ENAMETOOLONG);
  entry_ = TemporaryFileEntry::take();
  std::copy_n(name.c_str(), name.size() + 1, entry_->name.begin());
  handlers().need();
  entry_->named = true;
  descriptor_ = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
  if (descriptor_ >= 0) return;
  const int error = errno;
  entry_->give_back();
  handlers().let_go();
  fail(error);
}

TemporaryFile::~TemporaryFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
  if (!path_.empty()) ::unlink(path_.c_str());
  entry_->give_back();
  handlers().let_go();
}

void remove_temporary_files() { TemporaryFileEntry::remove_all(); }

void TemporaryFile::close() {
  const int descriptor = std::exchange(descriptor_, -1);
  if (::close(descriptor) != 0) fail(errno);
}

void TemporaryFile::rename_to(const std::filesystem::path& target) {
  if (::rename(path_.c_str(), target.c_str()) != 0) fail(errno);
  path_.clear();
}

}  // namespace ligne
