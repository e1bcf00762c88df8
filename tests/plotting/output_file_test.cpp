#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include <gtest/gtest.h>

#include "plotting/output_file.hpp"

namespace ligne {
namespace {

namespace fs = std::filesystem;

class OutputFile : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "output-file-test-XXXXXX").string();
    ASSERT_NE(::mkdtemp(name.data()), nullptr);
    folder_ = name;
  }
  void TearDown() override { fs::remove_all(folder_); }

  static std::string read(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  std::size_t files() const { return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), {})); }
  static std::string failure(const fs::path& file) {
    try {
      write_output(file, "bytes");
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  }

  fs::path folder_;
};

TEST_F(OutputFile, WritesAndReplaces) {
  const fs::path file = folder_ / "drawing.svg";
  write_output(file, std::string("one\0two", 7));
  EXPECT_EQ(read(file), std::string("one\0two", 7));
  fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write);
  write_output(file, "");
  EXPECT_EQ(read(file), "");
  EXPECT_EQ(fs::status(file).permissions(), fs::perms::owner_read | fs::perms::owner_write) << "permissions are kept";
  EXPECT_EQ(files(), 1u) << "something was left over";
}

TEST_F(OutputFile, KeepsALongName) {
  const fs::path file = folder_ / std::string(255, 'n');
  write_output(file, "bytes");
  EXPECT_EQ(read(file), "bytes");
}

TEST_F(OutputFile, WritesThroughASymbolicLink) {
  write_output(folder_ / "real", "old");
  fs::create_symlink("real", folder_ / "link");
  write_output(folder_ / "link", "new");
  EXPECT_TRUE(fs::is_symlink(folder_ / "link"));
  EXPECT_EQ(read(folder_ / "real"), "new");
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

}  // namespace
}  // namespace ligne
