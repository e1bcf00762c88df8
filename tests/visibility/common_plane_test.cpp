// Heaps of sheets in one plane: so many that cells of the grid know their plane, and ask none of them.

#include <gtest/gtest.h>

#include <random>

#include "support/scenes.hpp"

namespace ligne::test {
namespace {

constexpr double kScale = 20;  ///< page mm by unit
constexpr int kSheets = 150;

/// Rectangles of all sizes in the square from -4 to 4, in a plane turned by `turn`, `above` it.
void add_heap(Scene& scene, const Basis& turn, double above, double size, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(-4, 4 - size), side(0.3 * size, size);
  for (int i = 0; i < kSheets; ++i) {
    const double x = place(random), y = place(random), w = side(random), h = side(random);
    const auto at = [&](double u, double v) { return turn[0] * u + turn[1] * v + turn[2] * above; };
    add_face(scene, {{at(x, y), at(x + w, y), at(x + w, y + h), at(x, y + h)}});
  }
}

PictureRequest request(const std::string& method, const Basis& turn, bool hidden) {
  return {along(-turn[2] + turn[0] * 0.7 + turn[1] * 0.4), "all", hidden, kScale, method};
}

/// Page length of the sides of all faces.
double length_of_sides(const Picture& picture) {
  double sum = 0;
  const ProjectedScene& scene = picture.projected;
  for (const ProjectedEdge& e : scene.edges) {
    if (e.line_class != LineClass::mesh)
      sum += glm::length(scene.lattice.to_mm(scene.vertices[e.v1].p) - scene.lattice.to_mm(scene.vertices[e.v0].p));
  }
  return sum;
}

class HeapsOfSheets : public testing::TestWithParam<const char*> {};

TEST_P(HeapsOfSheets, HideNothingOfEachOtherAndDoNotPenetrate) {
  for (const unsigned seed : {1u, 2u, 3u}) {
    const Basis turn = rotation(0.3 * seed, 0.2, 0.5);
    Scene scene;
    add_heap(scene, turn, 0, 3, seed);
    const Picture picture = draw(scene, request(GetParam(), turn, true));
    EXPECT_EQ(picture.length(false), 0) << seed;
    EXPECT_EQ(picture.length_of(LineClass::intersection), 0) << seed;
    EXPECT_NEAR(picture.length(), length_of_sides(picture), 0.01) << seed;
  }
}

INSTANTIATE_TEST_SUITE_P(Methods, HeapsOfSheets, testing::Values("appel", "watkins", "atherton-weiler", "warnock"),
                         [](const auto& info) {
                           std::string name = info.param;
                           std::erase(name, '-');
                           return name;
                         });

// Ten times as far apart as what touches. The method warnock asks no plane of a cell.
TEST(HeapOfSheets, HidesWhatIsHardlyBehindIt) {
  const Basis turn = rotation(0.3, 0.2, 0.5);
  Scene scene;
  add_heap(scene, turn, 0, 1, 1);
  const double alone = draw(scene, request("appel", turn, true)).length();
  add_heap(scene, turn, -2e-5, 1, 2);
  const Picture picture = draw(scene, request("appel", turn, true)), other = draw(scene, request("warnock", turn, true));
  EXPECT_NEAR(picture.length(), other.length(), 0.01);
  EXPECT_NEAR(picture.length(false), other.length(false), 0.01);
  EXPECT_GT(picture.length(), 1.05 * alone) << "what is seen between the sheets";
  EXPECT_GT(picture.length(false), 0.5 * alone);
}

// The cells of the heap know its plane, and lines that leave it are held against every sheet all the same.
TEST(HeapOfSheets, IsPenetratedByABox) {
  const Basis turn = rotation(0.3, 0.2, 0.5);
  Scene heap;
  add_heap(heap, turn, 0, 3, 1);
  Scene plate;
  const Point3 x = turn[0] * 4.0, y = turn[1] * 4.0;
  add_face(plate, {{-x - y, x - y, x + y, -x + y}});
  add_face(heap, {{-x - y, x - y, x + y, -x + y}});
  double lengths[2];
  int k = 0;
  for (Scene* scene : {&plate, &heap}) {
    add_box(*scene, {-0.5, -0.5, -0.5}, {1, 1, 1}, turn);
    lengths[k++] = draw(*scene, request("appel", turn, false)).length_of(LineClass::intersection);
  }
  EXPECT_GT(lengths[0], kScale);
  EXPECT_NEAR(lengths[1], lengths[0], 0.01) << "the same line, whatever the plate is made of";
}

}  // namespace
}  // namespace ligne::test
