/// SVG documents as programs write them: entities, prefixes, style sheets, variables, units.

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

TEST(SvgDocuments, PrefixesOfAnyName) {
  const ReadDrawing read = read_document(
      "<ns0:svg xmlns:ns0='http://www.w3.org/2000/svg' xmlns:ns1='http://www.inkscape.org/namespaces/inkscape' "
      "xmlns:xl='http://www.w3.org/1999/xlink'" +
      kSize +
      "<ns0:g ns1:groupmode='layer' ns1:label='1 cut'><ns0:path id='p' d='M10 10H90' stroke='red'/></ns0:g>"
      "<ns0:g ns1:groupmode='layer' ns1:label='2 mark'><ns0:use xl:href='#p' transform='translate(0 20)'/></ns0:g>"
      "<ns1:path d='M0 0H1'/><path xmlns='http://example.org' d='M0 0H2'/></ns0:svg>");
  ASSERT_EQ(read.drawing.layers.size(), 2u);
  EXPECT_EQ(read.drawing.layers[0].name, "1 cut");
  EXPECT_EQ(read.drawing.layers[1].name, "2 mark");
  EXPECT_EQ(lines_of(read), (Lines{"1000,1000 9000,1000 ", "1000,3000 9000,3000 "}));
  const ReadDrawing mixed =
      read_document("<svg xmlns='http://www.w3.org/2000/svg' xmlns:s='http://www.w3.org/2000/svg'" + kSize +
                    "<x xmlns='http://example.org'><s:line x2='3'/></x><s:line x2='4'/><line x2='5'/>"
                    "<line xmlns='http://example.org' x2='6'/></svg>");
  EXPECT_EQ(lines_of(mixed), (Lines{"0,0 400,0 ", "0,0 500,0 "}));
  EXPECT_EQ(lines_of(read_document("<svg:svg" + kSize + "<svg:line x2='5'/></svg:svg>")), Lines{"0,0 500,0 "});
}

TEST(SvgDocuments, Selectors) {
  const auto dashed = [](const std::string& selector) {
    return lines_of(read("<style>" + selector +
                         "{stroke:none}</style><g class='p'><line class='a b' x2='1'/><line id='i' x2='2'/>"
                         "<path d='M0 0H3'/></g><line class='a' x2='4'/><rect class='c:d' width='5' height='5'/>"));
  };
  const std::string l1 = "0,0 100,0 ", l2 = "0,0 200,0 ", l3 = "0,0 300,0 ", l4 = "0,0 400,0 ",
                    r = "0,0 500,0 500,500 0,500 0,0 ";
  EXPECT_EQ(dashed(":where(.p) line"), (Lines{l3, l4, r}));
  EXPECT_EQ(dashed(":where(.p line, path)"), (Lines{l4, r}));
  EXPECT_EQ(dashed("line:not(.b):not(#i)"), (Lines{l1, l2, l3, r}));
  EXPECT_EQ(dashed(":is(line, rect):not(.p *)"), (Lines{l1, l2, l3}));
  EXPECT_EQ(dashed(".p > :first-child"), (Lines{l2, l3, l4, r}));
  EXPECT_EQ(dashed(".p > :nth-child(2n)"), (Lines{l1, l3, l4, r}));
  EXPECT_EQ(dashed(".p :nth-last-child(-n + 2)"), (Lines{l1, l4, r}));
  EXPECT_EQ(dashed(".p :last-of-type"), (Lines{l1, l4, r}));
  EXPECT_EQ(dashed("line:only-of-type"), (Lines{l1, l2, l3, r}));
  EXPECT_EQ(dashed("line + line"), (Lines{l1, l3, l4, r}));
  EXPECT_EQ(dashed("line ~ path, line ~ rect"), (Lines{l1, l2, l4}));
  EXPECT_EQ(dashed(":root > line"), (Lines{l1, l2, l3, r}));
  EXPECT_EQ(dashed(".c\\:d, .\\61"), (Lines{l2, l3}));
  EXPECT_EQ(dashed("line[x2='1']:empty, line:hover, line::before"), (Lines{l2, l3, l4, r}));
  // The first has no weight at all, of :is and :not the heaviest argument counts.
  EXPECT_EQ(read("<style>line{stroke:red} :where(#i){stroke:blue}</style><line id='i' x2='5'/>").drawing.layers.at(0).name,
            "#ff0000");
  EXPECT_EQ(read("<style>:is(#i, g){stroke:blue} line.a{stroke:red}</style><line class='a' id='i' x2='5'/>")
                .drawing.layers.at(0)
                .name,
            "#0000ff");
}

