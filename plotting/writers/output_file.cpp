#include "plotting/writers/output_file.hpp"

#include <cerrno>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "files/message_text.hpp"
#include "plotting/writers/temporary_file.hpp"

namespace ligne {
namespace {

namespace fs = std::filesystem;

constexpr mode_t kNewFileMode = 0666;  // less the umask

[[noreturn]] void fail(const fs::path& file, int error) { throw OutputError(file, error); }

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

/// A device or a pipe cannot be replaced: it is written to as it is.
void write_in_place(const fs::path& file, std::string_view bytes) {
  if (file == "-") {
    if (const int error = write_all(STDOUT_FILENO, bytes)) fail("standard output", error);
    return;
  }
  const int descriptor = ::open(file.c_str(), O_WRONLY | O_CLOEXEC);
  if (descriptor < 0) fail(file, errno);
  int error = write_all(descriptor, bytes);
  if (::close(descriptor) != 0 && error == 0) error = errno;
  if (error != 0) fail(file, error);
}

}  // namespace

OutputError::OutputError(const fs::path& file, int error)
    : std::runtime_error(message_line(file.string() + ": " + std::generic_category().message(error))),
      file_(file),
      error_(error) {}

OutputFiles::OutputFiles() = default;
OutputFiles::~OutputFiles() = default;

void OutputFiles::add(const fs::path& file, std::string bytes) {
  if (file == "-") {
    in_place_.push_back({file, std::move(bytes)});
    return;
  }
  // The file that a symbolic link names is replaced, not the link.
  std::error_code no_such_file;
  fs::path target = fs::canonical(file, no_such_file);
  if (no_such_file) target = file;
  struct stat old {};
  const bool exists = ::stat(target.c_str(), &old) == 0;
  if (exists && S_ISDIR(old.st_mode)) fail(file, EISDIR);
  if (exists && !S_ISREG(old.st_mode)) {
    in_place_.push_back({file, std::move(bytes)});
    return;
  }
  if (exists && ::access(target.c_str(), W_OK) != 0) fail(file, errno);
  if (!target.has_filename()) fail(file, file.empty() ? ENOENT : EISDIR);
  try {
    auto temporary = std::make_unique<TemporaryFile>(target.parent_path(), kNewFileMode);
    if (exists) static_cast<void>(::fchmod(temporary->descriptor(), old.st_mode & 07777));
    if (const int error = write_all(temporary->descriptor(), bytes)) fail(file, error);
    temporary->close();
    beside_.push_back({file, target, std::move(temporary)});
  } catch (const std::system_error& error) {
    fail(file, error.code().value());
  }
}

void OutputFiles::commit() {
  const std::vector<Beside> beside = std::exchange(beside_, {});
  for (const InPlace& output : std::exchange(in_place_, {})) write_in_place(output.file, output.bytes);
  for (const Beside& output : beside) {
    try {
      output.temporary->rename_to(output.target);
    } catch (const std::system_error& error) {
      fail(output.file, error.code().value());
    }
  }
}

void remove_unfinished_output() { remove_temporary_files(); }

void write_output(const fs::path& file, std::string bytes) {
  OutputFiles files;
  files.add(file, std::move(bytes));
  files.commit();
}

}  // namespace ligne
