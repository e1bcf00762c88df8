/// Coordinates are right to a micrometre up to A0: they are read back from the files.

#include <zlib.h>

#include "geometry/nearest_on_segment.hpp"
#include "geometry/simplify.hpp"
#include "main/script.hpp"
#include "plotting/dashes.hpp"
#include "plotting/paths/optimize.hpp"
#include "plotting/readers/drawing_reader.hpp"
#include "plotting/readers/utf8.hpp"
#include "plotting/stroke_text.hpp"
#include "plotting/tiles.hpp"
#include "plotting/writers/number_text.hpp"
#include "sample_drawing.hpp"

namespace ligne {
namespace {

constexpr double kMicrometre = 1e-3;
constexpr double kPointsPerMm = 72 / 25.4;

using Line = std::vector<Point2>;

/// Awkward coordinates all over the page, as polylines with sharp turns.
Drawing awkward_drawing(const Page& page, std::vector<Line>& lines) {
  std::mt19937 random(17);
  std::uniform_real_distribution<double> unit(0, 1);
  Drawing drawing;
  for (int i = 0; i < 400; ++i) {
    Line line;
    for (int j = 0; j < 7; ++j) line.push_back({page.width_mm * unit(random), page.height_mm * unit(random)});
    lines.push_back(line);
  }
  lines.push_back(
      {{100.1235, 100.1235}, {0.00005, 0.0001}, {page.width_mm, page.height_mm}, {page.width_mm - 0.0005, 1. / 3}});
  for (const Line& line : lines) add_line(drawing, "outline", line);
  return drawing;
}

void expect_near(const std::vector<Line>& got, const std::vector<Line>& wanted, const std::string& what) {
  ASSERT_EQ(got.size(), wanted.size()) << what;
  double worst = 0;
  for (std::size_t i = 0; i < got.size(); ++i) {
    ASSERT_EQ(got[i].size(), wanted[i].size()) << what << ", line " << i;
    for (std::size_t j = 0; j < got[i].size(); ++j)
      worst = std::max({worst, std::abs(got[i][j].x - wanted[i][j].x), std::abs(got[i][j].y - wanted[i][j].y)});
  }
  EXPECT_LT(worst, kMicrometre) << what;
}

/// The paths of an SVG: M, L, l and Z.
std::vector<Line> svg_lines(const std::string& svg) {
  std::vector<Line> lines;
  for (std::string data : path_data(svg)) {
    const bool relative = data.find('l') != std::string::npos, closed = data.back() == 'Z';
    for (char& c : data)
      if (std::isalpha(static_cast<unsigned char>(c))) c = ' ';
    std::istringstream in(data);
    Line line;
    for (Point2 p; in >> p.x >> p.y;) line.push_back(relative && !line.empty() ? line.back() + p : p);
    if (closed) line.push_back(line.front());
    lines.push_back(line);
  }
  return lines;
}

std::vector<std::string> inflated_streams(const std::string& pdf) {
  std::vector<std::string> streams;
  for (std::size_t at = pdf.find("stream\n"); at != std::string::npos; at = pdf.find("stream\n", at)) {
    at += 7;
    std::string out(1 << 22, '\0');
    z_stream z{};
    z.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(pdf.data() + at));
    z.avail_in = static_cast<uInt>(pdf.size() - at);
    z.next_out = reinterpret_cast<Bytef*>(out.data());
    z.avail_out = static_cast<uInt>(out.size());
    inflateInit(&z);
    const bool whole = inflate(&z, Z_FINISH) == Z_STREAM_END;
    out.resize(z.total_out);
    inflateEnd(&z);
    if (whole) streams.push_back(out);
    at = pdf.find("endstream", at) + 9;
  }
  return streams;
}

/// The lines of the form in a PDF, in mm from the top left corner.
std::vector<Line> pdf_lines(const std::string& pdf) {
  double scale = 0;
  std::vector<Line> lines;
  for (const std::string& stream : inflated_streams(pdf)) {
    std::istringstream in(stream);
    std::vector<std::string> words;
    for (std::string word; in >> word; words.push_back(word)) {
      const auto number = [&](std::size_t back) { return std::stod(words[words.size() - back]); };
      if (word == "cm" && number(3) != -1) scale = number(6);
      if (word == "m") lines.emplace_back();
      if (word == "h") lines.back().push_back(lines.back().front());
      if (word == "m" || word == "l") lines.back().push_back(Point2{number(2), number(1)} * scale / kPointsPerMm);
    }
  }
  return lines;
}

TEST(Precision, CoordinatesAreRightOnEveryPage) {
  for (const std::string page : {"A0", "A3", "A4", "A6", "letter", "20x20", "1189x20000", "0.1x0.1", "100000x100000"}) {
    PlotOptions options;
    options.page = parse_page(page);
    std::vector<Line> lines;
    const Drawing drawing = awkward_drawing(options.page, lines);
    expect_near(svg_lines(write_svg(drawing, options)), lines, page + ", SVG");
    if (options.page.width_mm > 20'000) continue;  // there a PDF is right to a few micrometres
    expect_near(pdf_lines(write_pdf(drawing, options)), lines, page + ", PDF");
  }
}

TEST(PrecisionOfLongLines, RelativeMovesDoNotDrift) {
  const Line line = test::line_of_text("0..99999:0.00104999*k,100+mod(k,2)*0.00214999");
  Drawing drawing;
  add_line(drawing, "mesh", line);
  expect_near(svg_lines(write_svg(drawing, {})), {line}, "zigzag");
}

std::string fixed(std::int64_t value, int decimals, bool bare_point = true) {
  char text[kNumberBytes];
  return {text, write_fixed(text, value, decimals, bare_point)};
}
/// The length but for the rounding of a product.
double picometres(double mm) { return std::round(mm * 1e12) / 1e12; }

/// The number of characters that are drawn as boxes.
std::size_t boxes_of(const std::string& text) {
  Polylines lines;
  return append_stroke_text({text, {0, 0}, 21, TextAcross::left, TextUp::base, 0}, lines);
}

constexpr Rect kSheet{{0, 0}, {10, 10}};

/// "NUMBERS: LINES": the lines cut by the numbers.
template <class Cut>
std::string cut_by(const std::string& text, const Cut& cut) {
  const std::size_t colon = text.find(':');
  std::vector<double> lengths;
  for (const std::string& word : test::words_of(text.substr(0, colon))) lengths.push_back(std::stod(word));
  return text_of_lines(cut(test::lines_of_text(text.substr(colon + 1)), lengths));
}

/// The data of the paths of an SVG, each in brackets.
std::string paths_of(const Polylines& lines) {
  Drawing drawing;
  drawing.layers.push_back({"mesh", lines});
  std::string paths;
  for (const std::string& data : path_data(write_svg(drawing, {}))) paths += "[" + data + "]";
  return paths;
}

/// "TOLERANCE LOST: LINE": the numbers of the points that stay. The line stays within the tolerance and as long as is asked.
std::string simplified_line(const std::string& text) {
  const std::vector<std::string> numbers = test::words_of(text.substr(0, text.find(": ")));
  const double tolerance = std::stod(numbers.at(0)), lost = std::stod(numbers.at(1));
  const Line line = test::line_of_text(text.substr(text.find(": ") + 2));
  const std::vector<std::uint32_t> kept = simplified(line, tolerance, lost);
  EXPECT_EQ(kept.back(), line.size() - 1);
  double length = 0, before = 0;
  for (std::size_t k = 1; k < kept.size(); ++k) {
    length += glm::distance(line[kept[k - 1]], line[kept[k]]);
    for (std::uint32_t i = kept[k - 1]; i < kept[k]; ++i) {
      before += glm::distance(line[i], line[i + 1]);
      EXPECT_LE(squared_distance(line[i], line[kept[k - 1]], line[kept[k]]), tolerance * tolerance);
    }
  }
  EXPECT_GE(length, (1 - lost) * before);
  std::string all;
  if (kept.size() == line.size()) return "all";
  if (kept.size() > 9) return std::to_string(kept.size());
  for (const std::uint32_t k : kept) all += (all.empty() ? "" : " ") + std::to_string(k);
  return all;
}

/// The title of an SVG, which reads back as XML.
std::string title_in_svg(const std::string& title) {
  PlotOptions options;
  options.title = title;
  const std::string svg = write_svg({}, options);
  read_svg_drawing(svg, "a.svg", {});
  const std::size_t begin = svg.find("<title>") + 7;
  return svg.substr(begin, svg.find("</title>") - begin);
}

/// Texts of numbers, lengths and pages, lines that are joined or dashed, and paths of an SVG: the folder values.
const test::TextFunctions kFunctions{
    {"fixed", [](auto& t) { return fixed(std::stoll(t), 4); }},
    {"fixed-with-zero", [](auto& t) { return fixed(std::stoll(t), 4, false); }},
    {"fixed-whole", [](auto& t) { return fixed(std::stoll(t), 0); }},
    {"rounded", [](auto& t) { return as_decimal(test::value_of(t)); }},
    {"join", [](auto& t) { return text_of_lines(join_strokes(test::lines_of_text(t), {})); }},
    {"join-exact", [](auto& t) { return text_of_lines(join_strokes(test::lines_of_text(t), {0.0})); }},
    {"joined-length",
     [](auto& t) {
       const Polylines joined = join_strokes(test::lines_of_text(t), {});
       return as_decimal(total_length(joined), 2) + " in " + std::to_string(joined.size());
     }},
    {"simplified", simplified_line},
    {"keeps", [](auto& t) { return simplified_line(t).empty() ? "nothing" : "enough"; }},
    {"join-ends", [](auto& t) { return text_of_lines(join_near_ends(test::lines_of_text(t), 0.05)); }},
    {"dashes", [](auto& t) { return cut_by(t, [](auto lines, auto cut) { return cut_dashes(lines, cut, 0.5); }); }},
    {"marks", [](auto& t) { return cut_by(t, [](auto lines, auto cut) { return cut_pattern(lines, cut, 1); }); }},
    {"within-10", [](auto& t) { return text_of_lines(clip_to_box(test::lines_of_text(t), kSheet)); }},
    {"title", title_in_svg},
    {"path", [](auto& t) { return paths_of(test::lines_of_text(t)); }},
    {"json", [](auto& t) { return std::to_string(read_json_drawing(t, "a.json").drawing.layers.size()); }},
    {"boxes", [](auto& t) { return std::to_string(boxes_of(t)); }},
    {"utf8", [](auto& t) { return std::to_string(decode_utf8(t).size()) + " " + clean_utf8(t); }},
    {"length", [](auto& t) { return test::as_text(picometres(parse_length_mm(t))); }},
    {"page",
     [](auto& t) {
       EXPECT_EQ(parse_page(t).margin_mm, Page{}.margin_mm);
       return test::as_text(picometres(parse_page(t).width_mm), picometres(parse_page(t).height_mm));
     }},
};

[[maybe_unused]] const bool values_are_added =
    test::add_function_scripts(LIGNE_SOURCE_DIR "/tests/plotting/values", kFunctions);

TEST(NumberText, FixedAgreesWithTheLibrary) {
  std::mt19937_64 random(3);
  for (int i = 0; i < 20000; ++i) {
    const auto value = static_cast<std::int64_t>(random() % 100000000) - 50000000;
    EXPECT_EQ(std::llround(std::strtod(fixed(value, 4, i % 2).c_str(), nullptr) * 1e4), value);
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

/// Files compared byte by byte with tests/golden/. Run with LIGNE_UPDATE_GOLDENS=1 to write them anew.

std::string sample_svg() {
  PlotOptions options;
  options.title = "A < B & \"C\"";
  return write_svg(sample_drawing(), options);
}

std::string sample_json() {
  const StrokeModel strokes = sample_strokes();
  const std::vector<Region> regions{{3, {{{0, 0}, {10, 0}, {5.0000004, 7.5}}, {{4, 1}, {6, 1}, {5, 2}}}}};
  const PaintOrder order{{{2, {{{0, 0}, {8, 0}, {8, 8}, {0, 8}}, {{2, 2}, {2, 4}, {4, 4}}}, {0, 0, 12.5}},
                          {0, {{{1, 1}, {5, 1}, {3.25, 4}}}, {0.5, -0.25, 3}},
                          {2, {{{8, 0}, {9, 0}, {8, 8}}}, {0, 0, 12.5}}}};
  DrawingDocument document;
  document.strokes = &strokes;
  document.regions = &regions;
  document.order = &order;
  document.source = [&](std::uint32_t source) { return sample_source(strokes, source); };
  document.model_to_page[3][0] = 105;
  document.window = {{0, 0}, {210, 297}};
  document.method = "appel";
  document.statistics.count("edges", 12345678901234u);
  document.statistics.time("total", 1.25);
  return write_json(document, {});
}

TEST(Golden, Svg) { expect_golden("sample.svg", sample_svg()); }
TEST(Golden, Json) { expect_golden("sample.json", sample_json()); }

TEST(Golden, TheComparisonCanFail) {
  std::string svg = sample_svg();
  ++svg[svg.size() / 2];
  EXPECT_NE(difference("sample.svg", svg), "");
  EXPECT_NE(difference("sample.svg", sample_svg() + " "), "");
  EXPECT_NE(difference("sample.svg", sample_svg().substr(1)), "");
  EXPECT_NE(difference("no-such-golden.svg", ""), "");
}

}  // namespace
}  // namespace ligne
