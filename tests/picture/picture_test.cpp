// The program's PNG against its JSON drawing, whose strokes the oracle and the rays hold right: every dark pixel lies on a
// visible stroke, and every visible stroke has ink all along. Rough, a pixel to a quarter of a millimetre, but of the whole
// way from the file to the page.

#include <unistd.h>

#include <nlohmann/json.hpp>

#include "cli/program.hpp"
#include "geometry/point.hpp"
#include "main/tier.hpp"
#include "picture/hidden_pieces.hpp"
#include "picture/raster.hpp"

namespace ligne::test {
namespace {

const std::filesystem::path kSource = LIGNE_SOURCE_DIR;

constexpr int kPixelsPerMm = 4, kWidth = 297 * kPixelsPerMm, kHeight = 210 * kPixelsPerMm;
/// Half of the pen, and half of a pixel's diagonal, in pixels: how far from a line the middle of a dark pixel may lie.
constexpr double kReach = 0.25 * kPixelsPerMm + 0.75;

/// A pixel each: 1 for those that are set.
using Mask = std::vector<std::uint8_t>;

std::size_t index(int x, int y) { return static_cast<std::size_t>(y) * kWidth + static_cast<std::size_t>(x); }

/// Calls visit(index) for the pixels whose middles are within the reach of the point.
template <class Visit>
void for_pixels_near(Point2 p, const Visit& visit) {
  const int x0 = static_cast<int>(p.x), y0 = static_cast<int>(p.y);
  for (int y = std::max(0, y0 - 2); y <= std::min(kHeight - 1, y0 + 2); ++y)
    for (int x = std::max(0, x0 - 2); x <= std::min(kWidth - 1, x0 + 2); ++x)
      if (glm::distance(p, Point2(x + 0.5, y + 0.5)) <= kReach) visit(index(x, y));
}

struct Disagreement {
  std::size_t dark = 0, places = 0;  ///< dark pixels, and places of strokes that were looked at
  std::size_t stray = 0;             ///< dark pixels on no stroke
  std::size_t bare = 0;              ///< places of strokes without ink