TEST(SvgDocuments, CrowdsOfSiblingsAreNumberedOnce) {
  std::string body = "<style>line:nth-child(2n+1){stroke:none}</style>";
  constexpr int kLines = 40'000;
  for (int i = 0; i < kLines; ++i) body += "<line x2='1'/>";
  EXPECT_EQ(lines_of(read(body)).size(), kLines / 2u);
}

TEST(SvgDocuments, Variables) {
  const auto color = [](const std::string& body) { return read(body).drawing.layers.at(0).name; };
  EXPECT_EQ(color("<line x2='5' stroke='var(--d, #f00)'/>"), "#ff0000");
  EXPECT_EQ(color("<g style='--d:blue'><line x2='5' style='--e:var( --d );stroke:var(--e,red)'/></g>"), "#0000ff");
  EXPECT_EQ(color("<style>g{--d:lime} .a{--d:red}</style><g><line x2='5' stroke='var(--d)'/></g>"), "#00ff00");
  EXPECT_EQ(color("<line x2='5' style='stroke:var(--x, var(--y, rgb(0,0,255)))'/>"), "#0000ff");
  const ReadDrawing cycle = read("<g stroke='red' style='--a:var(--b);--b:var(--a)'><line x2='5' stroke='var(--a)'/></g>");
  EXPECT_EQ(cycle.drawing.layers.at(0).name, "#ff0000");
  EXPECT_EQ(cycle.omitted.list(), "1 values of stroke that are not known");
  std::string bomb = "--a0:xxxxxxxxxxxxxxxx;";
  for (int i = 1; i < 40; ++i) {
    const std::string before = "var(--a" + std::to_string(i - 1) + ")";
    bomb += "--a" + std::to_string(i) + ":" + before + before + ";";
  }
  EXPECT_EQ(read("<line x2='5' style='" + bomb + "stroke:var(--a39)'/>").omitted.list(),
            "1 values of stroke that are not known");
}

TEST(SvgDocuments, PaintsOfOtherPrograms) {
  EXPECT_EQ(read("<path style='fill:none;stroke:#ff0000 icc-color(CMYK,0,1,1,0)' d='M10 30H90'/>").drawing.layers.at(0).name,
            "#ff0000");
  EXPECT_EQ(read("<line x2='5' stroke='rgb(0 0 255 / 50%)'/>").drawing.layers.at(0).name, "#0000ff");
  EXPECT_EQ(read("<line x2='5' stroke='light-dark(rgb(0,0,255), #aaa)'/>").drawing.layers.at(0).name, "#0000ff");
  EXPECT_EQ(read("<line x2='5' stroke='rgb(0,0,255,0)'/>").drawing.layers.size(), 0u);
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
  expect_lines("<line x2='100' stroke-dasharray='50% 10%' font-size='5'/>", {"0,0 5000,0 ", "6000,0 10000,0 "});
  expect_points("<rect width='10' height='20' rx='auto' ry='0'/>", {{0, 0}, {10, 0}, {10, 20}, {0, 20}, {0, 0}});
  EXPECT_GT(line_of("<rect width='10' height='20' rx='5' ry='auto'/>").size(), 9u);
}

TEST(SvgDocuments, TransformsOfStyle) {
  expect_points("<line x2='10' style='transform:translate(1in,50%) rotate(90deg)'/>", {{96, 50}, {96, 60}});
  expect_points("<line x2='10' transform='scale(3)' style='transform:translateX(5px)'/>", {{5, 0}, {15, 0}});
  expect_points("<line x2='10' transform='rotate(90)' transform-origin='5 0'/>", {{5, -5}, {5, 5}});
  expect_points("<line x2='10' transform='rotate(180)' transform-origin='center'/>", {{100, 100}, {90, 100}});
  expect_points("<line x2='10' y2='10' style='transform:scale(2);transform-box:fill-box;transform-origin:right top'/>",
                {{-10, 0}, {10, 20}});
}

TEST(SvgDocuments, TransformsOfClipPaths) {
  const std::string shown = "<path d='M0 5H90' clip-path='url(#c)'/>";
  expect_lines(
      "<clipPath id='c' clipPathUnits='objectBoundingBox' transform='translate(9)'><rect y='-9' width='0.1' height='99'/></clipPath>"
      "<path d='M0 5H90V6' clip-path='url(#c)'/>",
      {"900,500 1800,500 "}, "a shift by units of the page, not of the box");
  expect_lines(
      "<clipPath id='c' transform='rotate(180)' transform-origin='50px 0'><rect y='-9' width='30' height='9'/></clipPath>" +
          shown,
      {"7000,500 9000,500 "});
}

