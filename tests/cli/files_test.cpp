/// Signals leave no file behind, and messages are short lines. More of the files of a run: scripts/files.txt.

#include <fcntl.h>
#include <grp.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>
#include <csignal>
#include <exception>
#include <new>

#include "main/script.hpp"
#include "program.hpp"

namespace ligne::test {
namespace {

/// The drawing stands beside its place, and the program waits for somebody to read the pipe: nobody does.
TEST_F(ProgramTest, SignalsLeaveNothing) {
  ASSERT_EQ(mkfifo(file("pipe").c_str(), 0600), 0);
  const std::vector<std::string> names = new_files();
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const pid_t child = fork();
    if (child == 0) {
      std::signal(signal, SIG_DFL);  // a shell starts what runs in the background without SIGINT
      if (chdir(folder_.c_str()) == 0)
        execl(LIGNE_PROGRAM, "ligne", "draw", "cube.obj", "-o", "x.svg", "--stats-json", "pipe", nullptr);
      _exit(127);
    }
    int status = 0;
    while (new_files() == names && waitpid(child, &status, WNOHANG) == 0) usleep(1000);
    for (const std::string& name : new_files()) EXPECT_TRUE(name == "pipe" || name.starts_with(".ligne-")) << name;
    kill(child, signal);
    ASSERT_EQ(waitpid(child, &status, 0), child);
    EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == signal) << status;
    EXPECT_EQ(new_files(), names);
  }
}

/// Whatever stands in a file or on the command line, an error or a warning is one line of bounded length.

constexpr std::size_t kLongestLine = 500;

