#include "files/input_file.hpp"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <iterator>
#include <system_error>

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/large_vector.hpp"
#include "base/parallel.hpp"
#include "files/file_error.hpp"
#include "files/named_input.hpp"

namespace ligne {
namespace {

/// Time to wait for a writer of a pipe: the two ends of a named pipe are opened by two programs.
constexpr int kWaitForWriterMs = 1000;
/// Least size of a file that all threads read, in bytes: page faults of the memory take half of the time. Adjustable.
constexpr std::size_t kLargeFile = std::size_t{1} << 23;

std::string cause_of(int error) { return std::generic_category().message(error); }

std::string size_text(std::uintmax_t bytes) {
  constexpr const char* kUnits[] = {" bytes", " KiB", " MiB", " GiB"};
  std::size_t unit = 0;
  for (; unit + 1 < std::size(kUnits) && bytes >= 1024 && bytes % 1024 == 0; bytes /= 1024) ++unit;
  return std::to_string(bytes) + kUnits[unit];
}

/// A file that is open for reading.
class OpenInput {
 public:
  OpenInput(const std::filesystem::path& file, const std::string& name) : name_(name) {
    // The type is checked before opening, since opening a device can have effects.
    struct stat status {};
    if (::stat(file.c_str(), &status) != 0) {
      const bool absent = errno == ENOENT || errno == ENOTDIR;
      throw FileError(name_, absent ? "there is no such file" : cause_of(errno), errno);
    }
    if (S_ISDIR(status.st_mode)) throw FileError(name_, "is a directory, not a file", EISDIR);
    if (!S_ISREG(status.st_mode) && !S_ISFIFO(status.st_mode))
      throw InputError(name_, "is a device or a socket, not a file");
    // Without O_NONBLOCK, opening a pipe that has no writer would block.
    descriptor_ = ::open(file.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY);
    if (descriptor_ < 0) throw FileError(name_, "can not be opened for reading", errno);
    is_pipe_ = S_ISFIFO(status.st_mode);
    if (!is_pipe_) size_ = static_cast<std::uintmax_t>(status.st_size);
  }
  ~OpenInput() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  OpenInput(const OpenInput&) = delete;
  OpenInput& operator=(const OpenInput&) = delete;

  /// Size reported by the file system; 0 if it has none.
  std::uintmax_t size() const { return size_; }

  /// Fills `to` with the first bytes of a regular file, with all threads. Returns false if the file has fewer or can not be
  /// read; else read() goes on behind them.
  bool read_first(std::span<std::byte> to) {
    std::atomic<bool> is_complete{true};
    parallel_blocks(to.size(), kBlock, [&](std::size_t begin, std::size_t end) {
      while (begin < end) {
        const ssize_t n = ::pread(descriptor_, to.data() + begin, end - begin, static_cast<off_t>(begin));
        if (n < 0 && errno == EINTR) continue;
        if (n <= 0) {
          is_complete = false;
          return;
        }
        begin += static_cast<std::size_t>(n);
      }
    });
    return is_complete && ::lseek(descriptor_, static_cast<off_t>(to.size()), SEEK_SET) >= 0;
  }

  /// Fills the front of `to`. Returns the number of bytes, 0 at the end of the file.
  std::size_t read(std::span<std::byte> to) {
    for (;;) {
      const ssize_t n = ::read(descriptor_, to.data(), to.size());
      if (n < 0 && errno == EAGAIN) {
        wait(kForEver);  // a writer has it open, and may take time
      } else if (n < 0 && errno != EINTR) {
        throw FileError(name_, "can not be read to its end: " + cause_of(errno), errno);
      } else if (n == 0 && is_pipe_ && !had_writer_) {
        if (!wait(kWaitForWriterMs)) throw InputError(name_, "is a pipe without a writer");
      } else if (n >= 0) {
        return static_cast<std::size_t>(n);
      }
    }
  }

 private:
  static constexpr int kForEver = -1;
  static constexpr std::size_t kBlock = std::size_t{1} << 22;  ///< bytes that a task reads. Adjustable

  /// Waits until there are bytes to read or the last writer is gone; false if the time is up.
  bool wait(int milliseconds) {
    pollfd end{descriptor_, POLLIN, 0};
    const int ready = ::poll(&end, 1, milliseconds);
    had_writer_ = had_writer_ || ready > 0;
    return ready != 0;
  }

  const std::string& name_;
  int descriptor_ = -1;
  std::uintmax_t size_ = 0;
  bool is_pipe_ = false, had_writer_ = false;
};

/// Whether the bytes are the pointer that Git LFS leaves in place of a file that is not fetched yet.
bool is_lfs_pointer(std::span<const std::byte> bytes) {
  return as_characters(bytes).starts_with("version https://git-lfs.github.com/spec/");
}

}  // namespace

std::vector<std::byte> read_input(const std::filesystem::path& file, const std::string& name, InputFiles& opened,
                                  std::uintmax_t most) {
  OpenInput in(file, name);
  opened.push_back(file);
  const std::uintmax_t unsized = std::min(most, kLargestUnsized);
  if (in.size() > most) throw InputError(name, "is larger than " + size_text(most));
  std::vector<std::byte> bytes;
  const auto size = static_cast<std::size_t>(in.size());
  if (size >= kLargeFile) {
    bytes = large_vector<std::byte>(size + 1);
    bytes.resize(size);
    if (!in.read_first(bytes)) bytes.clear();
  } else {
    bytes.reserve(size + 1);
  }
  // Reads in pieces: files in /proc and pipes have no size.
  constexpr std::size_t kPiece = std::size_t{1} << 20;
  for (std::size_t read = 1; read > 0;) {
    const std::size_t begin = bytes.size();
    if (begin > in.size() && begin > unsized) {
      throw InputError(name, "is larger than " + size_text(unsized) + ", the limit for an input of unknown size");
    }
    bytes.resize(std::max(std::min(begin + kPiece, bytes.capacity()), begin + 1));
    read = in.read(std::span(bytes).subspan(begin));
    bytes.resize(begin + read);
  }
  if (is_lfs_pointer(bytes)) throw InputError(name, "is a pointer of Git LFS, not the file: git lfs pull fetches that");
  return bytes;
}

std::string shown_input(const std::filesystem::path& file) { return file == "-" ? "standard input" : file.string(); }

std::vector<std::byte> read_named_input(const std::filesystem::path& file, InputFiles& opened, std::uintmax_t most) {
  return read_input(file == "-" ? "/dev/stdin" : file, shown_input(file), opened, most);
}

}  // namespace ligne
