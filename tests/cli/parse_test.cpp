#include "picture/parse/parse.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

namespace ligne {
namespace {

/// What the function says of the text, or "" when it takes it.
template <class Function>
std::string complaint(Function function) {
  try {
    function();
  } catch (const std::invalid_argument& e) {
    return e.what();
  }
  return "";
}

TEST(ParseNumber, TakesNumbersWholeOnly) {
  EXPECT_EQ(parse_number("12"), 12);
  EXPECT_EQ(parse_number("-0.5"), -0.5);
  EXPECT_EQ(parse_number("+2"), 2);
  EXPECT_EQ(parse_number("1e3"), 1000);
  for (const char* text : {"", " 1", "1 ", "1,5", "0x10", "nan", "inf", "-inf", "1e999", "abc", "12mm", "+-1", "+", "--1"}) {
    EXPECT_NE(complaint([&] { parse_number(text); }), "") << text;
  }
  EXPECT_EQ(complaint([] { parse_number("abc"); }), "\"abc\" is not a number");
  EXPECT_EQ(complaint([] { parse_number(""); }), "an empty text is not a number");
}

TEST(ParseNumber, Intervals) {
  EXPECT_EQ(parse_between("179.9", 0, 180, "degrees"), 179.9);
  EXPECT_EQ(complaint([] { parse_between("200", 0, 180, "degrees"); }), "200 is not between 0 and 180 degrees");
  EXPECT_NE(complaint([] { parse_between("0", 0, 180, "degrees"); }), "");
  EXPECT_NE(complaint([] { parse_between("180", 0, 180, "degrees"); }), "");
  EXPECT_EQ(parse_within("0", 0, 180, "degrees"), 0);
  EXPECT_EQ(parse_within("180", 0, 180, "degrees"), 180);
  EXPECT_EQ(complaint([] { parse_within("-1", 0, 180, ""); }), "-1 is not from 0 to 180");
  EXPECT_EQ(parse_positive("0.1"), 0.1);
  EXPECT_EQ(complaint([] { parse_positive("0"); }), "0 is not greater than 0");
}

TEST(ParseCount, WholeNumbersOfARange) {
  EXPECT_EQ(parse_count("1", 1, 8), 1u);
  EXPECT_EQ(parse_count("8", 1, 8), 8u);
  for (const char* text : {"0", "9", "-1", "1.5", "", "99999999999999999999", "2x"}) {
    EXPECT_NE(complaint([&] { parse_count(text, 1, 8); }), "") << text;
  }
}

TEST(ParsePoint, ThreeNumbers) {
  EXPECT_EQ(parse_point("1,-2,3.5"), Point3(1, -2, 3.5));
  EXPECT_EQ(parse_point("0,0,0"), Point3(0, 0, 0));
  for (const char* text : {"", "1", "1,2", "1,2,3,4", "1,2,", "a,b,c", "1, 2,3", "1;2;3", "1,2,nan"}) {
    EXPECT_NE(complaint([&] { parse_point(text); }), "") << text;
  }
  EXPECT_EQ(complaint([] { parse_vector("0,0,-0"); }), "\"0,0,-0\" has no direction");
}

TEST(ParseEdges, ListsAndGroups) {
  const LineClasses some = parse_edges("outline,mesh");
  EXPECT_TRUE(some.has(LineClass::outline) && some.has(LineClass::mesh));
  EXPECT_THROW(parse_edges("horizon"), std::invalid_argument) << "the curves of surfaces are no edges of models";
  EXPECT_FALSE(parse_edges("all").has(LineClass::horizon));
  EXPECT_FALSE(some.has(LineClass::crease) || some.has(LineClass::border) || some.has(LineClass::intersection));
  EXPECT_EQ(parse_edges("feature").bits, parse_edges("outline,crease,border,intersection").bits);
  EXPECT_EQ(parse_edges("all").bits, parse_edges("feature,mesh").bits);
  EXPECT_TRUE(parse_edges("all,shadow").has(LineClass::shadow));
  EXPECT_FALSE(parse_edges("all").has(LineClass::shadow)) << "borders of shadows are no edges of models";
  EXPECT_EQ(
      complaint([] { parse_edges("outline,edges"); }),
      "\"edges\" is not one of outline, border, intersection, crease, mesh, profile, shadow, suggestive, ridge, valley, "
      "detail, feature or all");
  EXPECT_NE(complaint([] { parse_edges(""); }), "");
  EXPECT_NE(complaint([] { parse_edges("outline,"); }), "");
}

TEST(ParseScale, FitOrRatio) {
  EXPECT_FALSE(parse_scale("fit"));
  EXPECT_EQ(parse_scale("1:50"), 0.02);
  EXPECT_EQ(parse_scale("2.5:1"), 2.5);
  for (const char* text : {"", "1", "0:1", "1:0", "-1:2", "1:2:3", "Fit", "1e300:1e-300", "a:b", ":"}) {
    EXPECT_NE(complaint([&] { parse_scale(text); }), "") << text;
  }
}

TEST(ParseUnit, NamesAndMillimetres) {
  EXPECT_EQ(parse_unit_mm("mm"), 1);
  EXPECT_EQ(parse_unit_mm("cm"), 10);
  EXPECT_EQ(parse_unit_mm("m"), 1000);
  EXPECT_EQ(parse_unit_mm("in"), 25.4);
  EXPECT_EQ(parse_unit_mm("304.8"), 304.8);
  for (const char* text : {"", "ft", "0", "-1", "1mm"}) EXPECT_NE(complaint([&] { parse_unit_mm(text); }), "") << text;
}

TEST(ParseAxis, Letters) {
  EXPECT_EQ(parse_axis("x"), Axis::x);
  EXPECT_EQ(parse_axis("y"), Axis::y);
  EXPECT_EQ(parse_axis("z"), Axis::z);
  EXPECT_EQ(complaint([] { parse_axis("w"); }), "\"w\" is not one of x, y or z");
}

TEST(OutputFormats, BySuffixOrName) {
  EXPECT_EQ(format_of_suffix("a.svg"), OutputFormat::svg);
  EXPECT_EQ(format_of_suffix("folder.svg/A B.PDF"), OutputFormat::pdf);
  EXPECT_EQ(format_of_suffix("é.Png"), OutputFormat::png);
  EXPECT_EQ(format_of_suffix("x.tar.json"), OutputFormat::json);
  for (const char* name : {"a", "a.", "a.svgz", ".svg", "a.svg/b"}) {
    EXPECT_NE(complaint([&] { format_of_suffix(name); }), "") << name;
  }
  EXPECT_EQ(complaint([] { format_of_suffix("a.dxf"); }),
            "\"a.dxf\" does not end in .svg, .pdf, .png, .json, .hpgl, .plt, .gcode or .nc, and there is no --format");
  EXPECT_EQ(parse_format("json"), OutputFormat::json);
  EXPECT_NE(complaint([] { parse_format("SVG "); }), "");
}

}  // namespace
}  // namespace ligne
