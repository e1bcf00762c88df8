// main() of every test program. Beside what GoogleTest does it
// - runs the tests alone whose name LIGNE_TEST_REGEX matches, whatever the case of its letters;
// - says of a test that fails, or that ends the program, how to run it alone;
// - counts the tests and checks, and appends the counts to the file that LIGNE_TEST_COUNTS names;
// - appends the processor seconds of each test, its child processes included, to the file that LIGNE_TEST_TIMES names.

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <regex>

#include "main/tier.hpp"
#include "support/standard.hpp"

namespace ligne::test {
namespace {

std::string program;

/// Written before each test, for the handler of signals.
std::array<char, 1024> running{};
/// Standard error of this program, whatever a test puts in its place.
int messages = STDERR_FILENO;

std::string full_name(const testing::TestInfo& test) { return std::string(test.test_suite_name()) + "." + test.name(); }

std::string alone(const testing::TestInfo& test) {
  std::string command = runs_all() ? "LIGNE_TEST_TIER=all " : "";
  if (rotation_seed() != 0) command += "LIGNE_TEST_SEED=" + std::to_string(rotation_seed()) + " ";
  return "alone: " + command + program + " --gtest_filter='" + full_name(test) + "'\n";
}

void tell_test_and_end(int signal) {
  // The last words, where a test had standard error written to a file. A death test's child is started with such a file,
  // which its parent reads: there both descriptors are one file, and nothing is to be copied.
  struct stat here {
  }, there{};
  if (fstat(STDERR_FILENO, &here) == 0 && fstat(messages, &there) == 0 && here.st_ino != there.st_ino) {
    std::array<char, 4096> words{};
    const ssize_t length = pread(STDERR_FILENO, words.data(), words.size(), 0);
    if (length > 0) static_cast<void>(!write(messages, words.data(), static_cast<std::size_t>(length)));
  }
  static_cast<void>(!write(messages, running.data(), std::strlen(running.data())));
  std::signal(signal, SIG_DFL);
  raise(signal);
}

/// Processor seconds of this process and of its children that have ended.
double processor_seconds() {
  double seconds = 0;
  for (const int who : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
    rusage used{};
    getrusage(who, &used);
    for (const timeval& time : {used.ru_utime, used.ru_stime})
      seconds += static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_usec) * 1e-6;
  }
  return seconds;
}

class Listener : public testing::EmptyTestEventListener {
  void OnTestStart(const testing::TestInfo& test) override {
    const std::string text = full_name(test) + " ends the program\n" + alone(test);
    const std::size_t length = std::min(text.size(), running.size() - 1);
    std::memcpy(running.data(), text.data(), length);
    running[length] = 0;
    begun_at_ = processor_seconds();
  }

  void OnTestEnd(const testing::TestInfo& test) override {
    if (test.result()->Failed()) std::cout << alone(test) << std::flush;
    if (const char* const file = std::getenv("LIGNE_TEST_TIMES"))
      std::ofstream(file, std::ios::app) << std::to_string(processor_seconds() - begun_at_) + ' ' + full_name(test) + '\n';
  }

  void OnTestProgramEnd(const testing::UnitTest& all) override {
    const char* const file = std::getenv("LIGNE_TEST_COUNTS");
    if (!file) return;
    // One write, so that programs that end together do not mix their lines.
    const std::string line =
        std::to_string(all.test_to_run_count() - all.skipped_test_count()) + ' ' + std::to_string(all.failed_test_count()) +
        ' ' + std::to_string(all.skipped_test_count()) + ' ' + std::to_string(checks_made(Check::drawings)) + ' ' +
        std::to_string(checks_made(Check::intervals)) + ' ' + std::to_string(checks_made(Check::pairs)) + '\n';
    std::ofstream(file, std::ios::app) << line << std::flush;
  }

  double begun_at_ = 0;
};

/// The filter of GoogleTest for the tests whose name, with the suite's before it, matches.
std::string filter_for(const std::string& expression) {
  const std::regex wanted(expression, std::regex::ECMAScript | std::regex::icase);
  std::string filter;
  const testing::UnitTest& all = *testing::UnitTest::GetInstance();
  for (int s = 0; s < all.total_test_suite_count(); ++s) {
    const testing::TestSuite& suite = *all.GetTestSuite(s);
    for (int t = 0; t < suite.total_test_count(); ++t) {
      const std::string name = full_name(*suite.GetTestInfo(t));
      if (std::regex_search(name, wanted)) filter += (filter.empty() ? "" : ":") + name;
    }
  }
  return filter.empty() ? "-*" : filter;
}

}  // namespace
}  // namespace ligne::test

int main(int argc, char** argv) {
  using namespace ligne::test;
  program = argv[0];
  messages = fcntl(STDERR_FILENO, F_DUPFD_CLOEXEC, 3);
  testing::InitGoogleTest(&argc, argv);
  const char* const expression = std::getenv("LIGNE_TEST_REGEX");
  // A death test runs the program again, with a filter of its own.
  if (expression && testing::GTEST_FLAG(filter) == "*") testing::GTEST_FLAG(filter) = filter_for(expression);
#ifndef LIGNE_SANITIZED  // sanitizers have handlers of their own
  for (const int signal : {SIGABRT, SIGSEGV, SIGFPE, SIGBUS, SIGILL}) std::signal(signal, tell_test_and_end);
#endif
  testing::UnitTest::GetInstance()->listeners().Append(new Listener);
  return RUN_ALL_TESTS();
}
