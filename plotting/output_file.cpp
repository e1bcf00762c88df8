#include "plotting/output_file.hpp"

#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <string>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace ligne {
namespace {

namespace fs = std::filesystem;

constexpr mode_t kNewFileMode = 0666;  // less the umask

/// Tries at a name that nobody else has taken.
constexpr int kMostTries = 1000;

[[noreturn]] void fail(const fs::path& file, int error) {
  throw std::runtime_error(file.string() + ": " + std::generic_category().message(error));
}

/// 0, or the errno.
int write_all(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return errno;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return 0;
}

/// Writes and closes.
int write_and_close(int descriptor, std::string_view bytes) {
  int error = write_all(descriptor, bytes);
  if (::close(descriptor) != 0 && error == 0) error = errno;
  return error;
}

/// A device or a pipe cannot be replaced: it is written to as it is.
void write_in_place(const fs::path& file, std::string_view bytes) {
  const int descriptor = ::open(file.c_str(), O_WRONLY | O_CLOEXEC);
  if (descriptor < 0) fail(file, errno);
  if (const int error = write_and_close(descriptor, bytes)) fail(file, error);
}

/// A new file in the directory of `target`; its descriptor and its name.
std::pair<int, fs::path> open_beside(const fs::path& file, const fs::path& target) {
  for (int i = 0; i < kMostTries; ++i) {
    fs::path beside = target;
    beside.replace_filename(".ligne-" + std::to_string(::getpid()) + "-" + std::to_string(i));
    const int descriptor = ::open(beside.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, kNewFileMode);
    if (descriptor >= 0) return {descriptor, beside};
    if (errno != EEXIST) fail(file, errno);
  }
  fail(file, EEXIST);
}

}  // namespace

void write_output(const fs::path& file, std::string_view bytes) {
  if (file == "-") {
    if (const int error = write_all(STDOUT_FILENO, bytes)) fail("standard output", error);
    return;
  }
  // The file that a symbolic link names is replaced, not the link.
  std::error_code no_such_file;
  fs::path target = fs::canonical(file, no_such_file);
  if (no_such_file) target = file;
  struct stat old {};
  const bool exists = ::stat(target.c_str(), &old) == 0;
  if (exists && S_ISDIR(old.st_mode)) fail(file, EISDIR);
  if (exists && !S_ISREG(old.st_mode)) return write_in_place(file, bytes);
  if (exists && ::access(target.c_str(), W_OK) != 0) fail(file, errno);
  if (!target.has_filename()) fail(file, file.empty() ? ENOENT : EISDIR);

  const auto [descriptor, beside] = open_beside(file, target);
  if (exists) static_cast<void>(::fchmod(descriptor, old.st_mode & 07777));
  int error = write_and_close(descriptor, bytes);
  if (error == 0 && ::rename(beside.c_str(), target.c_str()) != 0) error = errno;
  if (error != 0) {
    ::unlink(beside.c_str());
    fail(file, error);
  }
}

}  // namespace ligne
