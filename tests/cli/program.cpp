#include "program.hpp"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <fstream>
#include <iterator>

namespace ligne::test {
namespace {

constexpr std::string_view kCube = R"(o cube
v -10 -10 -10
v 10 -10 -10
v 10 10 -10
v -10 10 -10
v -10 -10 10
v 10 -10 10
v 10 10 10
v -10 10 10
f 1 4 3 2
f 5 6 7 8
f 1 2 6 5
f 2 3 7 6
f 3 4 8 7
f 4 1 5 8
)";

constexpr std::string_view kSquare = R"(o square
v 0 0 0
v 40 0 0
v 40 10 0
v 0 10 0
f 1 2 3 4
)";

std::vector<std::string> names_in(const std::filesystem::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

int open_for_writing(const std::filesystem::path& file) {
  return open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
}

}  // namespace

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

std::size_t Outcome::error_lines() const { return static_cast<std::size_t>(std::count(err.begin(), err.end(), '\n')); }

std::string contents(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

Outcome run_ligne(const std::filesystem::path& folder, const std::vector<std::string>& arguments, int out_fd) {
  static std::atomic<int> counter = 0;
  const std::string stem =
      (std::filesystem::temp_directory_path() / ("ligne-" + std::to_string(getpid()) + "-" + std::to_string(counter++)))
          .string();
  const std::string out = stem + ".out", err = stem + ".err";
  const bool captured = out_fd < 0;

  std::vector<char*> argv{const_cast<char*>("ligne")};
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  if (captured) out_fd = open_for_writing(out);
  const int err_fd = open_for_writing(err);
  const pid_t child = fork();
  if (child == 0) {
    if (chdir(folder.c_str()) == 0 && dup2(out_fd, 1) == 1 && dup2(err_fd, 2) == 2) execv(LIGNE_PROGRAM, argv.data());
    _exit(127);
  }
  close(out_fd);
  close(err_fd);
  int status = 0;
  waitpid(child, &status, 0);

  Outcome outcome;
  outcome.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  outcome.err = contents(err);
  std::filesystem::remove(err);
  if (captured) {
    outcome.out = contents(out);
    std::filesystem::remove(out);
  }
  return outcome;
}

void ProgramTest::SetUp() {
  const auto* info = testing::UnitTest::GetInstance()->current_test_info();
  std::string name = std::string(info->test_suite_name()) + "." + info->name();
  std::replace(name.begin(), name.end(), '/', '_');
  folder_ = std::filesystem::temp_directory_path() / ("ligne-" + name + "-" + std::to_string(getpid()));
  std::filesystem::remove_all(folder_);
  std::filesystem::create_directories(folder_);
  write("cube.obj", kCube);
  write("square.obj", kSquare);
  write("broken.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n");
  files_at_start_ = names_in(folder_);
}

void ProgramTest::TearDown() { std::filesystem::remove_all(folder_); }

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
