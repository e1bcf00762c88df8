#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include "plotting/page.hpp"

namespace ligne {
namespace {

TEST(Length, Units) {
  EXPECT_EQ(parse_length_mm("12"), 12);
  EXPECT_EQ(parse_length_mm("12mm"), 12);
  EXPECT_EQ(parse_length_mm("1.5cm"), 15);
  EXPECT_EQ(parse_length_mm("0.5in"), 12.7);
  EXPECT_DOUBLE_EQ(parse_length_mm("72pt"), 25.4);
  EXPECT_EQ(parse_length_mm(".25"), 0.25);
  EXPECT_EQ(parse_length_mm("1e2mm"), 100);
  EXPECT_EQ(parse_length_mm("0"), 0);
}

TEST(Length, MalformedLengthsAreNamedInOneLine) {
  for (const std::string text :
       {"",   "mm",     "a",  "1 mm", " 1",  "1mmm", "1m",    "1MM",   "1,5",  "1.5.2",   "--1", "+1",
        "-1", "-0.1mm", "-0", "nan",  "inf", "-inf", "infmm", "1e999", "0x10", "1e308in", "1mm2"}) {
    try {
      parse_length_mm(text);
      ADD_FAILURE() << "accepted: " << text;
    } catch (const std::invalid_argument& error) {
      const std::string what = error.what();
      EXPECT_NE(what.find(text), std::string::npos) << what;
      EXPECT_EQ(what.find('\n'), std::string::npos);
    }
  }
}

TEST(Pages, EveryNameInAnyCase) {
  const struct {
    const char* name;
    double width, height;
  } pages[] = {{"A0", 841, 1189},       {"A1", 594, 841},           {"A2", 420, 594},         {"A3", 297, 420},
               {"A4", 210, 297},        {"A5", 148, 210},           {"A6", 105, 148},         {"letter", 215.9, 279.4},
               {"legal", 215.9, 355.6}, {"tabloid", 279.4, 431.8},  {"a3", 297, 420},         {"LETTER", 215.9, 279.4},
               {"100x150", 100, 150},   {"10cmx15cm", 100, 150},    {"10cmx150mm", 100, 150}, {"8inx10in", 203.2, 254},
               {"8x10in", 203.2, 254},  {"72ptx144pt", 25.4, 50.8}, {"100X150", 100, 150}};
  for (const auto& page : pages) {
    EXPECT_DOUBLE_EQ(parse_page(page.name).width_mm, page.width) << page.name;
    EXPECT_DOUBLE_EQ(parse_page(page.name).height_mm, page.height) << page.name;
    EXPECT_EQ(parse_page(page.name).margin_mm, Page{}.margin_mm);
  }
}

TEST(Pages, MalformedPages) {
  for (const char* text : {"", "A7", "A", "A44", "x", "10x", "x10", "10x10x10", "-10x10", "0x10", "10x0", "10 x 10",
                           "nanx10", "1e9x10", "10kmx10", "letters", "A4 "}) {
    EXPECT_THROW(parse_page(text), std::invalid_argument) << text;
  }
}

TEST(LayerStyles, Widths) {
  for (const char* layer : {"outline", "border"}) EXPECT_DOUBLE_EQ(layer_style(layer, 0.5, false).width_mm, 0.5);
  for (const char* layer : {"intersection", "crease"}) EXPECT_DOUBLE_EQ(layer_style(layer, 0.5, false).width_mm, 0.35);
  for (const char* layer : {"mesh", "hidden", "behind-glass", "shadow"})
    EXPECT_DOUBLE_EQ(layer_style(layer, 0.5, false).width_mm, 0.25);
  EXPECT_EQ(layer_style("hidden", 0.5, false).dashes_mm, (std::vector<double>{3, 0.75}));
  EXPECT_TRUE(layer_style("hidden", 0.5, true).dashes_mm.empty());
  EXPECT_TRUE(layer_style("outline", 0.5, false).dashes_mm.empty());
}

}  // namespace
}  // namespace ligne
