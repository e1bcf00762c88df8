/// Coordinates are right to a micrometre up to A0: they are read back from the files.

#include <cmath>
#include <random>
#include <sstream>

#include <gtest/gtest.h>
#include <zlib.h>

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
    for (std::size_t j = 0; j < got[i].size(); ++j) {
      worst = std::max({worst, std::abs(got[i][j].x - wanted[i][j].x), std::abs(got[i][j].y - wanted[i][j].y)});
    }
  }
  EXPECT_LT(worst, kMicrometre) << what;
}

/// The paths of an SVG: M, L, l and Z.
std::vector<Line> svg_lines(const std::string& svg) {
  std::vector<Line> lines;
  const std::string start = "<path d=\"";
  for (std::size_t at = svg.find(start); at != std::string::npos; at = svg.find(start, at + 1)) {
    std::string data = svg.substr(at + start.size(), svg.find('"', at + start.size()) - at - start.size());
    const bool relative = data.find('l') != std::string::npos, closed = data.back() == 'Z';
    for (char& c : data) {
      if (std::isalpha(static_cast<unsigned char>(c))) c = ' ';
    }
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

class Precision : public ::testing::TestWithParam<const char*> {};

TEST_P(Precision, Svg) {
  PlotOptions options;
  options.page = parse_page(GetParam());
  std::vector<Line> lines;
  const std::string svg = write_svg(awkward_drawing(options.page, lines), options);
  expect_near(svg_lines(svg), lines, GetParam());
}

TEST_P(Precision, Pdf) {
  PlotOptions options;
  options.page = parse_page(GetParam());
  std::vector<Line> lines;
  const std::string pdf = write_pdf(awkward_drawing(options.page, lines), options);
  expect_near(pdf_lines(pdf), lines, GetParam());
}

INSTANTIATE_TEST_SUITE_P(Pages, Precision, ::testing::Values("A0", "A3", "A4", "A6", "letter", "20x20", "1189x20000"),
                         [](const auto& info) { return "Page" + std::to_string(info.index); });

TEST(PrecisionOfLongLines, RelativeMovesDoNotDrift) {
  Line line;
  for (int i = 0; i < 100000; ++i) line.push_back({0.00104999 * i, 100 + (i % 2) * 0.00214999});
  Drawing drawing;
  add_line(drawing, "mesh", line);
  const std::vector<Line> got = svg_lines(write_svg(drawing, {}));
  expect_near(got, {line}, "zigzag");
}

TEST(PrecisionOfLongLines, ClosedLinesComeBack) {
  Drawing drawing;
  add_line(drawing, "mesh", {{0, 0}, {10.1235, 0}, {10, 10.00005}, {0, 0}});
  EXPECT_EQ(svg_lines(write_svg(drawing, {})).at(0).size(), 4u);
}

}  // namespace
}  // namespace ligne