/// Pieces of text that make lines long or odd.
std::vector<std::string> oddities() {
  return {std::string(500'000, 'x'),          std::string(500'000, '9'),   "two\nlines",
          "two\\nlines\\u0007\\u2028",        "\x1b[31mred\x07\x7f",       "\xff\xfe\xc3(",
          "\xe2\x80\xae\xc2\x85\xe2\x80\xa8", std::string(200'000, '\xc3')};
}

class Messages : public ProgramTest {
 protected:
  void is_one_line(const Words& arguments, const std::string& what) const {
    const Outcome outcome = run(arguments);
    EXPECT_TRUE(outcome.status == 1 || outcome.status == 2 || outcome.status == 0) << what;
    EXPECT_TRUE(outcome.status == 0 || outcome.error_lines() == 1) << what << ": " << outcome.err.substr(0, 2000);
    for (std::size_t begin = 0; begin < outcome.err.size();) {
      const std::size_t end = outcome.err.find('\n', begin);
      ASSERT_NE(end, std::string::npos) << what;
      const std::string line = outcome.err.substr(begin, end - begin);
      EXPECT_LT(line.size(), kLongestLine) << what << ": " << line.substr(0, 100);
      EXPECT_TRUE(line.starts_with("ligne: ")) << what << ": " << line.substr(0, 100);
      for (const char c : line) EXPECT_TRUE(static_cast<unsigned char>(c) >= 0x20 && c != 0x7f) << what;
      EXPECT_EQ(line.find("\xff"), std::string::npos) << what;
      EXPECT_EQ(line.find("\xe2\x80\xae"), std::string::npos) << what;
      begin = end + 1;
    }
  }
};

/// Files that are right but for an oddity at @: a name and a text a line.
std::vector<std::pair<std::string, std::string>> places_of_oddities() {
  std::vector<std::pair<std::string, std::string>> places;
  std::ifstream in(LIGNE_SOURCE_DIR "/tests/cli/odd_places.txt");
  for (std::string line; std::getline(in, line);) {
    std::string_view rest = line;
    const std::string name = take_word(rest);
    places.emplace_back(name, unescaped(rest));
  }
  return places;
}

TEST_F(Messages, FilesWithLongAndOddTexts) {
  const auto places = places_of_oddities();
  EXPECT_GT(places.size(), 30u);
  for (const auto& [name, pattern] : places) {
    const std::string suffix = std::filesystem::path(name).extension().string();
    for (const std::string& odd : oddities()) {
      std::string text = pattern;
      for (std::size_t at = text.find('@'); at != std::string::npos; at = text.find('@', at + odd.size()))
        text.replace(at, 1, odd);
      write(name, text);
      const std::string what = name + " with " + odd.substr(0, 20);
      if (suffix == ".grid") {
        is_one_line({"surface", "--grid", name, "-o", "x.svg"}, what);
      } else if (suffix == ".svg" || suffix == ".drawing") {
        is_one_line({"plot", name, "-o", "x.svg"}, what);
      } else if (suffix == ".pens") {
        is_one_line({"draw", "cube.obj", "--pens", name, "-o", "x.svg"}, what);
      } else if (suffix == ".device") {
        is_one_line({"draw", "cube.obj", "--device-file", name, "-o", "x.hpgl"}, what);
      } else {
        is_one_line({"draw", name, "-o", "x.svg"}, what);
      }
    }
  }
}

TEST_F(Messages, CommandLinesWithLongAndOddTexts) {
  for (std::string odd : oddities()) {
    odd.resize(std::min<std::size_t>(odd.size(), 100'000));  // the most that one argument may have is 128 KiB
    is_one_line({odd}, "command");
    is_one_line({"draw", odd, "-o", "x.svg"}, "model");
    is_one_line({"draw", "cube.obj", "-o", odd}, "output");
    is_one_line({"draw", "cube.obj", "-o", odd + ".svg/x.svg"}, "folder");
    is_one_line({"surface", odd, "-o", "x.svg"}, "formula");
    is_one_line({"surface", "x", "-x", odd, "-o", "x.svg"}, "range");
    is_one_line({"surface", "--grid", odd, "-o", "x.svg"}, "grid");
    for (const char* option :
         {"--view", "--direction", "--edges", "--method", "--page", "--margin", "--scale", "--unit", "--pen", "--device",
          "--device-file", "--pens", "--hatch", "--crease", "--threads", "--stats-json", "--preview", "--nonsense"}) {
      is_one_line({"draw", "cube.obj", option, odd, "-o", "x.svg"}, option);
    }
  }
}

// Failures where processes matter: a full device, a reader that went away, limits. Mistakes: scripts/mistakes.txt.

const std::vector<Words> kWritersToStandardOutput{
    "draw cube.obj -o - --format svg", "info cube.obj", {"methods"}, {"--help"}};

TEST_F(ProgramTest, FullDeviceIsAFailure) {
  for (const Words& arguments : kWritersToStandardOutput) {
    const int full = open("/dev/full", O_WRONLY | O_CLOEXEC);
    if (full < 0) return;  // not every system has one
    const Outcome outcome = run_program(folder_, arguments, full);
    EXPECT_EQ(outcome.status, kFailed) << arguments[0];
    EXPECT_EQ(outcome.error_lines(), 1u) << outcome.err;
  }
}

TEST_F(ProgramTest, ReaderThatWentAwayIsAFailureWithoutASignal) {
  for (const Words& arguments : kWritersToStandardOutput) {
    int ends[2];
    ASSERT_EQ(pipe2(ends, O_CLOEXEC), 0);
    close(ends[0]);
    const Outcome outcome = run_program(folder_, arguments, ends[1]);
    EXPECT_EQ(outcome.status, kFailed) << arguments[0];
    EXPECT_EQ(outcome.error_lines(), 1u) << outcome.err;
    EXPECT_EQ(outcome.err.rfind("ligne: ", 0), 0u) << outcome.err;
  }
}

/// The other tests call the command in their own process.
TEST_F(ProgramTest, TheProgramDoesWhatTheCommandDoes) {
  for (const Words arguments :
       {"draw cube.obj -o - --format json", "draw broken.obj -o x.svg", "draw cube.obj --crease much -o x.svg",
        "info square.obj", "surface x*y -o - --format svg --stats", "plot none.svg -o x.svg", "--version", ""}) {
    const Outcome here = run(arguments), there = run_program(folder_, arguments);
    const std::string what = arguments.empty() ? "no command" : arguments.back();
    EXPECT_EQ(here.status, there.status) << what;
    EXPECT_EQ(here.out, there.out) << what;
    if (what != "--stats") {  // times
      EXPECT_EQ(here.err, there.err) << what;
    }
  }
  expect_outcome({}, kUsage, {"ligne: there is no command"});
}

TEST_F(ProgramTest, TheCommandLeavesNoLimitAndNoHandlerBehind) {
  rlimit before{}, after{};
  ASSERT_EQ(getrlimit(RLIMIT_DATA, &before), 0);
  const std::new_handler new_handler = std::get_new_handler();
  const std::terminate_handler terminate_handler = std::get_terminate();
  EXPECT_EQ(run("draw cube.obj --dpi 1200 --max-memory 64M -o x.png").status, kFailed);
  run_well("draw cube.obj --max-memory 500M --threads 3 -o x.svg");
  ASSERT_EQ(getrlimit(RLIMIT_DATA, &after), 0);
  EXPECT_EQ(after.rlim_cur, before.rlim_cur);
  EXPECT_EQ(after.rlim_max, before.rlim_max);
  EXPECT_EQ(std::get_new_handler(), new_handler);
  EXPECT_EQ(std::get_terminate(), terminate_handler);
  EXPECT_EQ(run("draw cube.obj -o x.svg").err, "");
}

// ligne.sh in a tree where nothing can be written, and in one whose programs are built when they are first asked for.

namespace fs = std::filesystem;

TEST_F(ProgramTest, LigneShInAReadOnlyTreeSaysSoInOneLine) {
  const fs::path tree = file("tree");
  fs::create_directories(tree / "scripts");
  for (const char* folder : {"src", "plotting", "cmake"}) fs::create_directory(tree / folder);
  for (const char* name : {"ligne.sh", "CMakeLists.txt", "scripts/setup.sh"})
    fs::copy_file(fs::path(LIGNE_SOURCE_DIR) / name, tree / name);
  for (const auto& entry : fs::recursive_directory_iterator(tree))
    fs::permissions(entry.path(), fs::perms::owner_write, fs::perm_options::remove);
  fs::permissions(tree, fs::perms::owner_write, fs::perm_options::remove);
  fs::permissions(folder_, fs::perms::all);

  const std::string script = (tree / "ligne.sh").string(), messages = file("messages").string();
  const pid_t child = fork();
  if (child == 0) {
    // Permissions stop nobody who is root.
    constexpr uid_t kNobody = 65534;
    if (geteuid() == 0 && (setgroups(0, nullptr) != 0 || setgid(kNobody) != 0 || setuid(kNobody) != 0)) _exit(126);
    if (!freopen(messages.c_str(), "w", stderr)) _exit(125);
    execl("/bin/bash", "bash", script.c_str(), "--version", nullptr);
    _exit(127);
  }
  int status = 0;
  waitpid(child, &status, 0);
  fs::permissions(tree, fs::perms::owner_write, fs::perm_options::add);
  for (const auto& entry : fs::recursive_directory_iterator(tree))
    fs::permissions(entry.path(), fs::perms::owner_write, fs::perm_options::add);
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 1);
  EXPECT_EQ(contents(messages), "ligne.sh: " + fs::canonical(tree).string() +
                                    "/build/release: can not be written, and the program in it is not built; build it as "
                                    "somebody who may, or in a copy\n");
}

TEST_F(ProgramTest, LigneShBuildsTheStudyWhenItIsFirstAskedFor) {
  const fs::path tree = file("tree");
  for (const char* folder : {"src", "plotting", "cmake", "studies", "scripts"}) fs::create_directories(tree / folder);
  for (const char* name : {"ligne.sh", "scripts/setup.sh"}) fs::copy_file(fs::path(LIGNE_SOURCE_DIR) / name, tree / name);
  write("tree/CMakeLists.txt", contents(fs::path(LIGNE_SOURCE_DIR) / "tests/cli/two_programs.cmake"));
  const auto said_by = [&](const std::string& arguments) {
    const std::string command =
        "bash '" + (tree / "ligne.sh").string() + "' " + arguments + " >'" + file("said").string() + "'";
    EXPECT_EQ(std::system(command.c_str()), 0) << arguments;
    return contents(file("said"));
  };
  const fs::path study = tree / "build/release/src/cli/ligne-study";
  EXPECT_EQ(said_by("draw a"), "ligne draw a\n");
  EXPECT_FALSE(fs::exists(study)) << "whoever draws does not wait for it";
  EXPECT_EQ(said_by("study --list"), "ligne study --list\n") << "the program runs the other one";
  ASSERT_TRUE(fs::exists(study));
  fs::remove(study);
  EXPECT_EQ(said_by("draw a"), "ligne draw a\n");
  EXPECT_FALSE(fs::exists(study));
}

}  // namespace
}  // namespace ligne::test
