// The program's PNG against a z-buffer of the same scene that shares no geometry with it: every dark pixel lies where the
// faces seen change or an edge is seen, and where the picture jumps there is ink. Rough, a pixel to a quarter of a
// millimetre, but of the whole way from the file to the page.

#include <unistd.h>

#include "cli/program.hpp"
#include "picture/z_buffer.hpp"
#include "scene/readers/reader.hpp"

namespace ligne::test {
namespace {

const std::filesystem::path kSource = LIGNE_SOURCE_DIR;

/// No round things of broad facets: between two pixels near their rim whole facets can lie, and a smooth surface jumps
/// there.
constexpr const char* kFiles[] = {"tests/corpus/cube.json",
                                  "tests/corpus/letter_e.json",
                                  "tests/corpus/star_prism.json",
                                  "tests/corpus/open_box.json",
                                  "tests/corpus/tunnel.json",
                                  "tests/corpus/plate_many_holes.json",
                                  "tests/corpus/holes_behind_holes.json",
                                  "tests/corpus/cyclic_4.json",
                                  "tests/corpus/two_prisms_penetrating.json",
                                  "tests/corpus/three_plates_penetrating.json",
                                  "tests/corpus/spiral_stair.json",
                                  "tests/corpus/house.json",
                                  "examples/models/gear-pair.json",
                                  "examples/models/pipe-tee.json",
                                  "examples/models/five-cubes.obj",
                                  "examples/models/stair-tower.obj"};

std::string text(const Point3& p) {
  char buffer[96];
  std::snprintf(buffer, sizeof buffer, "%.17g,%.17g,%.17g", p.x, p.y, p.z);
  return buffer;
}

/// A view, with the same on the command line.
struct NamedView {
  ViewPoint view;
  Words options;
};

NamedView parallel(const Point3& direction) { return {{direction}, {"--direction=" + text(direction)}}; }

/// From three radii of the bounding box off, at an angle so wide that all is in view.
NamedView perspective(const Scene& scene, const Point3& towards) {
  Point3 low = scene.vertices[0], high = low;
  for (const Point3& v : scene.vertices) low = glm::min(low, v), high = glm::max(high, v);
  const Point3 target = (low + high) * 0.5, eye = target - towards * (1.5 * glm::distance(low, high));
  return {{target - eye, eye}, {"--eye=" + text(eye), "--target=" + text(target), "--fov=90"}};
}

class PictureTest : public testing::Test {
 protected:
  Scene read(const std::string& file) const {
    Warnings warnings;
    return read_scene(kSource / file, {}, warnings);
  }

  /// The ink of the program's drawing; `command` tells how to get it.
  Ink drawn(const std::string& file, Words options, std::string* command = nullptr) const {
    const std::filesystem::path png =
        std::filesystem::temp_directory_path() / ("ligne-picture-" + std::to_string(getpid()) + ".png");
    const std::string dpi = std::to_string(kPixelsPerMm * 25.4);
    options = Words{"draw", file} + options;
    // Creases have 0.7 of the pen's width: 1.4 pixels, so that half of a pixel is covered wherever the line runs.
    options += {"--up=0,0,1", "--landscape", "--pen-width", "0.5mm", "--dpi", dpi,         "--threads",
                "1",          "-q",          "--quality",   "exact", "-o",    png.string()};
    if (command) {
      *command = "ligne";
      for (const std::string& option : options) *command += " " + option;
    }
    const Outcome outcome = run_ligne(kSource, options);
    if (outcome.status != 0) throw std::runtime_error(outcome.err);
    Ink ink = read_ink(png);
    std::filesystem::remove(png);
    return ink;
  }
};

class Picture : public PictureTest, public testing::WithParamInterface<const char*> {};

TEST_P(Picture, ShowsTheSameAsTheDrawing) {
  const Scene scene = read(GetParam());
  for (const NamedView& v : {parallel({-0.41, 0.77, -0.49}), perspective(scene, {0.62, 0.54, -0.57})}) {
    std::string command;
    const Ink ink = drawn(GetParam(), v.options, &command);
    const Disagreement found = compare(ink, ZBuffer(scene, v.view));
    EXPECT_TRUE(found.none()) << GetParam() << ": " << found.words() << "\n  " << command;
  }
}

INSTANTIATE_TEST_SUITE_P(Files, Picture, testing::ValuesIn(kFiles), kNameOfFile);

/// Drawings that are spoilt on purpose.
class SpoiltPicture : public PictureTest {
 protected:
  const std::string file_ = "tests/corpus/letter_e.json";
  const NamedView view_ = parallel({-0.41, 0.77, -0.49});
  const Scene scene_ = read(file_);
  const ZBuffer picture_{scene_, view_.view};
  const Ink good_ = drawn(file_, view_.options);

