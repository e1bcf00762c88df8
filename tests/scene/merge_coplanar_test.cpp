#include "scene/clean/clean.hpp"
#include "support/test.hpp"

namespace ligne {
namespace {

using Corners = std::vector<std::uint32_t>;
using Keep = std::function<bool(int, int)>;

/// Quadrilaterals of a grid of unit cells in the plane z = height(x, y), those that `keep` names, seen from above
/// counter-clockwise; cut into triangles when asked.
Scene grid(
    int columns, int rows, const Keep& keep, bool triangles = false,
    const std::function<double(int, int)>& height = [](int, int) { return 0.0; }) {
  Scene scene;
  for (int y = 0; y <= rows; ++y)
    for (int x = 0; x <= columns; ++x) scene.vertices.emplace_back(x, y, height(x, y));
  for (int y = 0; y < rows; ++y) {
    for (int x = 0; x < columns; ++x) {
      if (!keep(x, y)) continue;
      const auto v = [&](int dx, int dy) { return static_cast<std::uint32_t>((y + dy) * (columns + 1) + x + dx); };
      if (triangles) {
        scene.faces.add_triangle(v(0, 0), v(1, 0), v(1, 1));
        scene.faces.add_triangle(v(0, 0), v(1, 1), v(0, 1));
      } else {
        scene.faces.add_face(Corners{v(0, 0), v(1, 0), v(1, 1), v(0, 1)});
      }
    }
  }
  return scene;
}

Scene merged(Scene scene) {
  Warnings warnings;
  finish_scene(scene, warnings);
  EXPECT_TRUE(warnings.counts().empty());
  merge_coplanar_faces(scene);
  return scene;
}

std::span<const std::uint32_t> contour(const Scene& scene, std::size_t f, std::size_t c) {
  return std::as_const(scene.faces).contour(f, c);
}

double area(const Scene& scene, std::size_t f, std::size_t c) {
  double sum = 0;
  Point3 a = scene.vertices[contour(scene, f, c).back()];
  for (const std::uint32_t v : contour(scene, f, c)) {
    const Point3 b = scene.vertices[v];
    sum += a.x * b.y - a.y * b.x;
    a = b;
  }
  return sum / 2;
}

/// Corners of a contour as points, turned so that the least one comes first.
std::vector<std::array<double, 3>> points(const Scene& scene, std::size_t f, std::size_t c) {
  std::vector<std::array<double, 3>> out;
  for (const std::uint32_t v : contour(scene, f, c))
    out.push_back({scene.vertices[v].x, scene.vertices[v].y, scene.vertices[v].z});
  std::rotate(out.begin(), std::min_element(out.begin(), out.end()), out.end());
  return out;
}

using ContourPoints = std::vector<std::array<double, 3>>;

const Keep kAll = [](int, int) { return true; };

TEST(MergeCoplanar, GridWithHole) {
  for (const bool triangles : {false, true}) {
    const Scene scene = merged(grid(
        3, 3, [](int x, int y) { return x != 1 || y != 1; }, triangles));
    ASSERT_EQ(scene.faces.size(), 1u);
    ASSERT_EQ(scene.faces.contour_count(0), 2u);
    EXPECT_EQ(points(scene, 0, 0), (ContourPoints{{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {0, 3, 0}}));
    EXPECT_EQ(points(scene, 0, 1), (ContourPoints{{1, 1, 0}, {1, 2, 0}, {2, 2, 0}, {2, 1, 0}}));
    EXPECT_EQ(scene.vertices.size(), 8u) << "the vertices left out are gone";
    EXPECT_EQ(scene.objects[0].face_end, 1u);
    EXPECT_EQ(scene.objects[0].vertex_end, 8u);
  }
}

TEST(MergeCoplanar, FacesAreTheConnectedPiecesOfAPicture) {
  struct Row {
    const char* name;
    std::vector<std::string> cells;                                  ///< rows from the lowest y
    std::vector<std::vector<std::pair<double, std::size_t>>> faces;  ///< area and corners of each contour
  };
  for (const Row& row : {Row{"two pieces", {"##.##", "##.##"}, {{{4, 4}}, {{4, 4}}}},
                         Row{"pieces that touch in a corner", {"##..", "##..", "..##", "..##"}, {{{4, 4}}, {{4, 4}}}},
                         Row{"holes that share a corner", {"####", "#.##", "##.#", "####"}, {{{16, 4}, {-1, 4}, {-1, 4}}}},
                         Row{"a hole that touches the border", {".##", "#.#", "###"}, {{{8, 6}, {-1, 4}}}},
                         Row{"an island in a hole, which is a face of its own",
                             {"#######", "#.....#", "#.###.#", "#.###.#", "#.###.#", "#.....#", "#######"},
                             {{{49, 4}, {-25, 4}}, {{9, 4}}}}}) {
    SCOPED_TRACE(row.name);
    const Scene scene = merged(grid(static_cast<int>(row.cells[0].size()), static_cast<int>(row.cells.size()),
                                    [&](int x, int y) { return row.cells[std::size_t(y)][std::size_t(x)] == '#'; }));
    ASSERT_EQ(scene.faces.size(), row.faces.size());
    for (std::size_t f = 0; f < row.faces.size(); ++f) {
      ASSERT_EQ(scene.faces.contour_count(f), row.faces[f].size());
      for (std::size_t c = 0; c < row.faces[f].size(); ++c)
        EXPECT_EQ(std::pair(area(scene, f, c), contour(scene, f, c).size()), row.faces[f][c]);
    }
  }
}

TEST(MergeCoplanar, MaterialsStayApart) {
  Scene scene = grid(4, 2, kAll);
  scene.face_material = {0, 0, 1, 1, 0, 0, 1, 1};
  scene.materials.resize(2);
  scene.details = {{7, 0, {{3.5, 1.5, 0}}}};
  const Scene out = merged(scene);
  ASSERT_EQ(out.faces.size(), 2u);
  EXPECT_EQ(out.face_material, (Corners{0, 1}));
  EXPECT_EQ(out.details[0].face, 1u);
  EXPECT_EQ(points(out, 0, 0), (ContourPoints{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}}));
}

TEST(MergeCoplanar, ObjectsStayApart) {
  Scene scene = grid(2, 1, kAll);
  Scene second = grid(2, 1, kAll);
  scene.objects = {{"a", 0, 6, 0, 2, 0}, {"b", 6, 12, 2, 4, 0}};
  scene.vertices.insert(scene.vertices.end(), second.vertices.begin(), second.vertices.end());
  for (std::size_t f = 0; f < 2; ++f) {
    Corners face;
    for (const std::uint32_t v : contour(second, f, 0)) face.push_back(v + 6);
    scene.faces.add_face(face);
  }
  const Scene out = merged(scene);
  ASSERT_EQ(out.faces.size(), 2u);
  EXPECT_EQ(out.objects[0].face_end, 1u);
  EXPECT_EQ(out.objects[1].face_begin, 1u);
  EXPECT_EQ(out.objects[1].face_end, 2u);
  EXPECT_EQ(out.objects[1].vertex_begin, 4u);
  EXPECT_EQ(out.objects[1].vertex_end, 8u);
}

TEST(MergeCoplanar, BentFacesStayApart) {
  const auto roof = [](int x, int) { return x <= 2 ? 0.5 * x : 2 - 0.5 * x; };
  const Scene scene = merged(grid(4, 3, kAll, true, roof));
  ASSERT_EQ(scene.faces.size(), 2u);
  EXPECT_EQ(points(scene, 0, 0), (ContourPoints{{0, 0, 0}, {2, 0, 1}, {2, 3, 1}, {0, 3, 0}}))
      << "the ridge has lost its vertices on both sides";
}

TEST(MergeCoplanar, GentleCurvesAreNotFlattened) {
  // Each facet bends away from the one before by less than the tolerance, all together by far more.
  constexpr int kFacets = 400;
  constexpr double kPrecision = 1e-5;
  Scene scene = grid(kFacets, 1, kAll, false, [](int x, int) { return 1e-5 * x * x; });
  scene.objects = {{"", 0, static_cast<std::uint32_t>(scene.vertices.size()), 0, kFacets, kPrecision}};
  const Scene out = merged(scene);
  EXPECT_GT(out.faces.size(), 20u);
  EXPECT_LT(out.faces.size(), 400u);
  // And every new contour keeps near the old surface: its chords are short where the curve is.
  for (std::size_t f = 0; f < out.faces.size(); ++f)
    for (const std::uint32_t v : contour(out, f, 0))
      EXPECT_DOUBLE_EQ(out.vertices[v].z, 1e-5 * out.vertices[v].x * out.vertices[v].x);
}

TEST(MergeCoplanar, RoundBordersKeepTheirVertices) {
  // A fan of a disc: one face, and no vertex of its fine border is lost.
  constexpr std::uint32_t kCorners = 2000;
  Scene scene;
  scene.vertices.emplace_back(0, 0, 0);
  for (std::uint32_t k = 0; k < kCorners; ++k) {
    const double angle = 2 * std::numbers::pi * k / kCorners;
    scene.vertices.emplace_back(std::cos(angle), std::sin(angle), 0);
  }
  for (std::uint32_t k = 0; k < kCorners; ++k) scene.faces.add_triangle(0, 1 + k, 1 + (k + 1) % kCorners);
  // With this precision each vertex alone lies on the chord of its neighbours.
  scene.objects = {{"", 0, kCorners + 1, 0, kCorners, 1e-5}};
  const Scene out = merged(scene);
  ASSERT_EQ(out.faces.size(), 1u);
  EXPECT_EQ(out.faces.contour_count(0), 1u);
  EXPECT_EQ(contour(out, 0, 0).size(), kCorners);
}

TEST(MergeCoplanar, VerticesThatOthersUseStay) {
  // A wall of one face stands on the middle of the border of a plate of two.
  Scene scene = grid(2, 1, kAll);
  const auto n = static_cast<std::uint32_t>(scene.vertices.size());
  scene.vertices.emplace_back(1, 0, 1), scene.vertices.emplace_back(2, 0, 1);
  scene.faces.add_face(Corners{1, n, n + 1, 2});
  const Scene out = merged(scene);
  ASSERT_EQ(out.faces.size(), 2u);
  EXPECT_EQ(points(out, 0, 0), (ContourPoints{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}}));
}

TEST(MergeCoplanar, WallInsideOfAPlate) {
  // The foot of the wall lies on edges that have two faces of the plate already: they cancel, and the wall keeps its own.
  Scene scene = grid(3, 2, kAll);
  const auto n = static_cast<std::uint32_t>(scene.vertices.size());
  scene.vertices.emplace_back(1, 1, 1), scene.vertices.emplace_back(2, 1, 1);
  scene.faces.add_face(Corners{5, 6, n + 1, n});
  const Scene out = merged(scene);
  ASSERT_EQ(out.faces.size(), 2u);
  EXPECT_EQ(out.faces.contour_count(0), 1u);
  EXPECT_EQ(area(out, 0, 0), 6);
  EXPECT_EQ(contour(out, 1, 0).size(), 4u);
}

TEST(MergeCoplanar, OppositeWindingsStayApart) {
  Scene scene = grid(1, 1, kAll);
  scene.vertices.emplace_back(2, 0, 0), scene.vertices.emplace_back(2, 1, 0);
  scene.faces.add_face(Corners{1, 3, 5, 4});  // clockwise, runs through the edge 1 3 as the first face does
  EXPECT_EQ(merged(scene).faces.size(), 2u);
}

TEST(MergeCoplanar, FlagsOfTheBorderStay) {
  Scene scene = grid(2, 1, kAll);
  scene.corner_flags = {0, 0, kCornerFileHidden, 0, 0, 0, kCornerFileHidden, 0};
  const Scene out = merged(scene);
  ASSERT_EQ(out.faces.size(), 1u);
  const auto corners = contour(out, 0, 0);
  ASSERT_EQ(corners.size(), 4u);
  for (std::size_t k = 0; k < 4; ++k)
    EXPECT_EQ(out.corner_flags[k], out.vertices[corners[k]] == Point3(2, 1, 0) ? kCornerFileHidden : 0);
  // Where the flags along a straight run differ, the vertex between them stays.
  Scene uneven = grid(2, 1, kAll);
  uneven.corner_flags = {0, 0, 0, 0, 0, 0, kCornerFileHidden, 0};
  EXPECT_EQ(contour(merged(uneven), 0, 0).size(), 5u);
}

TEST(MergeCoplanar, TrianglesWithoutAreaJoin) {
  // The square's right side is cut by a vertex that a triangle without area joins to the next square.
  Scene scene;
  scene.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1, 0.5, 0}, {2, 0, 0}, {2, 1, 0}};
  scene.faces.add_face(Corners{0, 1, 2, 3});
  scene.faces.add_face(Corners{1, 4, 2});
  scene.faces.add_face(Corners{1, 5, 6, 2, 4});
  const Scene out = merged(scene);
  ASSERT_EQ(out.faces.size(), 1u);
  EXPECT_EQ(points(out, 0, 0), (ContourPoints{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}}));
}

}  // namespace
}  // namespace ligne
