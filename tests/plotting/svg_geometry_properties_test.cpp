/// Geometry that style attributes and style sheets give, and properties that are counted because they are not drawn.

#include "support/test.hpp"
#include "svg_text.hpp"

namespace ligne {
namespace {

using namespace test;

TEST(SvgGeometryProperties, StylesPlaceShapes) {
  const Rect disc = box_of(read("<circle style='cx:50px;cy:40px;r:5mm'/>"), "#000000");
  EXPECT_NEAR(disc.min.x, 50 - 5 * 96 / 25.4, 0.006) << "in px of the units at hand";
  EXPECT_NEAR((disc.min.y + disc.max.y) / 2, 40, 1e-9);
  expect_lines("<style>rect{x:10px;y:20px;width:30px}</style><rect x='1' y='1' width='1' height='5'/>",
               {"1000,2000 4000,2000 4000,2500 1000,2500 1000,2000 "}, "above the attributes");
  expect_lines("<style>rect{width:30px !important}</style><rect style='width:10px' height='5'/>",
               {"0,0 3000,0 3000,500 0,500 0,0 "}, "in the order of the cascade");
  expect_lines("<path d='M0 0H9' style='d:path(\"M0 5H20\")'/><path d='M0 9H9' style='d:none'/>", {"0,500 2000,500 "});
  expect_lines("<defs><path id='p' d='M0 0H9'/></defs><use href='#p' style='x:10px;y:20px'/>", {"1000,2000 1900,2000 "});
  const Rect ellipse = box_of(read("<ellipse cx='50' cy='50' style='rx:20px;ry:10px'/>"), "#000000");
  EXPECT_NEAR(ellipse.width(), 40, 0.012);
  EXPECT_NEAR(ellipse.height(), 20, 0.02);
  expect_lines("<line x1='1' x2='5' style='x1:3px'/>", {"100,0 500,0 "}, "which is no property of CSS");
  EXPECT_EQ(read("<circle r='5' style='r:calc(1px + 1px)'/>").omitted.list(), "1 values of r that are not known");
  EXPECT_EQ(read("<circle r='5' style='r:9'/>").omitted.list(), "1 values of r that are not known") << "without a unit";
}

TEST(SvgGeometryProperties, TransformsThatAreToldOneByOne) {
  expect_lines("<path d='M0 0H10' style='translate:20px 30px'/>", {"2000,3000 3000,3000 "});
  expect_lines("<path d='M0 0H10' style='rotate:90deg;translate:20px;scale:2 1'/>", {"2000,0 2000,2000 "},
               "in an order of their own");
  expect_lines("<path d='M0 0H10' transform='translate(1 0)' style='scale:2'/>", {"200,0 2200,0 "});
  EXPECT_EQ(read("<path d='M0 0H10' style='rotate:x 3deg'/>").omitted.list(), "1 values of rotate that are not known");
}

TEST(SvgGeometryProperties, DashesFollowThePathLength) {
  expect_lines("<path d='M0 0H100' pathLength='10' stroke-dasharray='2 3'/>", {"0,0 2000,0 ", "5000,0 7000,0 "});
  expect_lines("<path d='M0 0H50' transform='scale(2 1)' pathLength='10' stroke-dasharray='2 3'/>",
               {"0,0 2000,0 ", "5000,0 7000,0 "});
}

TEST(SvgGeometryProperties, WhatIsNotDrawnIsCounted) {
  const ReadDrawing sheet = read_svg_drawing("<?xml-stylesheet href='a.css'?>" + page("<path d='M0 0H10'/>"), "a.svg", {});
  EXPECT_EQ(sheet.omitted.list(), "1 style sheets of other files");
  for (const char* property : {"text-decoration:underline", "text-transform:uppercase", "offset-path:path(\"M0 0H5\")",
                               "vector-effect:non-scaling-size", "direction:rtl", "zoom:2"}) {
    const ReadDrawing drawing = read("<g style='" + std::string(property) + "'><path d='M0 0H10'/></g>");
    const std::string name = std::string(property).substr(0, std::string(property).find(':'));
    EXPECT_EQ(drawing.omitted.of("values of " + name + " that are not known"), 1u) << property;
    EXPECT_EQ(lines_of(drawing).size(), 1u);
  }
  for (const char* property : {"text-decoration:none", "text-transform:none", "vector-effect:none", "direction:ltr"})
    EXPECT_TRUE(read("<g style='" + std::string(property) + "'><path d='M0 0H10'/></g>").omitted.empty()) << property;
}

}  // namespace
}  // namespace ligne
