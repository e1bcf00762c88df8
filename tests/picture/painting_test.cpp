// Faces painted from the back to the front against the same faces filled by what is seen of each: two ways to one picture.

#include <unistd.h>

#include "cli/program.hpp"
#include "main/tier.hpp"
#include "picture/hidden_pieces.hpp"
#include "picture/raster.hpp"

namespace ligne::test {
namespace {

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
