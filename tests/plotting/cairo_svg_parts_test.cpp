/// Documents of Cairo 1.16 and 1.18 taken apart, and what is refused. tests/plotting/cairo/make_sample.py wrote the samples.

#include <fstream>
#include <iterator>
#include <stdexcept>

#include <gtest/gtest.h>

#include "plotting/cairo_svg_parts.hpp"

namespace ligne {
namespace {

std::string sample(const std::string& version) {
  std::ifstream in(LIGNE_SOURCE_DIR "/tests/plotting/cairo/cairo-" + version + ".svg");
  return {std::istreambuf_iterator<char>(in), {}};
}

std::string commands_of(const CairoSvgPart& part) {
  std::string text;
  for_each_command(part, [&](char command, const Point2* points) {
    text += command;
    for (int i = 0; i < (command == 'Z' ? 0 : command == 'C' ? 3 : 1); ++i) {
      text += std::to_string(std::lround(points[i].x * 10)) + "," + std::to_string(std::lround(points[i].y * 10)) + " ";
    }
  });
  return text;
}

class CairoSvgParts : public testing::TestWithParam<const char*> {};

TEST_P(CairoSvgParts, TheSampleHasItsPartsInOrder) {
  std::string document = sample(GetParam());
  const std::vector<CairoSvgPart> parts = cairo_svg_parts(document, 2000);
  ASSERT_EQ(parts.size(), 5u);
  EXPECT_EQ(parts[0].image.substr(0, 33), "data:image/png;base64,iVBORw0KGgo");
  EXPECT_EQ(parts[0].to_document({0, 0}), (Point2{100, 200}));
  EXPECT_EQ(parts[0].to_document(parts[0].pixels), (Point2{250, 250}));

  EXPECT_EQ(parts[1].fill, "#804000");
  EXPECT_EQ(parts[1].stroke, "#804000") << "its rim";
  EXPECT_EQ(parts[1].fill_opacity, 1);
  EXPECT_EQ(commands_of(parts[1]),
            "M12500,12500 L17500,12500 L17500,17500 L12500,17500 ZM13750,13750 L16250,13750 L16250,16250 L13750,16250 "
            "ZM13750,13750 ");

  EXPECT_EQ(parts[2].fill, "#ff0000");
  EXPECT_FALSE(parts[2].stroke);
  EXPECT_EQ(parts[2].fill_opacity, 0.3);
  EXPECT_EQ(commands_of(parts[2]), "M5000,5000 L7500,5000 L7500,7500 L5000,7500 ZM5000,5000 ");

  EXPECT_FALSE(parts[3].fill);
  EXPECT_EQ(parts[3].stroke, "#000000");
  EXPECT_EQ(commands_of(parts[3]),
            "M11250,12500 L7500,15000 L7000,11235 M15000,15000 L15000,15000 M10000,10000 L12500,10000 L12500,12500 "
            "ZM15000,10000 C15000,12500 12500,15000 10000,15000 ");
  EXPECT_EQ(commands_of(parts[4]), "M100,200 L305,400 ") << "without a transform, and dashed";
}

INSTANTIATE_TEST_SUITE_P(Versions, CairoSvgParts, testing::Values("1.16", "1.18"),
                         [](const auto& info) { return info.index == 0 ? "Cairo116" : "Cairo118"; });

std::string error_of(std::string document) {
  try {
    for (const CairoSvgPart& part : cairo_svg_parts(document, 2000)) commands_of(part);
  } catch (const std::runtime_error& e) {
    return e.what();
  }
  return "";
}

std::string page(const std::string& body) {
  return "<svg width='2000pt' height='2000pt' viewBox='0 0 2000 2000'>" + body + "</svg>";
}

const std::string kLook = "fill='none' stroke='rgb(0%, 0%, 0%)' ";

TEST(CairoSvgForms, GroupsMayStandInGroups) {
  std::string document = page("<g id='a'><g><path " + kLook + "d='M 1 2 L 3 4 '/></g></g>");
  const std::vector<CairoSvgPart> parts = cairo_svg_parts(document, 2000);
  ASSERT_EQ(parts.size(), 1u);
  EXPECT_EQ(commands_of(parts[0]), "M10,20 L30,40 ");
}

TEST(CairoSvgForms, TheUnitOfTheWidthDoesNotMatter) {
  for (const std::string unit : {"", "pt", "mm"}) {
    EXPECT_EQ(error_of("<svg width='2000" + unit + "' viewBox='0 0 2000 2000'/>"), "") << unit;
  }
}

TEST(CairoSvgForms, AFormThatIsUnknownIsAnError) {
  const std::string line = "d='M 1 2 L 3 4 '/>",
                    image = "<defs><image id='i' width='1' height='1' xlink:href='data:'/></defs>";
  const std::string unknown[] = {
      page("<g clip-path='url(#clip-0)'><path " + kLook + line + "</g>"),
      page("<g opacity='0.5'><path " + kLook + line + "</g>"),
      page("<use xlink:href='#image-1'/>"),
      page(image + "<use xlink:href='#i' mask='url(#m)'/>"),
      page(image + "<use xlink:href='#i' transform='rotate(9)'/>"),
      page("<defs><image id='i' x='3' xlink:href='data:'/></defs><use xlink:href='#i'/>"),
      page("<rect x='0' y='0' width='1' height='1'/>"),
      page("<text>a</text>"),
      page("letters"),
      page("<path fill='url(#pattern-0)' " + line),
      page("<path fill='red' " + line),
      page("<path fill='rgb(1%, 2%)' " + line),
      page("<path fill='rgb(1, 2, 3)' " + line),
      page("<path fill-rule='nonzero' fill='rgb(0%, 0%, 0%)' " + line),
      page("<path stroke-dashoffset='3' " + kLook + line),
      page("<path style='fill:none;colour:none;' " + line),
      page("<path style='fill;' " + line),
      page("<path transform='turn(3)' " + kLook + line),
      page("<path " + kLook + "d='M 1 2 l 3 4 '/>"),
      page("<path " + kLook + "d='L 1 2 '/>"),
      page("<path " + kLook + "d='M 1 2 L 3 4 Z L 5 6 '/>"),
      page("<path " + kLook + "d='M 1 2 L 3 '/>"),
      page("<path " + kLook + "d='M 1 2 A 3 3 0 0 0 5 6 '/>"),
      "<svg width='2000pt' viewBox='0 0 1000 2000'/>",
      "<svg width='2000pt'/>",
      "<svg viewBox='0 0 2000 2000'><path",
      "",
  };
  for (const std::string& document : unknown) EXPECT_EQ(error_of(document).substr(0, 7), "cairo: ") << document;
}

}  // namespace
}  // namespace ligne
