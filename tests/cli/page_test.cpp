#include <gtest/gtest.h>

#include "picture/errors.hpp"
#include "picture/parse/parse_options.hpp"
#include "picture/placement.hpp"

namespace ligne {
namespace {

constexpr Rect kWide{{0, 0}, {40, 10}}, kTall{{0, 0}, {10, 40}}, kSquare{{0, 0}, {10, 10}};

bool lies(const Page& page) { return page.width_mm > page.height_mm; }

TEST(PageOrientation, FollowsThePicture) {
  const PageRequest options;
  EXPECT_TRUE(lies(page_for(options, kWide)));
  EXPECT_FALSE(lies(page_for(options, kTall)));
  EXPECT_FALSE(lies(page_for(options, kSquare)));
  EXPECT_FALSE(lies(page_for(options, Rect{})));
  EXPECT_TRUE(lies(page_for(options, {{0, 5}, {3, 5}}))) << "a line across";
  EXPECT_FALSE(lies(page_for(options, {{5, 0}, {5, 3}}))) << "a line down";
  EXPECT_FALSE(lies(page_for(options, {{5, 5}, {5, 5}}))) << "a point";
}

TEST(PageOrientation, IsAsAskedFor) {
  PageRequest options;
  options.landscape = true;
  EXPECT_TRUE(lies(page_for(options, kTall)));
  options = {};
  options.portrait = true;
  EXPECT_FALSE(lies(page_for(options, kWide)));
  options = {};
  options.size.page = {300, 100, 10};
  options.size.explicit_size = true;
  EXPECT_TRUE(lies(page_for(options, kTall)));
  options.portrait = true;
  EXPECT_EQ(page_for(options, kWide).height_mm, 300);
}

TEST(PageSize, NamesTurnAndSizesStay) {
  EXPECT_FALSE(parse_page_size("A3").explicit_size);
  EXPECT_FALSE(parse_page_size("letter").explicit_size);
  const PageSize size = parse_page_size("20cmx15cm");
  EXPECT_TRUE(size.explicit_size);
  EXPECT_DOUBLE_EQ(size.page.width_mm, 200);
  EXPECT_DOUBLE_EQ(size.page.height_mm, 150);
  EXPECT_THROW(parse_page_size("A9"), std::invalid_argument);
}

TEST(PageMargin, MustLeaveSomething) {
  PageRequest options;
  options.margin_mm = 104.9;
  EXPECT_NO_THROW(check(options));
  EXPECT_EQ(page_for(options, kTall).margin_mm, 104.9);
  options.margin_mm = 105;
  EXPECT_THROW(check(options), RequestError);
}

TEST(PageScale, UnitAndRatioMultiply) {
  PageRequest options;
  EXPECT_FALSE(options.page_mm_per_unit(1));
  options.scale = 0.02;
  options.unit_mm = 1000;
  EXPECT_DOUBLE_EQ(*options.page_mm_per_unit(1), 20);
  options.unit_mm.reset();
  EXPECT_DOUBLE_EQ(*options.page_mm_per_unit(10), 0.2);
}

}  // namespace
}  // namespace ligne
