// Solids that touch: every line once, and all of it.

#include "support/scenes.hpp"

namespace ligne::test {
namespace {

constexpr int kSide = 8;

enum class Corners { exact, rotated_corners, rotated_centres };

/// 8 x 8 x 8 unit cubes face to face, each its own object, with the corners rounded to double after a rotation in one of two
/// ways: corner by corner (common corners stay equal), or as centre plus half-diagonals (they differ in the last bits).
Scene cubes(Corners corners, const Basis& basis) {
  Scene scene;
  for (int k = 0; k < kSide; ++k) {
    for (int j = 0; j < kSide; ++j)
      for (int i = 0; i < kSide; ++i) {
        const Point3 corner{double(i), double(j), double(k)};
        if (corners != Corners::rotated_centres) {
          add_box(scene, corner, {1, 1, 1}, basis);
          continue;
        }
        const Point3 c = corner + Point3{0.5, 0.5, 0.5};
        const Point3 centre = basis[0] * c.x + basis[1] * c.y + basis[2] * c.z;
        add_box(scene, {-0.5, -0.5, -0.5}, {1, 1, 1}, basis);
        for (std::size_t v = scene.vertices.size() - 8; v < scene.vertices.size(); ++v) scene.vertices[v] += centre;
        scene.objects.back().precision = kSide * 0x1p-52;
      }
  }
  return scene;
}

/// On each of the three visible sides of the block 9 + 9 lines of length 8; the 24 units on the three inner edges and on
/// the rim belong to two sides where they meet.
double ideal_length(const Picture& picture, const Basis& basis) {
  double sum = 0;
  const Camera& camera = picture.projected.view.camera;
  for (const Point3& axis : basis) {
    const double seen = std::sqrt(1 - std::pow(glm::dot(axis, camera.forward), 2)) * picture.projected.view.scale;
    // Lines along this axis: 9 + 9 on the two visible sides that contain it, one of them common to both.
    sum += (2 * (kSide + 1) - 1) * kSide * seen;
  }
  return sum;
}

class TouchingCubes : public testing::TestWithParam<Corners> {};

TEST_P(TouchingCubes, EveryLineOnceAndAllOfIt) {
  const Basis basis = GetParam() == Corners::exact ? kUpright : rotation(0.3, 0.7, -1.1);
  const Scene scene = cubes(GetParam(), basis);
  for (const char* edges : {"feature", "all"})
    for (const Point3& direction : {Point3{-1, 1, -1}, Point3{0.3, 0.5, -0.8}, Point3{-0.11, 0.93, 0.2}}) {
      const Picture p = draw(scene, {along(direction), edges});
      EXPECT_NEAR(p.length() / ideal_length(p, basis), 1, 0.0005) << edges << " along " << direction.x;
    }
}

INSTANTIATE_TEST_SUITE_P(AllCorners, TouchingCubes,
                         testing::Values(Corners::exact, Corners::rotated_corners, Corners::rotated_centres));

TEST(TouchingCubes, SeenStraightOn) {
  const Scene scene = cubes(Corners::exact, kUpright);
  CameraRequest front;
  front.named_view = "front";
  const Picture p = draw(scene, {front, "all", false, 10});
  EXPECT_NEAR(p.length(), 2 * (kSide + 1) * kSide * 10, 0.001 * 2 * (kSide + 1) * kSide);
}

// A corner beside a facet sees the errors of the facet's corners enlarged: the fourth corner of a parallelogram three times.
TEST(Touching, OnePlateCutByEitherDiagonalDoesNotPenetrateItself) {
  const Scene scene = scene_of_faces({{{0, 0, 0}, {4, 0, 0}, {4, 0, 4}},
                                      {{0, 0, 0}, {4, 0, 4}, {0, 0, 4}},
                                      {{0, 0, 0}, {4, 0, 0}, {0, 0, 4}},
                                      {{4, 0, 0}, {4, 0, 4}, {0, 0, 4}}});
  for (int i = 0; i < 64; ++i) {
    const Point3 eye{5.4375 + i / 16.0, -4.59375, 4.40625 + i / 32.0};
    EXPECT_EQ(draw(scene, {from_eye(eye, {2, 0, 2})}).length_of(LineClass::intersection), 0) << "from " << eye.x;
  }
}

// Heaps of sheets in one plane: so many that cells of the grid know their plane, and ask none of them.

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
  for (const ProjectedEdge& e : scene.edges)
    if (e.line_class != LineClass::mesh)
      sum += glm::length(scene.lattice.to_mm(scene.vertices[e.v1].p) - scene.lattice.to_mm(scene.vertices[e.v0].p));
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
                         [](const auto& info) { return as_test_name(info.param); });

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
