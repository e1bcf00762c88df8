#include "files/input_file.hpp"

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <thread>

namespace ligne {
namespace {

namespace fs = std::filesystem;

class InputFile : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "input-file-test-XXXXXX").string();
    ASSERT_NE(::mkdtemp(name.data()), nullptr);
    std::signal(SIGPIPE, SIG_IGN);  // of the writers, whose reader may go first
    folder_ = name;
  }
  void TearDown() override { fs::remove_all(folder_); }

  /// What is read, or the error without the name.
  static std::string read(const fs::path& file, std::uintmax_t most = kLargestInput) {
    InputFiles opened;
    try {
      const std::vector<std::byte> bytes = read_input(file, "F", opened, most);
      EXPECT_EQ(opened, InputFiles{file});
      return std::string(as_characters(bytes));
    } catch (const InputError& error) {
      return error.what();
    }
  }

  fs::path folder_;
};

TEST_F(InputFile, ReadsWholeFiles) {
  const std::string text(3'000'001, 'x');
  std::ofstream(folder_ / "large") << text;
  std::ofstream(folder_ / "empty");
  EXPECT_EQ(read(folder_ / "large"), text);
  EXPECT_EQ(read(folder_ / "empty"), "");
  EXPECT_FALSE(read("/proc/self/stat").empty()) << "tells no size";
  EXPECT_EQ(read(folder_ / "large", 1 << 20), "F: is larger than 1 MiB");
}

TEST_F(InputFile, RefusesWhatIsNoFile) {
  EXPECT_EQ(read(folder_ / "none"), "F: there is no such file");
  EXPECT_EQ(read(folder_), "F: is a directory, not a file");
  for (const char* device : {"/dev/zero", "/dev/urandom", "/dev/full", "/dev/null"})
    EXPECT_EQ(read(device), "F: is a device or a socket, not a file") << device;
  const int listening = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  (folder_ / "socket").string().copy(address.sun_path, sizeof address.sun_path - 1);
  ASSERT_EQ(::bind(listening, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  EXPECT_EQ(read(folder_ / "socket"), "F: is a device or a socket, not a file");
  ::close(listening);
}

TEST_F(InputFile, ReadsPipesOfWhichSomebodyHasTheOtherEnd) {
  const fs::path pipe = folder_ / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_EQ(read(pipe), "F: is a pipe to which nobody writes");
  const std::string text(200'000, 'y');  // more than a pipe holds
  std::thread writer([&] { std::ofstream(pipe) << text; });
  EXPECT_EQ(read(pipe), text);
  writer.join();
}

TEST_F(InputFile, EndlessPipesEnd) {
  const fs::path pipe = folder_ / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  std::thread writer([&] {
    std::ofstream out(pipe);
    const std::string block(1 << 16, '\0');
    for (int i = 0; i < 64 && out; ++i) out << block;
  });
  EXPECT_EQ(read(pipe, 1 << 20), "F: is larger than 1 MiB, and no size is told before it is read");
  writer.join();
}

}  // namespace
}  // namespace ligne
