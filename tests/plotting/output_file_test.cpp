#include "plotting/writers/output_file.hpp"

#include <sys/wait.h>
#include <unistd.h>
#include <csignal>

#include "main/script.hpp"
#include "plotting/readers/json_cursor.hpp"
#include "plotting/readers/order_reader.hpp"
#include "support/test.hpp"

namespace ligne::test {
namespace {

namespace fs = std::filesystem;

class OutputFile : public ::testing::Test {
 protected:
  std::size_t files() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(fs::path(folder_)), {}));
  }
  static std::string failure(const fs::path& file) {
    return failure_of([&] { write_output(file, "bytes"); });
  }

  TemporaryFolder folder_;
};

TEST_F(OutputFile, WritesAndReplaces) {
  const fs::path file = folder_ / "drawing.svg";
  write_output(file, std::string("one\0two", 7));
  EXPECT_EQ(bytes_of_file(file), std::string("one\0two", 7));
  fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write);
  write_output(file, "");
  EXPECT_EQ(bytes_of_file(file), "");
  EXPECT_EQ(fs::status(file).permissions(), fs::perms::owner_read | fs::perms::owner_write) << "permissions are kept";
  EXPECT_EQ(files(), 1u) << "something was left over";
}

TEST_F(OutputFile, KeepsALongName) {
  const fs::path file = folder_ / std::string(255, 'n');
  write_output(file, "bytes");
  EXPECT_EQ(bytes_of_file(file), "bytes");
}

TEST_F(OutputFile, WritesThroughASymbolicLink) {
  write_output(folder_ / "real", "old");
  fs::create_symlink("real", folder_ / "link");
  write_output(folder_ / "link", "new");
  EXPECT_TRUE(fs::is_symlink(folder_ / "link"));
  EXPECT_EQ(bytes_of_file(folder_ / "real"), "new");
}

TEST_F(OutputFile, WritesToADevice) {
  write_output("/dev/null", "bytes");
  EXPECT_FALSE(fs::is_regular_file("/dev/null"));
}

TEST_F(OutputFile, FailuresNameTheFileAndTheCause) {
  const fs::path missing = folder_ / "missing" / "drawing.svg";
  EXPECT_EQ(failure(missing), missing.string() + ": No such file or directory");
  EXPECT_EQ(failure(folder_), folder_.string() + ": Is a directory");
  EXPECT_NE(failure(""), "");
  EXPECT_NE(failure(folder_ / std::string(256, 'n')).find("File name too long"), std::string::npos);
  EXPECT_EQ(failure("/dev/full"), "/dev/full: No space left on device");
  EXPECT_EQ(files(), 0u) << "something was left over";
}

TEST_F(OutputFile, SeveralFilesComeTogether) {
  write_output(folder_ / "a", "old");
  {
    OutputFiles given_up;
    given_up.add(folder_ / "a", "new");
    given_up.add(folder_ / "b", "new");
    EXPECT_EQ(files(), 3u) << "beside their places";
  }
  EXPECT_EQ(files(), 1u) << "something was left over";
  OutputFiles outputs;
  outputs.add(folder_ / "a", "new");
  outputs.add("/dev/full", "bytes");
  EXPECT_THROW(outputs.commit(), std::runtime_error);
  EXPECT_EQ(bytes_of_file(folder_ / "a"), "old");
  OutputFiles both;
  both.add(folder_ / "a", "new a");
  both.add(folder_ / "b", "new b");
  both.commit();
  EXPECT_EQ(bytes_of_file(folder_ / "a") + bytes_of_file(folder_ / "b"), "new anew b");
  EXPECT_EQ(std::distance(fs::directory_iterator(fs::path(folder_)), {}), 2);
}

/// Sends the signal to a process that has files beside their places, set up by `before`; its status.
int status_after(int signal, const fs::path& folder, void (*before)(int)) {
  int ready[2];
  EXPECT_EQ(::pipe(ready), 0);
  const pid_t child = ::fork();
  if (child == 0) {
    before(signal);
    OutputFiles outputs;
    outputs.add(folder / "a", "bytes");
    outputs.add(folder / "b", "bytes");
    // Only the signal ends the pause: it is held back until then.
    sigset_t held, before_it;
    sigemptyset(&held);
    sigaddset(&held, signal);
    ::sigprocmask(SIG_BLOCK, &held, &before_it);
    if (::write(ready[1], "", 1) == 1) ::sigsuspend(&before_it);
    outputs.commit();
    ::_exit(0);
  }
  char byte;
  EXPECT_EQ(::read(ready[0], &byte, 1), 1);
  ::kill(child, signal);
  int status = 0;
  ::waitpid(child, &status, 0);
  ::close(ready[0]);
  ::close(ready[1]);
  return status;
}

TEST_F(OutputFile, ASignalRemovesWhatStandsBesideItsPlaceAndEndsTheProcess) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const int status = status_after(signal, folder_, [](int s) { std::signal(s, SIG_DFL); });
    EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == signal) << status;
    EXPECT_EQ(files(), 0u);
  }
}

TEST_F(OutputFile, HandlersOfTheProgramAroundStay) {
  const int status = status_after(SIGTERM, folder_, [](int s) { std::signal(s, [](int) {}); });
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << status;
  EXPECT_EQ(bytes_of_file(folder_ / "b"), "bytes");
  write_output(folder_ / "c", "bytes");
  struct sigaction now {};
  ASSERT_EQ(::sigaction(SIGTERM, nullptr, &now), 0);
  EXPECT_EQ(now.sa_handler, SIG_DFL) << "and ours go";
}

// The cursor over JSON text, and the order of painting that is read with it.

/// The members of an object: "NAME=VALUE NAME=VALUE".
std::string members_of(const std::string& text) {
  JsonCursor cursor(text);
  std::string all;
  cursor.for_each_member([&](std::string_view name) {
    all += (all.empty() ? "" : " ") + std::string(name) + "=" + std::string(cursor.value());
  });
  EXPECT_TRUE(cursor.at_end());
  return all;
}

/// The drawing without what is long, and its order.
std::string split(const std::string& text) {
  const SplitDrawing parts = split_drawing(text, "a.json");
  return parts.rest + " order " + std::string(parts.order);
}

/// Pieces of an order: "face 3 material 1 light 2 0,0 8,0 8,8.5 hole 2,2 2,4 4,4".
std::string pieces_of(const std::string& text) {
  ReadOrder order;
  read_pieces(text, "a.json", order);
  std::string all = order.tells_hidden ? "tells hidden" : "";
  for (std::size_t i = 0; i < order.pieces.size(); ++i) {
    all += "face " + as_text(order.pieces[i].face) + " material " + as_text(order.pieces[i].material) + " light " +
           as_text(order.pieces[i].light);
    for (const auto& contour : order.order.pieces.at(i).contours) {
      if (&contour != &order.order.pieces[i].contours[0]) all += " hole";
      for (const Point2 p : contour) all += " " + as_text(p.x) + "," + as_text(p.y);
    }
  }
  return all;
}

[[maybe_unused]] const bool json_values_are_added = add_function_scripts(
    LIGNE_SOURCE_DIR "/tests/plotting/json_values", {{"members", members_of},
                                                     {"number", [](auto& t) { return as_text(JsonCursor(t).number()); }},
                                                     {"split", split},
                                                     {"pieces", pieces_of}});

}  // namespace
}  // namespace ligne::test
