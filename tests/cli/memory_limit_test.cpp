/// Sizes as people write them, and what control groups say.

#include "cli/memory_limit.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <fstream>
#include <string_view>

#include "picture/parse/parse_options.hpp"

namespace ligne {
namespace {

constexpr double kMega = 1024 * 1024, kGiga = 1024 * kMega;

TEST(MemoryText, IsReadInPowersOf1024) {
  const std::pair<const char*, double> texts[] = {
      {"1", 1},           {"4096", 4096},      {"64K", 65536},          {"64k", 65536},       {"1.5G", 1.5 * kGiga},
      {"2GB", 2 * kGiga}, {"2GiB", 2 * kGiga}, {"500mib", 500 * kMega}, {"1T", 1024 * kGiga}, {"1e3B", 1000},
  };
  for (const auto& [text, bytes] : texts) EXPECT_EQ(parse_memory(text).bytes, bytes) << text;
}

TEST(MemoryText, NoneAndZeroAreNoLimit) {
  for (const char* text : {"none", "0", "0G"}) EXPECT_TRUE(std::isinf(parse_memory(text).bytes)) << text;
}

TEST(MemoryText, OtherwiseHasNoMeaning) {
  for (const char* text :
       {"", "M", "64X", "64MM", "64M ", " 64M", "-1", "-64M", "5apples", "nan", "inf", "1e400", "none G"}) {
    EXPECT_THROW(parse_memory(text), std::invalid_argument) << text;
  }
}

TEST(MemoryText, IsWrittenAsItIsRead) {
  const std::pair<double, const char*> sizes[] = {{0, "0"},
                                                  {999, "999"},
                                                  {1023, "1023"},
                                                  {1024, "1K"},
                                                  {64 * kMega, "64M"},
                                                  {1.5 * kGiga, "1.5G"},
                                                  {1000 * kMega, "1000M"}};
  for (const auto& [bytes, text] : sizes) EXPECT_EQ(bytes_text(bytes), text);
}

/// A folder in the place of "/".
class ControlGroups : public testing::Test {
 protected:
  void SetUp() override {
    root_ = std::filesystem::temp_directory_path() / ("ligne-groups-" + std::to_string(getpid()));
    std::filesystem::remove_all(root_);
  }
  void TearDown() override { std::filesystem::remove_all(root_); }
  void write(const std::string& name, std::string_view text) const {
    std::filesystem::create_directories((root_ / name).parent_path());
    std::ofstream(root_ / name) << text << '\n';
  }
  std::filesystem::path root_;
};

TEST_F(ControlGroups, AbsentOnesLimitNothing) { EXPECT_EQ(group_memory(root_), std::nullopt); }

TEST_F(ControlGroups, OfVersion2CountWithThoseThatTheyArePartOf) {
  write("proc/self/cgroup", "0::/user.slice/work.scope");
  write("sys/fs/cgroup/user.slice/work.scope/memory.max", "max");
  EXPECT_EQ(group_memory(root_), std::nullopt);
  write("sys/fs/cgroup/user.slice/memory.max", "300000");
  EXPECT_EQ(group_memory(root_), 300000u);
  write("sys/fs/cgroup/user.slice/work.scope/memory.max", "200000");
  EXPECT_EQ(group_memory(root_), 200000u);
  write("sys/fs/cgroup/memory.max", "100000");
  EXPECT_EQ(group_memory(root_), 100000u);
}

TEST_F(ControlGroups, OfVersion1AreThoseOfTheMemoryController) {
  write("proc/self/cgroup", "5:cpu,cpuacct:/a\n4:hugetlb,memory:/b/c\n0::/");
  write("sys/fs/cgroup/memory/b/memory.limit_in_bytes", "400000");
  write("sys/fs/cgroup/memory/a/memory.limit_in_bytes", "1");
  write("sys/fs/cgroup/memory/memory.limit_in_bytes", "9223372036854771712");
  EXPECT_EQ(group_memory(root_), 400000u);
}

TEST_F(ControlGroups, OfAContainerMayHaveANameThatIsNotSeenInside) {
  write("proc/self/cgroup", "0::/../../outside");
  write("sys/fs/cgroup/memory.max", "500000");
  EXPECT_EQ(group_memory(root_), 500000u);
}

TEST(MemoryOfTheMachine, IsKnown) {
  const double bytes = usual_memory_limit().bytes;
  EXPECT_GT(bytes, 0);
  EXPECT_TRUE(std::isfinite(bytes));
}

}  // namespace
}  // namespace ligne
