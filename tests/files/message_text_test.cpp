#include "files/message_text.hpp"

#include <gtest/gtest.h>

#include "files/input_error.hpp"

namespace ligne {
namespace {

TEST(MessageText, PlainTextStaysAsItIs) {
  EXPECT_EQ(printable(""), "");
  EXPECT_EQ(printable("a b\\n'\"?"), "a b\\n'\"?");
  EXPECT_EQ(printable("caf\xc3\xa9 \xe2\x82\xac \xf0\x9f\x96\x8b"), "caf\xc3\xa9 \xe2\x82\xac \xf0\x9f\x96\x8b");
  EXPECT_EQ(shown("x"), "'x'");
  EXPECT_EQ(shown("x", '"'), "\"x\"");
}

TEST(MessageText, WhatDoesNotShowIsEscaped) {
  EXPECT_EQ(printable("a\nb\rc\td"), "a\\nb\\rc\\td");
  EXPECT_EQ(printable(std::string_view("\0\x1b[31m\x7f", 7)), "\\x00\\x1b[31m\\x7f");
  EXPECT_EQ(printable("\xc2\x85"), "\\xc2\\x85") << "next line, of the second row of controls";
  EXPECT_EQ(printable("\xe2\x80\xa8"), "\\xe2\\x80\\xa8") << "line separator";
  EXPECT_EQ(printable("\xe2\x80\xae"), "\\xe2\\x80\\xae") << "turns the direction of what follows";
}

TEST(MessageText, WhatIsNotUtf8IsEscaped) {
  EXPECT_EQ(printable("\x80\xff"), "\\x80\\xff");
  EXPECT_EQ(printable("\xc3"), "\\xc3") << "cut off";
  EXPECT_EQ(printable("\xc3 "), "\\xc3 ");
  EXPECT_EQ(printable("\xc0\xaf"), "\\xc0\\xaf") << "written longer than need be";
  EXPECT_EQ(printable("\xe0\x80\xaf"), "\\xe0\\x80\\xaf");
  EXPECT_EQ(printable("\xed\xa0\x80"), "\\xed\\xa0\\x80") << "half of a pair";
  EXPECT_EQ(printable("\xf4\x90\x80\x80"), "\\xf4\\x90\\x80\\x80") << "beyond Unicode";
}

TEST(MessageText, LongTextIsCutBetweenCharacters) {
  const std::string most(kLongestShown, 'x');
  EXPECT_EQ(printable(most), most);
  std::string cut = most;
  cut.append("...");
  EXPECT_EQ(printable(most + "x"), cut);
  EXPECT_EQ(printable("12\xc3\xa9", 3), "12...");
  EXPECT_EQ(printable("12\n", 3), "12...");
  EXPECT_EQ(printable(std::string(5'000'000, '\x01')).size(), kLongestShown + 3);
}

TEST(MessageText, AMessageIsOneLineAndLosesItsMiddle) {
  EXPECT_EQ(message_line("file:3: cause\n"), "file:3: cause");
  EXPECT_EQ(message_line("a\nb"), "a\\nb");
  const std::string long_line = message_line("file: " + std::string(5'000'000, 'x') + ": the cause");
  EXPECT_EQ(long_line.size(), kLongestMessage);
  EXPECT_TRUE(long_line.starts_with("file: xxx"));
  EXPECT_TRUE(long_line.ends_with("xxx: the cause"));
  EXPECT_EQ(message_line(long_line), long_line);
  for (std::size_t n = 480; n < 500; ++n) {
    std::string odd(n, 'x');
    for (int i = 0; i < 300; ++i) odd += "\xe2\x82\xac";
    const std::string line = message_line(odd);
    EXPECT_LE(line.size(), kLongestMessage);
    EXPECT_EQ(line.find("\\x"), std::string::npos) << "a character was cut: " << line;
    EXPECT_EQ(message_line(line), line);
  }
}

TEST(MessageText, ErrorsOfInputAreSuchLines) {
  EXPECT_STREQ(InputError("a\nb", "is odd").what(), "a\\nb: is odd");
  EXPECT_EQ(std::string(InputError("f", std::string(1000, 'x')).what()).size(), kLongestMessage);
}

}  // namespace
}  // namespace ligne