  bool none() const { return dark > 0 && places > 0 && stray == 0 && bare == 0; }
};

Disagreement compare(const Mask& ink, const nlohmann::json& drawing) {
  Disagreement found;
  Mask lines(ink.size(), 0);
  for (const auto& stroke : drawing.at("strokes")) {
    if (!stroke.at("visible").get<bool>()) continue;
    const auto end = [&](std::size_t i) {
      return Point2(stroke["points"][i][0], stroke["points"][i][1]) * double{kPixelsPerMm};
    };
    const int steps = 1 + static_cast<int>(2 * glm::distance(end(0), end(1)));
    for (int i = 0; i <= steps; ++i) {
      bool inked = false;
      for_pixels_near(end(0) + (end(1) - end(0)) * (double(i) / steps), [&](std::size_t pixel) {
        lines[pixel] = 1;
        inked |= ink[pixel] != 0;
      });
      ++found.places;
      found.bare += !inked;
    }
  }
  for (std::size_t i = 0; i < ink.size(); ++i) {
    found.dark += ink[i];
    found.stray += ink[i] && !lines[i];
  }
  return found;
}

/// The command that draws the file; creases have 0.7 of the pen's width, so that half of a pixel is covered wherever a line
/// runs.
std::string command_of(const std::string& file, const std::string& options) {
  return "draw " + file + " --up=0,0,1 --landscape --pen-width 0.5mm -q --quality exact " + options;
}

std::filesystem::path drawn(const TemporaryFolder& folder, const std::string& command, const std::string& name) {
  const Outcome outcome = run_ligne(kSource, Words(command.c_str()) + Words{"-o", folder / name});
  if (outcome.status != kDone) throw std::runtime_error(outcome.err);
  return folder / name;
}

nlohmann::json drawing_of(const std::string& command) {
  const TemporaryFolder folder;
  return nlohmann::json::parse(bytes_of_file(drawn(folder, command, "a.json")));
}

/// The pixels that are more than half covered.
Mask ink_of(const std::string& command) {
  const TemporaryFolder folder;
  const Raster raster = read_raster(drawn(folder, command + " --dpi " + std::to_string(kPixelsPerMm * 25.4), "a.png"));
  EXPECT_EQ(raster.width, kWidth);
  EXPECT_EQ(raster.height, kHeight);
  Mask ink;
  for (const auto& pixel : raster.pixels) ink.push_back(pixel[1] < 128);
  return ink;
}

class Picture : public testing::TestWithParam<const char*> {};

TEST_P(Picture, ShowsTheSameAsTheDrawing) {
  // In millimetres the tee is ten times as large as the other models.
  const std::string eye = std::string_view(GetParam()).ends_with("pipe-tee.json") ? "310,-270,290" : "31,-27,29";
  for (const std::string& view :
       {std::string("--direction=-0.41,0.77,-0.49"), "--eye=" + eye + " --target=0,0,0 --fov=50"}) {
    const std::string command = command_of(GetParam(), view);
    const Disagreement found = compare(ink_of(command), drawing_of(command));
    EXPECT_TRUE(found.none()) << found.stray << " of " << found.dark << " dark pixels lie on no line, and " << found.bare
                              << " of " << found.places << " places of lines have no ink: ligne " << command;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Files, Picture,
    testing::Values("tests/corpus/cube.json", "tests/corpus/letter_e.json", "tests/corpus/star_prism.json",
                    "tests/corpus/open_box.json", "tests/corpus/tunnel.json", "tests/corpus/plate_many_holes.json",
                    "tests/corpus/holes_behind_holes.json", "tests/corpus/cyclic_4.json",
                    "tests/corpus/two_prisms_penetrating.json", "tests/corpus/three_plates_penetrating.json",
                    "tests/corpus/spiral_stair.json", "tests/corpus/house.json", "examples/models/gear-pair.json",
                    "examples/models/pipe-tee.json", "examples/models/five-cubes.obj", "examples/models/stair-tower.obj"),
    kNameOfFile);

/// A picture that is spoilt on purpose is noticed.
TEST(SpoiltPicture, IsFound) {
  const auto command = [](const std::string& options) { return command_of("tests/corpus/letter_e.json", options); };
  const std::string view = "--direction=-0.41,0.77,-0.49 ";
  const nlohmann::json drawing = drawing_of(command(view));
  const Mask good = ink_of(command(view));
  EXPECT_TRUE(compare(good, drawing).none());
  /// The picture with every pixel taken from another place.
  const auto taken_from = [&](const auto& place) {
    Mask result(good.size(), 0);
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x) {
        const auto [u, v] = place(x, y);
        if (u >= 0 && v >= 0 && u < kWidth && v < kHeight) result[index(x, y)] = good[index(u, v)];
      }
    return compare(result, drawing);
  };
  constexpr int kHalf = kPixelsPerMm / 2;
  for (const auto& by : {std::pair{kHalf, 0}, {-kHalf, 0}, {0, kHalf}, {0, -kHalf}}) {
    const Disagreement moved = taken_from([&](int x, int y) { return std::pair(x - by.first, y - by.second); });
    EXPECT_GT(moved.stray, moved.dark / 20) << "moved by half a millimetre";
  }
  EXPECT_GT(taken_from([](int x, int y) { return std::pair(x, kHeight - 1 - y); }).bare, 0u) << "upside down";
  EXPECT_GT(taken_from([](int x, int y) { return std::pair(kWidth - 1 - x, y); }).bare, 0u) << "mirrored";
  const auto shrunk = [](int v, int size) { return static_cast<int>(std::lround(size / 2.0 + (v - size / 2.0) / 1.01)); };
  EXPECT_GT(taken_from([&](int x, int y) { return std::pair(shrunk(x, kWidth), shrunk(y, kHeight)); }).bare, 0u)
      << "a hundredth too large";
  for (const char* part : {"outline", "crease"})
    EXPECT_GT(compare(ink_of(command(view + "--edges " + part)), drawing).bare, 0u) << part << " alone";
  EXPECT_GT(compare(ink_of(command(view + "--hidden solid")), drawing).stray, 0u) << "hidden lines";
  EXPECT_GT(compare(ink_of(command("--direction=-0.42,0.77,-0.49")), drawing).bare, 0u) << "another view";
}

// Faces painted from the back to the front against the same faces filled by what is seen of each: two ways to one picture.

const std::filesystem::path kRunFolder = LIGNE_SOURCE_DIR;

Raster drawn(const std::string& file, const std::string& method, const std::string& fill) {
  const std::filesystem::path png =
      std::filesystem::temp_directory_path() / ("ligne-painting-" + std::to_string(getpid()) + ".png");
  const Outcome outcome =
      run_ligne(kRunFolder, {"draw", file, "--method", method, "--fill", fill, "--edges", "border", "--dpi", "150",
                             "--landscape", "--quality", "exact", "-q", "--threads", "1", "-o", png.string()});
  if (outcome.status != 0) throw std::runtime_error(outcome.err);
  Raster colors = read_raster(png);
  std::filesystem::remove(png);
  return colors;
}

bool are_alike(const std::array<int, 3>& a, const std::array<int, 3>& b) {
  constexpr int kRounding = 4;  // of colours blended along seams
  for (std::size_t c = 0; c < 3; ++c)
    if (std::abs(a[c] - b[c]) > kRounding) return false;
  return true;
}

/// Rims decide about pixels that are nearer to a border than this many.
constexpr int kBorder = 2;

/// Pixels in the middle of an area of one colour.
bool is_inside(const Raster& colors, int x, int y) {
  for (int dy = -kBorder; dy <= kBorder; ++dy)
    for (int dx = -kBorder; dx <= kBorder; ++dx)
      if (!are_alike(colors.at(x, y), colors.at(x + dx, y + dy))) return false;
  return true;
}

/// Seams between two pieces of a face show, a pixel wide; what is as wide as three is wrong.
bool differ_around(const Raster& a, const Raster& b, int x, int y) {
  for (int dy = -1; dy <= 1; ++dy)
    for (int dx = -1; dx <= 1; ++dx)
      if (are_alike(a.at(x + dx, y + dy), b.at(x + dx, y + dy))) return false;
  return true;
}

class Painting : public testing::TestWithParam<const char*> {};

TEST_P(Painting, ShowsWhatIsSeen) {
  const std::string file = GetParam();
  for (const char* fill : chosen("painting, " + file, 2, {"shade", "material", "random"})) {
    const Raster seen = drawn(file, "atherton-weiler", fill);
    for (const char* method : {"bsp", "newell", "convex-tree", "watkins", "zbuffer"}) {
      const Raster painted = drawn(file, method, fill);
      ASSERT_EQ(painted.pixels.size(), seen.pixels.size());
      std::size_t looked_at = 0, others = 0, white = 0;
      for (int y = kBorder; y + kBorder < seen.height; ++y) {
        for (int x = kBorder; x + kBorder < seen.width; ++x) {
          if (!is_inside(seen, x, y)) continue;
          ++looked_at;
          white += seen.at(x, y) == std::array{255, 255, 255};
          others += differ_around(painted, seen, x, y);
        }
      }
      EXPECT_GT(looked_at, white) << fill;
      EXPECT_EQ(others, 0u) << method << ' ' << fill << ": of " << looked_at;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Files, Painting,
                         testing::Values("tests/corpus/letter_e.json", "tests/corpus/cyclic_4.json",
                                         "tests/corpus/holes_behind_holes.json", "tests/corpus/house.json",
                                         "tests/corpus/two_prisms_penetrating.json", "tests/corpus/cube_in_glass.json",
                                         "tests/atherton_weiler/scenes/transparent_layers.json",
                                         "examples/models/gear-pair.json"),
                         kNameOfFile);

PaintPiece rectangle(std::uint32_t face, Point2 low, Point2 high) {
  return {face, {{low, {high.x, low.y}, high, {low.x, high.y}}}, {0, 0, 0}};
}

constexpr Rect kPage{{0, 0}, {100, 100}};

std::vector<std::uint32_t> left_of(std::vector<PaintPiece> pieces, const std::vector<std::uint32_t>& glass = {}) {
  PaintOrder order{std::move(pieces)};
  drop_hidden_pieces(order, kPage, [&](std::uint32_t face) { return std::ranges::find(glass, face) == glass.end(); });
  std::vector<std::uint32_t> faces;
  for (const PaintPiece& piece : order.pieces) faces.push_back(piece.face);
  return faces;
}

TEST(HiddenPieces, AreThoseThatAreWhollyBehindOthers) {
  using Faces = std::vector<std::uint32_t>;
  const PaintPiece front = rectangle(0, {10, 10}, {50, 50}), inside = rectangle(1, {20, 20}, {30, 30});
  EXPECT_EQ(left_of({inside, front}), Faces({0}));
  EXPECT_EQ(left_of({front, inside}), Faces({0, 1})) << "in front";
  EXPECT_EQ(left_of({inside, front}, {0}), Faces({1, 0})) << "behind glass";
  EXPECT_EQ(left_of({rectangle(1, {20, 20}, {50.3, 30}), front}), Faces({1, 0})) << "a third of a millimetre shows";
  EXPECT_EQ(left_of({rectangle(1, {60.02, 20}, {60.04, 30}), front}), Faces({1, 0})) << "between two samples";
  EXPECT_EQ(left_of({rectangle(1, {-5, -5}, {5, 5}), front}), Faces({1, 0})) << "over the corner of the page";
}

TEST(HiddenPieces, AreHiddenBySeveralTogether) {
  const PaintPiece left = rectangle(0, {10, 10}, {30, 50}), right = rectangle(1, {30, 10}, {50, 50});
  const PaintPiece behind = rectangle(2, {20, 20}, {40, 40});
  EXPECT_EQ(left_of({behind, left, right}), std::vector<std::uint32_t>({0, 1}));
  const PaintPiece apart = rectangle(1, {30.5, 10}, {50, 50});
  EXPECT_EQ(left_of({behind, left, apart}), std::vector<std::uint32_t>({2, 0, 1}));
}

TEST(HiddenPieces, ShowThroughHoles) {
  PaintPiece frame = rectangle(0, {10, 10}, {50, 50});
  frame.contours.push_back({{25, 25}, {25, 35}, {35, 35}, {35, 25}});
  const PaintPiece in_hole = rectangle(1, {28, 28}, {32, 32}), beside = rectangle(2, {12, 12}, {20, 20});
  EXPECT_EQ(left_of({in_hole, beside, frame}), std::vector<std::uint32_t>({1, 0}));
}

}  // namespace
}  // namespace ligne::test
