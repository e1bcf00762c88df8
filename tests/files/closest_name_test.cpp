#include "files/closest_name.hpp"
#include "support/test.hpp"

namespace ligne {
namespace {

const std::vector<std::string_view> kNames{"--hide", "--hidden", "--view", "-x", "--x-ray", "--edges"};
const std::vector<std::string_view> kViews{"front", "bottom", "iso", "dimetric", "trimetric"};

std::string_view meant(std::string_view word, const std::vector<std::string_view>& names = kNames) {
  return closest_name(word, names).value_or("");
}

TEST(ClosestName, IsWhatSlipsOfTheKeysMakeOf) {
  EXPECT_EQ(meant("--veiw"), "--view");      // exchanged
  EXPECT_EQ(meant("--vieww"), "--view");     // added
  EXPECT_EQ(meant("--wiew=top"), "--view");  // replaced
  EXPECT_EQ(meant("--hiden"), "--hidden");   // left out, sooner than added to --hide
  EXPECT_EQ(meant("--x"), "-x");
  EXPECT_EQ(meant("-hidden"), "--hidden");
  EXPECT_EQ(meant("--hyddin"), "--hidden");
}

TEST(ClosestName, IsWhatIsWrittenShorterOrLonger) {
  EXPECT_EQ(meant("isometric", kViews), "iso");
  EXPECT_EQ(meant("trim", kViews), "trimetric");
  EXPECT_EQ(meant("bot", kViews), "bottom");
  EXPECT_EQ(meant("is", kViews), "");  // two letters begin too much
  EXPECT_EQ(meant("hid"), "--hide");
}

TEST(ClosestName, IsNoneWhereNoneIsNear) {
  EXPECT_EQ(meant("--y"), "");
  EXPECT_EQ(meant("--veeew"), "");
  EXPECT_EQ(meant("--frobnicate"), "");
  EXPECT_EQ(meant("--"), "");
  EXPECT_EQ(meant(""), "");
  EXPECT_EQ(meant(std::string(100'000, 'x')), "");
  EXPECT_EQ(closest_name("--view", {}), std::nullopt);
}

}  // namespace
}  // namespace ligne
