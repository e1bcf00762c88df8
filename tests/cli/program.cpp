#include "program.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include "cli/command_line.hpp"
#include "main/script.hpp"

namespace ligne::test {
namespace {

std::vector<std::string> names_in(const std::filesystem::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

std::size_t Outcome::error_lines() const { return static_cast<std::size_t>(std::count(err.begin(), err.end(), '\n')); }

std::string contents(const std::filesystem::path& file) { return bytes_of_file(file); }

namespace {

/// A file without a name, closed at the end of its life.
class NamelessFile {
 public:
  explicit NamelessFile(const char* about) : descriptor_(memfd_create(about, MFD_CLOEXEC)) {}
  ~NamelessFile() { close(descriptor_); }
  NamelessFile(const NamelessFile&) = delete;
  NamelessFile& operator=(const NamelessFile&) = delete;

  int descriptor() const { return descriptor_; }
  std::string contents() const {
    std::string text(static_cast<std::size_t>(lseek(descriptor_, 0, SEEK_END)), 0);
    for (std::size_t at = 0; at < text.size();) {
      const ssize_t got = pread(descriptor_, text.data() + at, text.size() - at, static_cast<off_t>(at));
      if (got <= 0) break;
      at += static_cast<std::size_t>(got);
    }
    return text;
  }

 private:
  int descriptor_;
};

/// The arguments as main() gets them.
std::vector<char*> argument_list(const Words& arguments) {
  std::vector<char*> argv{const_cast<char*>("ligne")};
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  return argv;
}

/// While it lives, another descriptor stands in the place of one of the standard ones.
class Redirection {
 public:
  Redirection(int place, int by) : place_(place), before_(fcntl(place, F_DUPFD_CLOEXEC, 3)) { dup2(by, place); }
  ~Redirection() {
    dup2(before_, place_);
    close(before_);
  }
  Redirection(const Redirection&) = delete;
  Redirection& operator=(const Redirection&) = delete;

 private:
  int place_, before_;
};

/// The folder of the built program is searched for others, such as that of the experiments.
void search_beside_program() {
  static const bool done = [] {
    const std::string folder = std::filesystem::path(LIGNE_PROGRAM).parent_path().string();
    const char* before = getenv("PATH");
    return setenv("PATH", (folder + (before ? ":" + std::string(before) : "")).c_str(), 1) == 0;
  }();
  ASSERT_TRUE(done);
}

void flush_all() {
  std::cout.flush();
  std::cerr.flush();
  std::fflush(nullptr);
}

}  // namespace

Words::Words(const char* line) : vector(words_of(line)) {}

Words& Words::operator+=(const Words& more) {
  insert(end(), more.begin(), more.end());
  return *this;
}

Outcome run_ligne(const std::filesystem::path& folder, const Words& arguments, const std::string* piped) {
  const NamelessFile out("out"), err("err");
  search_beside_program();
  std::vector<char*> argv = argument_list(arguments);
  Outcome outcome;
  flush_all();
  const std::filesystem::path before = std::filesystem::current_path();
  std::filesystem::current_path(folder);
  {
    const Redirection output(STDOUT_FILENO, out.descriptor()), errors(STDERR_FILENO, err.descriptor());
    std::optional<Redirection> input;
    if (int ends[2]; piped && pipe2(ends, O_CLOEXEC) == 0) {
      EXPECT_EQ(::write(ends[1], piped->data(), piped->size()), static_cast<ssize_t>(piped->size()));
      close(ends[1]);
      input.emplace(STDIN_FILENO, ends[0]);
      close(ends[0]);
    }
    outcome.status = run_command_line(static_cast<int>(argv.size()) - 1, argv.data());
    flush_all();
  }
  std::filesystem::current_path(before);
  outcome.out = out.contents();
  outcome.err = err.contents();
  return outcome;
}

Outcome run_program(const std::filesystem::path& folder, const Words& arguments, int out_fd) {
  const NamelessFile out("out"), err("err");
  std::vector<char*> argv = argument_list(arguments);
  const int output = out_fd < 0 ? out.descriptor() : out_fd;
  const pid_t child = fork();
  if (child == 0) {
    if (chdir(folder.c_str()) == 0 && dup2(output, STDOUT_FILENO) == STDOUT_FILENO &&
        dup2(err.descriptor(), STDERR_FILENO) == STDERR_FILENO) {
      execv(LIGNE_PROGRAM, argv.data());
    }
    _exit(127);
  }
  if (out_fd >= 0) close(out_fd);
  int status = 0;
  waitpid(child, &status, 0);

  Outcome outcome;
  outcome.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  outcome.err = err.contents();
  outcome.out = out.contents();
  return outcome;
}

void ProgramTest::SetUp() {
  const auto* info = testing::UnitTest::GetInstance()->current_test_info();
  std::string name = std::string(info->test_suite_name()) + "." + info->name();
  std::replace(name.begin(), name.end(), '/', '_');
  folder_ = std::filesystem::temp_directory_path() / ("ligne-" + name + "-" + std::to_string(getpid()));
  std::filesystem::remove_all(folder_);
  std::filesystem::create_directories(folder_);
  for (const char* model : {"cube.obj", "square.obj", "broken.obj"})
    write(model, contents(std::filesystem::path(LIGNE_SOURCE_DIR) / "tests/cli/models" / model));
  files_at_start_ = names_in(folder_);
}

void ProgramTest::TearDown() { std::filesystem::remove_all(folder_); }

Outcome ProgramTest::run_well(const Words& arguments) const {
  const Outcome outcome = run(arguments);
  EXPECT_EQ(outcome.status, kDone) << testing::PrintToString(arguments) << ": " << outcome.err;
  return outcome;
}

void ProgramTest::expect_outcome(const Words& arguments, int status, std::initializer_list<std::string_view> parts) const {
  SCOPED_TRACE(testing::PrintToString(arguments));
  const Outcome outcome = run(arguments);
  EXPECT_EQ(outcome.status, status) << outcome.err;
  expect_parts(outcome.err, parts);
}

void ProgramTest::write(const std::string& name, std::string_view text) const {
  std::ofstream(folder_ / name, std::ios::binary) << text;
}

std::vector<std::string> ProgramTest::new_files() const {
  const std::vector<std::string> now = names_in(folder_);
  std::vector<std::string> fresh;
  std::set_difference(now.begin(), now.end(), files_at_start_.begin(), files_at_start_.end(), std::back_inserter(fresh));
  return fresh;
}

}  // namespace ligne::test
