#include "cli/run_files.hpp"

#include <system_error>

#include "cli/errors.hpp"
#include "files/message_text.hpp"

namespace ligne {
namespace {

namespace fs = std::filesystem;

bool are_one_file(const fs::path& a, const fs::path& b) {
  std::error_code absent;
  return fs::equivalent(a, b, absent) && !absent;
}

/// True if two paths, which need not exist yet, lead to one file.
bool will_be_one_file(const fs::path& a, const fs::path& b) {
  if (a == b || are_one_file(a, b)) return true;
  if (a == "-" || b == "-") return false;
  std::error_code a_error, b_error;
  const fs::path whole_a = fs::weakly_canonical(fs::absolute(a, a_error), a_error),
                 whole_b = fs::weakly_canonical(fs::absolute(b, b_error), b_error);
  return whole_a == whole_b && !a_error && !b_error;
}

void refuse_if_same(const std::string& option, const fs::path& written, const fs::path& read) {
  if (written == "-" || !are_one_file(written, read)) return;
  const std::string other = written == read ? "" : " (as " + printable(read.string()) + ")";
  throw UsageError(
      option, printable(written.string(), kLongestPath) + " is also an input file" + other + ", and would be overwritten");
}

}  // namespace

void RunFiles::will_write(const std::string& option, const fs::path& file) {
  if (file.empty()) return;
  for (const Written& other : written_) {
    if (!will_be_one_file(file, other.file)) continue;
    throw UsageError(option, printable(file.string(), kLongestPath) + " is the " +
                                 (other.option == "--output" ? "output file" : "file of " + other.option) + " too");
  }
  for (const fs::path& read : read_) refuse_if_same(option, file, read);
  written_.push_back({option, file});
}

void RunFiles::were_read(const InputFiles& files) {
  for (const fs::path& file : files) {
    for (const Written& output : written_) refuse_if_same(output.option, output.file, file);
  }
  read_.insert(read_.end(), files.begin(), files.end());
}

}  // namespace ligne