TEST(SvgDocuments, AnglesOfMarkers) {
  const std::string marker = "<path d='M0 0h1'/></marker><path stroke='none' d='M5 5H9' marker-end='url(#m)'/>";
  for (const char* angle : {"90", "90deg", "0.25turn", "100grad"})
    expect_lines("<marker id='m' overflow='visible' orient='" + std::string(angle) + "'>" + marker, {"900,500 900,600 "},
                 angle);
  expect_lines("<marker id='m' overflow='visible' refX='1%'>" + marker, {"800,500 900,500 "},
               "of the page, not of the marker");
}

TEST(SvgDocuments, BoxesOfGroups) {
  const std::string clip =
      "<clipPath id='c' clipPathUnits='objectBoundingBox'><rect width='0.5' height='1'/></clipPath><rect id='r' y='20' "
      "width='10' height='10'/>";
  const std::string line = "<line y1='5' x2='10' y2='5'/>";
  const auto last_of = [&](const std::string& group) { return lines_of(read(clip + group)); };
  EXPECT_TRUE(last_of("<g clip-path='url(#c)'>" + line + "<line x1='10' x2='40' y2='10' visibility='hidden'/></g>")
                  .contains("0,500 1000,500 "))
      << "what is not visible counts";
  EXPECT_TRUE(last_of("<g clip-path='url(#c)'>" + line +
                      "<rect width='99' height='99' display='none'/><g transform='scale(0.5)'>"
                      "<use href='#r' x='6'/></g></g>")
                  .contains("0,500 500,500 "));
  expect_points("<g style='transform:scale(2);transform-box:fill-box;transform-origin:100% 0'><line x2='10' y2='10'/></g>",
                {{-10, 0}, {10, 20}});
}

TEST(SvgDocuments, DashesThatATransformStretches) {
  expect_lines("<line x2='10' transform='scale(2,1)' stroke-dasharray='2 1'/>",
               {"0,0 400,0 ", "600,0 1000,0 ", "1200,0 1600,0 ", "1800,0 2000,0 "});
  expect_lines("<line y2='10' transform='scale(2,1)' stroke-dasharray='6 1'/>", {"0,0 0,600 ", "0,700 0,1000 "});
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

TEST(SvgDocuments, ClipPathsInheritRulesFromWhereTheyStand) {
  const std::string frame =
      "<clipPath id='c'><path d='M10 10H90V90H10ZM30 30H70V70H30Z'/></clipPath>"
      "<path clip-path='url(#c)' d='M0 55H100'/>";
  EXPECT_EQ(lines_of(read_document("<svg style='clip-rule:evenodd'" + kSize + frame + "</svg>")),
            (Lines{"1000,5500 3000,5500 ", "7000,5500 9000,5500 "}));
  EXPECT_EQ(lines_of(read_document("<svg" + kSize + frame + "</svg>")), (Lines{"1000,5500 9000,5500 "}));
}

TEST(SvgDocuments, OpacityDoesNotCountInClipPathsAndMasksHaveARegion) {
  EXPECT_EQ(lines_of(read_document("<svg" + kSize +
                                   "<clipPath id='c'><rect x='20' width='60' height='99' opacity='0'/>"
                                   "</clipPath><path clip-path='url(#c)' d='M0 50H100'/></svg>")),
            (Lines{"2000,5000 8000,5000 "}));
  EXPECT_EQ(lines_of(read_document("<svg" + kSize +
                                   "<mask id='m' maskUnits='userSpaceOnUse' x='0' y='0' width='50' "
                                   "height='100'><rect fill='white' width='100' height='100'/></mask>"
                                   "<path mask='url(#m)' d='M10 50H90'/></svg>")),
            (Lines{"1000,5000 5000,5000 "}));
}

TEST(SvgDocuments, OneRadiusOfAnEllipseIsBoth) {
  const auto drawn = [](const std::string& radii) {
    return lines_of(read_document("<svg" + kSize + "<ellipse cx='50' cy='50' " + radii + "/></svg>"));
  };
  const auto circle = drawn("rx='30' ry='30'");
  ASSERT_EQ(circle.size(), 1u);
  EXPECT_EQ(drawn("rx='30'"), circle);
  EXPECT_EQ(drawn("ry='30' rx='auto'"), circle);
  EXPECT_TRUE(drawn("").empty());
}

}  // namespace
}  // namespace ligne
