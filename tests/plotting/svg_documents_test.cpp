/// SVG documents as programs write them: entities, units, crowds.

#include "support/test.hpp"
#include "svg_text.hpp"

namespace ligne {
namespace {

using namespace test;

ReadDrawing read_document(const std::string& text, double px_per_inch = 96) {
  return read_svg_drawing(text, "a.svg", {}, {}, {.px_per_inch = px_per_inch});
}

const std::string kSize = " width='100mm' height='100mm' viewBox='0 0 100 100' fill='none' stroke='black'>";

TEST(SvgDocuments, InternalEntitiesAreExpanded) {
  const std::string type =
      "<?xml version='1.0'?>\n<!-- a --><!DOCTYPE svg PUBLIC \"-//W3C//DTD SVG 1.1//EN\" \"svg11.dtd\" [\n"
      "<!-- <!ENTITY st0 \"x\"> --><!ENTITY ns_svg \"http://www.w3.org/2000/svg\">\n"
      "<!ENTITY st0 \"fill:none;stroke:#ED1C24;\"> <!ENTITY st0 'stroke:none'>\n"
      "<!ENTITY quoted 'a\"b'> <!ENTITY shapes '<line x2=\"5\"/>&more;'> <!ENTITY more '<line x2=\"6\"/>\n'>\n"
      "<!ENTITY % none 'x'> <!ENTITY far SYSTEM 'far.svg'> <!ENTITY amp2 '&#38;#38;'>]>\n";
  const ReadDrawing read =
      read_document(type + "<svg xmlns='&ns_svg;'" + kSize +
                    "<g style='&st0;' id='&quoted;'>&shapes;&far;</g><title>&amp; &unknown; &amp2;</title>"
                    "<![CDATA[&shapes;]]><!-- &shapes; --></svg>");
  EXPECT_EQ(lines_of(read), (Lines{"0,0 500,0 ", "0,0 600,0 "}));
  EXPECT_EQ(read.drawing.layers.at(0).name, "#ed1c24");
  EXPECT_EQ(read.omitted.list(), "1 entities of other files");
}

TEST(SvgDocuments, EntitiesDoNotMoveLines) {
  const ReadDrawing read = read_document("<!DOCTYPE svg [<!ENTITY a '\n\n\n'>]>\n<svg" + kSize + "&a;\n<image/></svg>");
  EXPECT_EQ(read.first_omitted_line, 6u);
}

TEST(SvgDocuments, EntitiesDoNotGrowWithoutBounds) {
  const auto failure = [](const std::string& declarations) {
    return failure_of(
        [&] { read_document("<!DOCTYPE svg [" + declarations + "]><svg" + kSize + "<text>&z;</text></svg>"); });
  };
  EXPECT_NE(failure("<!ENTITY z '&z;'>").find("contain each other"), std::string::npos);
  EXPECT_NE(failure("<!ENTITY z '&y;&y;'><!ENTITY y '&z;'>").find("contain each other"), std::string::npos);
  std::string bomb = "<!ENTITY a0 'ha'>", empty = "<!ENTITY a0 ''>", last;
  for (int i = 1; i < 16; ++i) {
    std::string value;
    for (int k = 0; k < 10; ++k) value += "&a" + std::to_string(i - 1) + ";";
    last = "<!ENTITY " + (i == 15 ? "z" : "a" + std::to_string(i)) + " '" + value + "'>";
    bomb += last;
    empty += last;
  }
  EXPECT_NE(failure(bomb).find("entities"), std::string::npos);
  EXPECT_NE(failure(empty).find("four million references"), std::string::npos);
}

TEST(SvgDocuments, CrowdsOfSiblingsAreNumberedOnce) {
  std::string body = "<style>line:nth-child(2n+1){stroke:none}</style>";
  constexpr int kLines = 40'000;
  for (int i = 0; i < kLines; ++i) body += "<line x2='1'/>";
  EXPECT_EQ(lines_of(read(body)).size(), kLines / 2u);
}

TEST(SvgDocuments, VariablesDoNotGrowWithoutBounds) {
  std::string bomb = "--a0:xxxxxxxxxxxxxxxx;";
  for (int i = 1; i < 40; ++i) {
    const std::string before = "var(--a" + std::to_string(i - 1) + ")";
    bomb += "--a" + std::to_string(i) + ":" + before + before + ";";
  }
  EXPECT_EQ(read("<line x2='5' style='" + bomb + "stroke:var(--a39)'/>").omitted.list(),
            "1 values of stroke that are not known");
}

TEST(SvgDocuments, UnitsOfLengths) {
  const auto end = [](const std::string& body) { return line_of(body).back(); };
  EXPECT_NEAR(end("<line font-size='10' x2='2em' y2='2ex'/>").x, 20, 1e-9);
  EXPECT_NEAR(end("<line font-size='10' x2='2em' y2='2ex'/>").y, 10, 1e-9);
  EXPECT_NEAR(end("<g font-size='10'><line font-size='2em' x2='2ch' y2='1em'/></g>").y, 20, 1e-9) << "of its own font";
  EXPECT_NEAR(end("<g font-size='10'><line x2='1rem'/></g>").x, 16, 1e-9);
  EXPECT_NEAR(end("<line x2='50%' y2='10vw'/>").x, 50, 1e-9);
  EXPECT_NEAR(end("<line x2='50%' y2='10vw'/>").y, 0.1 * 100 / 25.4 * 96, 1e-9) << "of a window as large as the page";
  EXPECT_NEAR(end("<line x2='40Q'/>").x, 96 / 2.54, 1e-9);
  EXPECT_NEAR(read("<line x2='9' stroke-width='10%'/>").drawing.layers.at(0).width_mm.value(), 10, 1e-9);
  EXPECT_GT(line_of("<rect width='10' height='20' rx='5' ry='auto'/>").size(), 9u);
}

TEST(SvgDocuments, ResolutionOfTheInput) {
  const auto page_of = [](const std::string& attributes, double px_per_inch = 96) {
    return read_document("<svg " + attributes + "><line stroke='red' x2='72' y2='1in'/></svg>", px_per_inch);
  };
  const ReadDrawing paper = page_of("viewBox='0 0 595 842'");
  EXPECT_EQ(paper.paper_of_view_box, "A4");
  EXPECT_EQ(paper.paper_dpi, 72);
  EXPECT_NEAR(paper.page.width_mm, 595 * 25.4 / 96, 1e-9) << "said, not done";
  EXPECT_EQ(page_of("width='100%' height='100%' viewBox='0 0 1052.36 744.09'").paper_dpi, 90) << "lying";
  EXPECT_EQ(page_of("viewBox='0 0 2550 3300'").paper_of_view_box, "letter");
  EXPECT_EQ(page_of("viewBox='0 0 793.7 1122.5'").paper_of_view_box, "") << "right as it is";
  EXPECT_EQ(page_of("width='595' height='842' viewBox='0 0 595 842'").paper_of_view_box, "") << "has a size";
  const ReadDrawing right = page_of("viewBox='0 0 595.28 841.89'", 72);
  EXPECT_EQ(right.paper_of_view_box, "");
  EXPECT_NEAR(right.page.width_mm, 210, 0.01);
  EXPECT_NEAR(glm::distance(right.drawing.layers.at(0).lines[0].back(), Point2(25.4, 25.4)), 0, 1e-9)
      << "inches stay inches";
}

}  // namespace
}  // namespace ligne
