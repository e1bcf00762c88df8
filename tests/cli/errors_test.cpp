/// Failures where processes matter: a full device, a reader that went away, limits. Mistakes: scripts/mistakes.txt.

#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <exception>
#include <new>

#include "program.hpp"

namespace ligne::test {
namespace {

TEST_F(ProgramTest, FailureKeepsTheEarlierDrawing) {
  write("out.svg", "earlier");
  EXPECT_EQ(run("draw broken.obj -o out.svg").status, kFailed);
  EXPECT_EQ(contents(file("out.svg")), "earlier");
  expect_outcome({}, kUsage, {"ligne: there is no command"});
}

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

}  // namespace
}  // namespace ligne::test
