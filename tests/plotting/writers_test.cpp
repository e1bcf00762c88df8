#include <unistd.h>

#include <nlohmann/json.hpp>

#include "plotting/readers/utf8.hpp"
#include "plotting/stroke_text.hpp"
#include "sample_drawing.hpp"

namespace ligne {
namespace {

TEST(Svg, PixelsAreAnImageWhereTheyLie) {
  for (const FacePicture& picture : {FacePicture{3, 2, {0, 50, 100, 150, 200, 250}, {10, 20}, 0.5},
                                     FacePicture{3, 2, {}, {10, 20}, 0.5, std::vector<std::uint8_t>(18, 200)}}) {
    const std::string svg = write_svg(sample_drawing(), {}, &picture);
    const std::size_t shade = svg.find("id=\"shade\""), image = svg.find("<image ");
    ASSERT_LT(shade, image);
    test::expect_parts(svg.substr(image, 200),
                       {"x=\"10\" y=\"20\"", "width=\"1.5\" height=\"1\"", "href=\"data:image/png;base64,iVBORw0KGgo"});
  }
}

/// A page of one colour under the drawing comes out in that colour, in the order red, green, blue.
TEST(Png, ColouredPixelsKeepTheirColours) {
  PlotOptions options;
  options.page = {20, 10};
  options.dpi = 25.4;
  FacePicture picture{20, 10, {}, {0, 0}, 0};
  for (int i = 0; i < 20 * 10; ++i) picture.rgb.insert(picture.rgb.end(), {200, 100, 50});
  const std::string with = write_png({}, options, &picture);
  Drawing filled;
  filled.fills.push_back({{{{-5, -5}, {25, -5}, {25, 15}, {-5, 15}}}, {200 / 255.0, 100 / 255.0, 50 / 255.0}});
  EXPECT_EQ(with, write_png(filled, options));
}

// ---- PDF ------------------------------------------------------------------------------------------------------------

Drawing text_drawing() {
  Drawing drawing;
  drawing.texts = {{"a < b & \"c\" > 'd'", {50, 60}, 3, TextAcross::left, TextUp::base, 0},
                   {"upwards", {20, 100}, 3, TextAcross::center, TextUp::middle, 90},
                   {"2\u00b710\u2076\xff\n", {90, 100}, 3, TextAcross::right, TextUp::top, 0}};
  return drawing;
}

/// Texts, one of them with a halo below its letters, and areas with a hole, rims and opacity.
TEST(Golden, SvgOfTextsAndAreas) {
  Drawing drawing = text_drawing();
  drawing.texts[1].halo_mm = 0.75;
  const std::vector<Point2> outer{{10, 10}, {40, 10}, {40, 40}, {10, 40}}, hole{{20, 20}, {30, 20}, {30, 30}, {20, 30}};
  drawing.fills = {{{outer, hole}, {1, 0, 0}}, {{hole}, {1, 0, 0}}, {{outer}, {0.5, 0.25, 0}, 0.4}};
  drawing.layers.push_back({"mesh", {}});
  expect_golden("texts.svg", write_svg(drawing, {}));
}

TEST(Pdf, TextsAreText) {
  const std::string pdf = write_pdf(text_drawing(), {});
  test::expect_parts(pdf, {"/Font"});
  EXPECT_EQ(pdf, write_pdf(text_drawing(), {}));
  test::expect_no_parts(write_pdf({}, {}), {"/FontDescriptor"});
}

TEST(Png, TextsAreDrawn) { EXPECT_NE(write_png(text_drawing(), {}), write_png({}, {})); }

TEST(Pdf, IsOnePageOfTrueSizeWithoutADate) {
  PlotOptions options;
  options.page = parse_page("100x50mm");
  options.title = "Title";
  const std::string pdf = write_pdf(sample_drawing(), options);
  EXPECT_EQ(pdf.substr(0, 5), "%PDF-");
  EXPECT_EQ(pdf.find("Date"), std::string::npos);
  EXPECT_EQ(pdf.find("/Subtype /Image"), std::string::npos) << "lines, not pixels";
  EXPECT_EQ(pdf, write_pdf(sample_drawing(), options));
  if (std::system("command -v pdfinfo >/dev/null 2>&1") != 0) GTEST_SKIP() << "pdfinfo (poppler-utils) is not here";
  const std::string file = testing::TempDir() + "ligne-" + std::to_string(getpid()) + ".pdf", told = file + ".txt";
  std::ofstream(file, std::ios::binary) << pdf;
  EXPECT_EQ(std::system(("pdfinfo '" + file + "' >'" + told + "' 2>&1").c_str()), 0);
  const std::string info = test::bytes_of_file(told);
  for (const std::string& made : {file, told}) std::filesystem::remove(made);
  EXPECT_NE(info.find("Title:           Title\n"), std::string::npos) << info;
  EXPECT_NE(info.find("Pages:           1\n"), std::string::npos) << info;
  EXPECT_NE(info.find("Page size:       283.465 x 141.732 pts"), std::string::npos) << info;
  EXPECT_EQ(info.find("Date:"), std::string::npos) << info;
}

TEST(Pdf, EveryPageSizeWorks) {
  for (const char* page : {"A0", "A6", "1x1", "0.1x0.1", "100000x10", "100000x100000"}) {
    PlotOptions options;
    options.page = parse_page(page);
    EXPECT_FALSE(write_pdf(sample_drawing(), options).empty()) << page;
  }
  EXPECT_FALSE(write_pdf({}, {}).empty()) << "nothing drawn";
}

// ---- PNG ------------------------------------------------------------------------------------------------------------

std::uint32_t big_endian(const std::string& bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
  return value;
}

TEST(Png, HasTheSizeOfThePage) {
  PlotOptions options;
  options.dpi = 25.4;
  std::string png = write_png(sample_drawing(), options);
  EXPECT_EQ(png.substr(1, 3), "PNG");
  EXPECT_EQ(big_endian(png, 16), 210u);
  EXPECT_EQ(big_endian(png, 20), 297u);
  options.dpi = 150;
  png = write_png(sample_drawing(), options);
  EXPECT_EQ(big_endian(png, 16), 1240u);
  EXPECT_EQ(big_endian(png, 20), 1754u);
  EXPECT_NE(png, write_png({}, options)) << "nothing was drawn";
}

TEST(Png, RefusesWhatIsTooLarge) {
  PlotOptions options;
  for (const double dpi : {1e6, 1e300, 0.0, -1.0, std::nan("")}) {
    options.dpi = dpi;
    EXPECT_THROW(write_png({}, options), std::runtime_error) << dpi;
  }
}

// ---- JSON -----------------------------------------------------------------------------------------------------------

/// In the golden file the surfaces of the faces stand at the source of each stroke.
TEST(Json, ListsSurfacesWhereThereAreAny) {
  const StrokeModel strokes = sample_strokes();
  DrawingDocument document;
  document.strokes = &strokes;
  document.source = [&](std::uint32_t source) { return sample_source(strokes, source); };
  const std::string without = write_json(document, {});
  test::expect_no_parts(without, {"surfaces"});
  document.surface_of_face.assign(8, 0xffffffffu);
  EXPECT_EQ(write_json(document, {}), without) << "faces without any surface";
  document.surface_of_face[7] = 1;
  document.surface_of_face[4] = 0;
  document.surfaces = {{"cone", {1, 2, 3.5}, Point3{0, 0, 1}, 4, -0.25, {}, std::array{0.0, 6.5}, 360, false, 1e-3, 24, 2},
                       {"sphere", {0, 0, 1e-7}, {}, 0.1, {}, {}, {}, {}, true, 0.5, 7, 0},
                       {"torus", {0, 0, 0}, Point3{1, 0, 0}, 8, {}, 2, {}, {}, true, 0, 1, 1}};
  expect_golden("surfaces.json", write_json(document, {}));
}

TEST(Json, PointsReadBackToTheSameLatticePoint) {
  for (const char* page : {"A0", "A4", "10x10"}) {
    StrokeModel strokes;
    strokes.lattice = Lattice::covering(parse_page(page).sheet());
    std::mt19937 random(2);
    const auto coordinate = [&] { return static_cast<std::int32_t>(random() % kLatticeLimit); };
    for (int i = 0; i < 20000; ++i) {
      Stroke s;
      s.from = {coordinate(), -coordinate()};
      s.to = {-coordinate(), coordinate()};
      s.t_from = 1e-10 * coordinate();
      strokes.strokes.push_back(s);
    }
    DrawingDocument document;
    document.strokes = &strokes;
    const auto json = nlohmann::json::parse(write_json(document, {}));
    ASSERT_EQ(json["strokes"].size(), strokes.strokes.size());
    for (std::size_t i = 0; i < strokes.strokes.size(); ++i) {
      const auto& points = json["strokes"][i]["points"];
      const Stroke& s = strokes.strokes[i];
      ASSERT_EQ(strokes.lattice.snap({points[0][0], points[0][1]}), s.from);
      ASSERT_EQ(strokes.lattice.snap({points[1][0], points[1][1]}), s.to);
      ASSERT_EQ(json["strokes"][i]["interval"][0].get<double>(), s.t_from);
    }
  }
}

// Text as single strokes.

struct Drawn {
  Polylines lines;
  Rect ink;
  std::size_t boxes = 0;
};

Drawn drawn(const TextItem& item) {
  Drawn result;
  result.boxes = append_stroke_text(item, result.lines);
  for (const Point2 p : result.lines.points) result.ink.extend(p);
  return result;
}
Drawn drawn(const std::string& text) { return drawn({text, {0, 0}, 21, TextAcross::left, TextUp::base, 0}); }

TEST(StrokeText, Metrics) {
  // Hershey's capitals are 21 units high; H is 22 units wide and stands on the base line.
  const Drawn h = drawn("H");
  EXPECT_EQ(h.lines.size(), 3u);
  EXPECT_DOUBLE_EQ(h.ink.min.y, -21);
  EXPECT_DOUBLE_EQ(h.ink.max.y, 0);
  const TextExtent extent = text_extent("H", 21, TextStyle::stroke);
  EXPECT_DOUBLE_EQ(extent.width, 22);
  EXPECT_DOUBLE_EQ(extent.ascent, 21);
  EXPECT_DOUBLE_EQ(extent.descent, 0);
  EXPECT_GT(text_extent("g", 21, TextStyle::stroke).descent, 5);
  EXPECT_DOUBLE_EQ(text_extent("HH", 2.1, TextStyle::stroke).width, 4.4);
  EXPECT_DOUBLE_EQ(text_extent("", 21, TextStyle::stroke).width, 0);
  EXPECT_EQ(drawn(" ").lines.size(), 0u);
  EXPECT_GT(text_extent(" ", 21, TextStyle::stroke).width, 0);
}

TEST(StrokeText, InkLiesInTheBoxWhateverTheAnchor) {
  for (const std::string text : {"Ag(y)|", "−2.5·10⁻⁷", "Ålesund, été", "μ ± 3°"}) {
    for (const TextAcross across : {TextAcross::left, TextAcross::center, TextAcross::right}) {
      for (const TextUp up : {TextUp::base, TextUp::middle, TextUp::top}) {
        for (const double rotation : {0.0, 90.0, -90.0, 180.0, 30.0, -137.0}) {
          const TextItem item{text, {10, 20}, 3, across, up, rotation};
          const TextBox box = text_box(item, text_extent(text, 3, TextStyle::stroke));
          const auto [u, v] = box.axes();
          for (const Point2 p : drawn(item).lines.points) {
            const Point2 d = p - box.center;
            EXPECT_LE(std::abs(d.x * u.x + d.y * u.y), box.half.x + 1e-9) << text;
            EXPECT_LE(std::abs(d.x * v.x + d.y * v.y), box.half.y + 1e-9) << text;
          }
        }
      }
    }
  }
}

TEST(StrokeText, AccentsStandOverTheLetterAndRaisedDigitsAboveTheLine) {
  EXPECT_LT(drawn("é").ink.min.y, drawn("e").ink.min.y);
  EXPECT_DOUBLE_EQ(drawn("é").ink.max.y, drawn("e").ink.max.y);
  EXPECT_GT(drawn("ç").ink.max.y, drawn("c").ink.max.y);
  EXPECT_EQ(drawn("ï").lines.size(), drawn("i").lines.size() + 1) << "two dots in place of one";
  EXPECT_LT(drawn("⁷").ink.max.y, -10);
  EXPECT_LT(drawn("⁷").ink.min.y, -21);
}

TEST(StrokeText, WhatIsUnknownIsABoxAndCounted) {
  const Drawn unknown = drawn("a\u6f22\U0001f58b");
  EXPECT_EQ(unknown.boxes, 2u);
  EXPECT_EQ(unknown.lines.size(), drawn("a").lines.size() + 2);
}

TEST(StrokeText, MalformedTextIsHarmless) {
  std::mt19937 random(3);
  std::uniform_int_distribution<int> byte(0, 255), length(0, 40);
  for (int i = 0; i < 5000; ++i) {
    std::string text(static_cast<std::size_t>(length(random)), ' ');
    for (char& c : text) c = static_cast<char>(byte(random));
    const std::string clean = clean_utf8(text);
    EXPECT_EQ(clean_utf8(clean), clean);
    EXPECT_EQ(decode_utf8(clean), decode_utf8(text));
    EXPECT_LE(drawn(text).boxes, text.size());
  }
}

TEST(StrokeText, TextsOfADrawingBecomeALayer) {
  Drawing drawing;
  drawing.texts = {{"HI", {0, 0}, 3}, {"\u6f22", {9, 0}, 3}};
  EXPECT_EQ(draw_texts_as_strokes(drawing), 1u);
  EXPECT_TRUE(drawing.texts.empty());
  ASSERT_EQ(drawing.layers.size(), 1u);
  EXPECT_EQ(drawing.layers[0].name, "text");
  EXPECT_EQ(drawing.layers[0].lines.size(), 3u + 1 + 1);
  Drawing blank;
  blank.texts = {{" ", {0, 0}, 3}};
  EXPECT_EQ(draw_texts_as_strokes(blank), 0u);
  EXPECT_TRUE(blank.layers.empty());
}

}  // namespace
}  // namespace ligne
