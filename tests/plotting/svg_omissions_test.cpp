/// Parts of an SVG that can not be drawn cost no more than themselves, and are counted.

#include "support/test.hpp"
#include "svg_text.hpp"

namespace ligne {
namespace {

using namespace test;

/// The lines that are drawn, and what was left out, as the warning has it.
void expect_omitted(const std::string& body, const Lines& wanted, const std::string& omitted) {
  const ReadDrawing drawing = read(body);
  EXPECT_EQ(lines_of(drawing), wanted) << body;
  EXPECT_EQ(drawing.omitted.list(), omitted) << body;
}

TEST(SvgOmissions, PathsAreDrawnUpToTheirErrors) {
  expect_omitted("<path d='M10 10L20 20LNaN,30L40 10'/><path d='M10 50L90 50'/>",
                 {"1000,1000 2000,2000 ", "1000,5000 9000,5000 "}, "1 ends of <path> elements after an error");
  expect_omitted("<path d='M'/><path d='M10 10H90'/>", {"1000,1000 9000,1000 "}, "1 ends of <path> elements after an error");
  expect_omitted("<path d='M1 1H2X3'/><path d='H3'/><path d='M0 0A1 1 0 2 0 5 5'/><path d=''/>", {"100,100 200,100 "},
                 "3 ends of <path> elements after an error");
  expect_omitted("<polyline points='1 2 3 4 5'/><polygon points='0 0 9 0 9 9 x'/>",
                 {"100,200 300,400 ", "0,0 900,0 900,900 0,0 "},
                 "1 ends of <polyline> elements after an error, 1 ends of <polygon> elements after an error");
}

TEST(SvgOmissions, BadValuesAreAsIfTheyWereNotThere) {
  expect_omitted("<g transform='translate(NaN,5)'><path d='M10 60L90 60'/></g>", {"1000,6000 9000,6000 "},
                 "1 values of transform that are not known");
  expect_omitted(
      "<line x1='nan' x2='5furlongs' y2='9' stroke='?'/>", {"0,0 0,900 "},
      "1 values of stroke that are not known, 1 values of x1 that are not known, 1 values of x2 that are not known");
  expect_omitted("<line x2='5' style='stroke-width:null;stroke-dasharray:-1;stroke-dashoffset:x'/>", {"0,0 500,0 "},
                 "1 values of stroke-width that are not known, 1 values of stroke-dasharray that are not known, 1 values of "
                 "stroke-dashoffset that are not known");
  expect_omitted("<svg viewBox='0 0 1'><line x2='5'/></svg><text x='q'> </text>", {"0,0 500,0 "},
                 "1 values of viewBox that are not known, 1 values of x that are not known");
  const ReadDrawing inherited = read("<g stroke='red'><line x2='1' stroke='nonsense(1)'/></g>");
  EXPECT_EQ(inherited.drawing.layers.at(0).name, "#ff0000");
  EXPECT_EQ(inherited.first_omitted_line, 2u);
}

TEST(SvgOmissions, AnElementIsCountedOnceHoweverOftenItIsShown) {
  expect_omitted("<path id='p' d='M0 0H1L?'/><use href='#p' x='1'/><use href='#p' x='2'/>",
                 {"0,0 100,0 ", "100,0 200,0 ", "200,0 300,0 "}, "1 ends of <path> elements after an error");
}

TEST(SvgOmissions, WhatIsNotStrokesIsLeftOut) {
  expect_omitted("<image/><image/><foreignObject/><line x2='5'/><animate/>", {"0,0 500,0 "},
                 "2 images, 1 foreignObject elements, 1 animations");
  expect_omitted("<g clip-path='circle(5px)'><line x2='5'/></g><line x2='6' filter='url(#f)'/><note/>",
                 {"0,0 500,0 ", "0,0 600,0 "}, "1 clip paths that are not shapes, 1 filters, 1 <note> elements");
  expect_omitted("<use href='a.svg#b'/><line x2='1e300' transform='scale(1e300)'/><line x2='5'/>", {"0,0 500,0 "},
                 "1 <use> elements that lead out of the file, 1 elements farther than a kilometre away");
  const ReadDrawing text = read("<text y='9'><textPath href='#p'>a</textPath>b</text>");
  EXPECT_EQ(text.omitted.list(), "1 <textPath> elements in texts");
  EXPECT_GT(lines_of(text).size(), 0u) << "the rest of the text";
}

TEST(SvgOmissions, ClipPathsThatCanNotBeDrawnClipNothing) {
  expect_omitted("<clipPath id='c'><rect width='3' height='9'/><text>a</text></clipPath><line x2='5' clip-path='url(#c)'/>",
                 {"0,0 500,0 "}, "1 clip paths that are not shapes");
  expect_omitted(
      "<clipPath id='c'><rect width='3' height='9'/><g><rect width='9' height='9'/></g></clipPath>"
      "<line x2='5' clip-path='url(#c)'/>",
      {"0,0 300,0 "}, "");
}

TEST(SvgOmissions, LinksThatLeadBackToThemselvesShowNothing) {
  expect_omitted("<g id='a'><line x2='5'/><use href='#a' x='1'/></g>", {"0,0 500,0 "},
                 "1 <use> elements that lead back to themselves");
  expect_omitted("<g id='a'><line x2='5'/><use href='#b'/></g><g id='b'><use href='#a' y='9'/></g>",
                 {"0,0 500,0 ", "0,900 500,900 "}, "2 <use> elements that lead back to themselves");
  expect_omitted("<use id='u' href='#u'/><use href=''/><line x2='5'/>", {"0,0 500,0 "},
                 "1 <use> elements that lead back to themselves");
  expect_omitted("<marker id='m'><path d='M0 0h1' marker-end='url(#m)'/></marker><line x2='5' marker-end='url(#m)'/>",
                 {"0,0 500,0 ", "500,0 600,0 "}, "1 markers that refer to themselves");
}

TEST(SvgOmissions, StyleSheetsAreThoseForPrint) {
  const Lines dashed{"0,0 200,0 ", "300,0 500,0 "}, whole{"0,0 500,0 "};
  const auto sheet = [](const std::string& media) {
    return "<style media='" + media + "'>line{stroke-dasharray:2 1}</style><line x2='5'/>";
  };
  for (const char* media : {"", "all", "print", "Print", "screen, print", "only print", "not screen"})
    expect_omitted(sheet(media), dashed, "");
  for (const char* media : {"screen", "not print", "print and (min-width: 9px)", "screen and (color), speech"})
    expect_omitted(sheet(media), whole, "1 style sheets for other media than print");
  for (const char* media : {"all", "print", "screen, print"})
    expect_omitted("<style>@media " + std::string(media) + "{line{stroke-dasharray:2 1}}</style><line x2='5'/>", dashed, "");
  expect_omitted("<style>@media screen{line{stroke-dasharray:2 1}}</style><line x2='5'/>", whole, "1 @media rules");
}

TEST(SvgOmissions, StyleSheetsLoseOnlyWhatIsNotKnown) {
  const std::string line = "<line class='a' x2='5'/>";
  expect_omitted("<style>@import url(\"https://a.org/css?family=A;b\"); .a{stroke-dasharray:2 1}</style>" + line,
                 {"0,0 200,0 ", "300,0 500,0 "}, "1 @import rules");
  expect_omitted(
      "<style>@media screen{.a{stroke:none}} @supports (x:y){.a{stroke:none} .b{}} .a{stroke-dasharray:2 1}</style>" + line,
      {"0,0 200,0 ", "300,0 500,0 "}, "1 @media rules, 1 @supports rules");
  expect_omitted("<style>@media print{.a{stroke-dasharray:2 1}} @media all and (x){.a{display:none}}</style>" + line,
                 {"0,0 200,0 ", "300,0 500,0 "}, "1 @media rules");
  expect_omitted(
      "<style>.a:link{stroke:none} line:foo(x), .a{stroke-dasharray:2 1} ;?{} .a{.b{stroke:none}}</style>" + line,
      {"0,0 200,0 ", "300,0 500,0 "},
      "1 style rules with :link, 1 style rules with :foo, 1 style rules with unknown selectors, 1 style rules inside "
      "others");
  expect_omitted("<style>.a{stroke-dasharray:2 1} } .b{</style>" + line, {"0,0 200,0 ", "300,0 500,0 "},
                 "1 style rules with unknown selectors");
}

TEST(SvgOmissions, PaintsThatAreNotThere) {
  expect_omitted(
      "<line x2='5' stroke='url(#none)'/><line x2='6' stroke='url(#none) none'/><line id='l' x2='7' stroke='url(#l) red'/>",
      {"0,0 700,0 "}, "2 gradients and patterns missing from the file");
}

TEST(SvgOmissions, OtherLanguagesAndForeignAlternatives) {
  expect_omitted(
      "<switch><random/><line x2='5'/></switch><g systemLanguage='de, fr'><line x2='6'/></g>"
      "<line x2='7' systemLanguage='de, en-GB'/>",
      {"0,0 500,0 ", "0,0 700,0 "}, "");
}

TEST(SvgOmissions, WritingModes) {
  const ReadDrawing down = read("<g writing-mode='tb'><text y='9'>a</text></g>");
  EXPECT_EQ(down.omitted.list(), "1 values of writing-mode that are not known");
  EXPECT_GT(lines_of(down).size(), 0u);
}

TEST(SvgOmissions, DeepElementsAreLeftOut) {
  std::string deep, end;
  for (int i = 0; i < 5000; ++i) deep += "<g>", end += "</g>";
  expect_omitted(deep + "<line x2='9'/>" + end + "<line x2='5'/>", {"0,0 500,0 "},
                 "1 elements nested deeper than 200 elements");
}

TEST(SvgOmissions, StrictReadingRefuses) {
  for (const char* body : {"<path d='M1 1H2X3'/>", "<image/>", "<style>@import 'a';</style>", "<line x2='5' stroke='?'/>"})
    EXPECT_NE(error_of(page(body)), "") << body;
  EXPECT_EQ(error_of(page("<line x2='5' filter='url(#f)'/><note/>")), "") << "what was never refused";
}

}  // namespace
}  // namespace ligne