  /// The picture with every pixel taken from another place.
  template <class Function>
  Ink taken_from(const Function& place) const {
    Ink result(good_.size(), 0);
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        const Pixel p = place(x, y);
        if (p.x < 0 || p.y < 0 || p.x >= kWidth || p.y >= kHeight) continue;
        result[static_cast<std::size_t>(y) * kWidth + static_cast<std::size_t>(x)] =
            good_[static_cast<std::size_t>(p.y) * kWidth + static_cast<std::size_t>(p.x)];
      }
    }
    return result;
  }
  Disagreement of(const Ink& ink) const { return compare(ink, picture_); }
};

TEST_F(SpoiltPicture, AgreesBeforeItIsSpoilt) { EXPECT_TRUE(of(good_).none()) << of(good_).words(); }

TEST_F(SpoiltPicture, IsFoundHalfAMillimetreOff) {
  constexpr int kHalf = kPixelsPerMm / 2;
  for (const Pixel by : {Pixel{kHalf, 0}, Pixel{-kHalf, 0}, Pixel{0, kHalf}, Pixel{0, -kHalf}}) {
    const Disagreement found = of(taken_from([&](int x, int y) { return Pixel{x - by.x, y - by.y}; }));
    // No jump misses its ink by so little, the pen being half a millimetre wide: the ink beside the lines tells.
    EXPECT_GT(found.stray, found.ink / 10) << by.x << ", " << by.y << ": " << found.words();
  }
}

TEST_F(SpoiltPicture, IsFoundFlipped) {
  EXPECT_GT(of(taken_from([](int x, int y) { return Pixel{x, kHeight - 1 - y}; })).stray, 0u);
  EXPECT_GT(of(taken_from([](int x, int y) { return Pixel{kWidth - 1 - x, y}; })).stray, 0u);
}

TEST_F(SpoiltPicture, IsFoundAHundredthTooLarge) {
  const auto shrunk = [](int v, int size) { return static_cast<int>(std::lround(size / 2.0 + (v - size / 2.0) / 1.01)); };
  const Disagreement found = of(taken_from([&](int x, int y) { return Pixel{shrunk(x, kWidth), shrunk(y, kHeight)}; }));
  EXPECT_GT(found.stray, 0u);
  EXPECT_GT(found.missing, 0u);
}

TEST_F(SpoiltPicture, IsFoundWithoutALayer) {
  for (const char* rest : {"outline", "crease"})
    EXPECT_GT(of(drawn(file_, view_.options + Words{"--edges", rest})).missing, 0u) << rest;
}

TEST_F(SpoiltPicture, IsFoundWithHiddenLines) { EXPECT_GT(of(drawn(file_, view_.options + "--hidden solid")).stray, 0u); }

TEST_F(SpoiltPicture, IsFoundInAnotherView) {
  EXPECT_GT(of(drawn(file_, parallel({-0.42, 0.77, -0.49}).options)).missing, 0u);
}

}  // namespace
}  // namespace ligne::test
