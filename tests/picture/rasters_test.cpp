// The SVG and the PDF are one picture: each is made into pixels by a reader that knows nothing of us, librsvg and Poppler.

#include "cli/program.hpp"
#include "main/tier.hpp"
#include "picture/raster.hpp"

namespace ligne::test {
namespace {

const std::filesystem::path kSource = LIGNE_SOURCE_DIR;

class Rasters : public testing::Test {
 protected:
  std::string written(const Words& arguments, const std::string& name) const {
    const std::string file = (folder_ / name).string();
    const Outcome outcome = run_ligne(kSource, arguments + Words{"-q", "-o", file});
    if (outcome.status != 0) throw std::runtime_error(outcome.err);
    return file;
  }

  Raster raster(const std::string& file) const {
    const std::string png = file + ".png";
    const bool pdf = std::filesystem::path(file).extension() == ".pdf";
    const std::string command = pdf ? std::string(PDFTOPPM) + " -r 150 -png -singlefile " + file + " " + file
                                    : std::string(RSVG_CONVERT) + " -d 150 -p 150 -b white -o " + png + " " + file;
    if (std::system(command.c_str()) != 0) throw std::runtime_error("failed: " + command);
    return read_raster(png);
  }

  TemporaryFolder folder_;
};

/// Pixels of the first whose colour does not lie between those that the second has in the place and beside it: readers
/// smooth edges in their own ways, and round the page to pixels.
std::size_t missing(const Raster& a, const Raster& b) {
  constexpr int kSmoothing = 40;
  std::size_t count = 0;
  for (int y = 1; y + 1 < std::min(a.height, b.height); ++y) {
    for (int x = 1; x + 1 < std::min(a.width, b.width); ++x) {
      std::array<int, 3> low = b.at(x, y), high = low;
      // Nearly all of a sheet is white in both.
      if (low == a.at(x, y)) continue;
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx)
          for (std::size_t c = 0; c < 3; ++c) {
            low[c] = std::min(low[c], b.at(x + dx, y + dy)[c]);
            high[c] = std::max(high[c], b.at(x + dx, y + dy)[c]);
          }
      bool between = true;
      for (std::size_t c = 0; c < 3; ++c)
        between = between && low[c] - kSmoothing <= a.at(x, y)[c] && a.at(x, y)[c] <= high[c] + kSmoothing;
      count += !between;
    }
  }
  return count;
}

std::size_t dark(const Raster& a) {
  return static_cast<std::size_t>(
      std::ranges::count_if(a.pixels, [](const std::array<int, 3>& p) { return p[0] + p[1] + p[2] < 3 * 128; }));
}

std::size_t gray(const Raster& a) {
  return static_cast<std::size_t>(
      std::ranges::count_if(a.pixels, [](const std::array<int, 3>& p) { return p[0] > 50 && p[0] < 250; }));
}

TEST_F(Rasters, TheSvgAndThePdfAreOnePicture) {
  const std::vector<Words> drawings{"draw tests/corpus/house.json --hidden dashed --title 'a house'",
                                    "draw tests/corpus/holes_behind_holes.json --fill shade",
                                    "draw tests/atherton_weiler/scenes/transparent_three.json --view front --fill material",
                                    "draw examples/models/gear-pair.json --fill material --method bsp",
                                    "draw examples/models/pipe-tee.json --view trimetric --shade --method watkins",
                                    "draw examples/models/pipe-tee.json --view trimetric --shade --method zbuffer",
                                    "surface sin(x)*cos(y) -x -3:3 -y -3:3 --axes"};
  for (const Words& drawing : chosen("rasters", 4, drawings)) {
    SCOPED_TRACE(drawing[1]);
    const Raster svg = raster(written(drawing, "page.svg")), pdf = raster(written(drawing, "page.pdf"));
    EXPECT_GT(dark(svg), 1000u);
    EXPECT_LE(std::abs(svg.width - pdf.width), 1);
    EXPECT_LE(std::abs(svg.height - pdf.height), 1);
    // Readers set texts, and Poppler draws thin lines, each in its own way: a few pixels of them.
    const std::size_t few = dark(svg) / 100;
    EXPECT_LE(missing(pdf, svg), few);
    EXPECT_LE(missing(svg, pdf), few);
  }
}

/// Gray faces are areas in SVG where the method gives spans, and pixels where it gives pixels: both look as the PNG does.
TEST_F(Rasters, GrayFacesLookTheSameInSvgAndPng) {
  for (const std::string method : chosen("gray faces", 3, {"watkins", "zbuffer", "painter"})) {
    SCOPED_TRACE(method);
    Words drawing{"draw", "examples/models/five-cubes.obj", "--view", "trimetric", "--shade", "--landscape", "--method",
                  method};
    const std::string svg = written(drawing, method + ".svg");
    const Raster vector = raster(svg);
    drawing += "--dpi 150";
    const Raster pixels = read_raster(written(drawing, method + ".png"));
    ASSERT_EQ(vector.width, pixels.width);
    EXPECT_GT(gray(pixels), 100'000u);
    EXPECT_LE(missing(vector, pixels), gray(pixels) / 1000);
    EXPECT_LE(missing(pixels, vector), gray(pixels) / 1000);
    EXPECT_EQ(bytes_of_file(svg).find("<image ") == std::string::npos, method == "watkins");
  }
}

/// White pixels within the bounding box of the gray ones, but for its rim, which readers smooth.
std::size_t white_inside(const Raster& a) {
  int low_x = a.width, low_y = a.height, high_x = 0, high_y = 0;
  for (int y = 0; y < a.height; ++y) {
    for (int x = 0; x < a.width; ++x) {
      if (a.at(x, y)[0] < 50 || a.at(x, y)[0] > 250) continue;
      low_x = std::min(low_x, x), high_x = std::max(high_x, x);
      low_y = std::min(low_y, y), high_y = std::max(high_y, y);
    }
  }
  constexpr int kRim = 2;
  std::size_t count = 0;
  for (int y = low_y + kRim; y <= high_y - kRim; ++y)
    for (int x = low_x + kRim; x <= high_x - kRim; ++x) count += a.at(x, y) == std::array<int, 3>{255, 255, 255};
  return count;
}

/// A plane fills its square with one gray, so that white there is that of labels; each label has about as much white round
/// its letters as they have ink.
TEST_F(Rasters, LabelsOnAreasHaveHalos) {
  const Words plain =
      "surface x -x 0:10 -y 0:10 --contour-step 2 --lines none --fill shade --view top --page A6 --text-height 2.5";
  Words labelled = plain;
  labelled += "--contour-labels all";
  EXPECT_EQ(white_inside(raster(written(plain, "plain.svg"))), 0u);
  const Raster svg = raster(written(labelled, "page.svg")), pdf = raster(written(labelled, "page.pdf"));
  labelled += "--dpi 150";
  const Raster png = read_raster(written(labelled, "page.png"));
  constexpr std::size_t kLeastOfALabel = 60;  // pixels: a digit of 1.9 mm is eleven pixels high, its halo three wide
  for (const Raster* one : {&svg, &pdf, &png}) EXPECT_GT(white_inside(*one), 4 * kLeastOfALabel);
  EXPECT_LE(missing(pdf, svg), dark(svg) / 100);
  EXPECT_LE(missing(png, svg), dark(svg) / 100);
  labelled += "--text stroke";
  EXPECT_GT(white_inside(read_raster(written(labelled, "strokes.png"))), 4 * kLeastOfALabel) << "an area below strokes";
}

}  // namespace
}  // namespace ligne::test
