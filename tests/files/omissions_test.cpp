#include "files/omissions.hpp"

#include "support/test.hpp"

namespace ligne {
namespace {

TEST(Omissions, OneLineNamesKindsInTheirOrder) {
  Omissions omitted;
  EXPECT_TRUE(omitted.empty());
  EXPECT_EQ(omitted.text(), "");
  omitted.count("textures");
  omitted.count("primitives with EXT_foo", 2);
  omitted.count("textures", 3);
  omitted.count("nothing", 0);
  EXPECT_EQ(omitted.text(), "left out: 4 textures, 2 primitives with EXT_foo");
  EXPECT_EQ(omitted.of("textures"), 4u);
  EXPECT_EQ(omitted.of("nothing"), 0u);
}

TEST(Omissions, NamesOfTheFileAreMadePrintable) {
  Omissions omitted;
  omitted.count("statements \x1b[2J\nligne: all is well");
  EXPECT_EQ(omitted.list(), "1 statements \\x1b[2J\\nligne: all is well");
}

TEST(Omissions, AMillionKindsAreAFew) {
  Omissions omitted;
  for (int i = 0; i < 1'000'000; ++i) omitted.count("statements " + std::to_string(i));
  EXPECT_EQ(omitted.counts().size(), 17u);
  EXPECT_EQ(omitted.of("other items"), 999'984u);
}

}  // namespace
}  // namespace ligne
