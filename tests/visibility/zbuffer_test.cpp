// The depth buffer: depths worked out by hand, without gaps; objects added later; lines sampled. Pixels of all methods that
// paint some, against a plain search.

#include "base/parallel.hpp"
#include "main/tier.hpp"
#include "scene/readers/reader.hpp"
#include "support/corpus_scene.hpp"
#include "support/scenes.hpp"
#include "support/standard_views.hpp"
#include "visibility/raster/depth_buffer.hpp"
#include "visibility/zbuffer/edge_sampling.hpp"

namespace ligne::test {
namespace {

using namespace zbuffer;

constexpr Filling kFillings[] = {Filling::table, Filling::fixed};

View view_at(const CameraRequest& request, const Scene& scene, double scale = 1) {
  return make_view(scene, make_camera(request, scene), {{{0, 0}, {100, 100}}}, {{0, 0}, {100, 100}}, scale);
}

ProjectedScene projected(const Scene& scene, const View& view) {
  return project(scene, build_topology(scene), view, {classes("all"), 30});
}

DepthBuffer painted(const ProjectedScene& scene, std::uint32_t rows, Filling filling = Filling::table,
                    DepthScale scale = {}) {
  DepthBuffer buffer(PixelGrid::over(scene.view.window, rows), scale);
  buffer.add(scene, filling);
  return buffer;
}

/// Looking down on the plane z = 0; x is rightwards.
CameraRequest from_above() { return along({0, 0, -1}); }

TEST(ZBuffer, AStripGetsLargerPixels) {
  const PixelGrid grid = PixelGrid::over({{0, 0}, {200, 0.001}}, 100);
  EXPECT_EQ(grid.width, 1600u);
  EXPECT_EQ(grid.height, 1u);
  EXPECT_EQ(grid.pixel_mm, 0.125);
}

TEST(ZBuffer, ARampByHand) {
  // 80 x 80 mm in the middle of the sheet of 100 pixels of 1 mm; from left to right it rises by 40 mm, towards the eye.
  Scene scene;
  add_face(scene, {{{0, 0, 0}, {80, 0, 40}, {80, 80, 40}, {0, 80, 0}}});
  for (const Filling filling : kFillings) {
    const DepthBuffer buffer = painted(projected(scene, view_at(from_above(), scene)), 100, filling);
    EXPECT_EQ(buffer.face(9, 50), DepthBuffer::kNothing);
    EXPECT_EQ(buffer.face(90, 50), DepthBuffer::kNothing);
    EXPECT_EQ(buffer.face(50, 9), DepthBuffer::kNothing);
    // The middle of the scene has depth 0. The centre of pixel 10 is half a millimetre from the left side.
    EXPECT_NEAR(buffer.depth(10, 10), 20 - 0.25, 1e-5);
    EXPECT_NEAR(buffer.depth(89, 89), -20 + 0.25, 1e-5);
    EXPECT_NEAR(buffer.depth(50, 30), -0.25, 1e-5);
    EXPECT_NEAR(buffer.hiding_depth(50, 30), 0.25, 1e-4);
  }
}

/// Section 5.1 of the lecture: z_a = z_3 - (z_3 - z_1)(y_3 - y_s)/(y_3 - y_1), z_b = z_3 - (z_3 - z_2)(y_3 - y_s)/(y_3 -
/// y_2), z_p = z_b - (z_b - z_a)(x_b - x_p)/(x_b - x_a); the fourth corner makes the face skew.
TEST(ZBuffer, DepthOfASkewFaceIsInterpolated) {
  Scene scene;
  add_face(scene, {{{0, 0, 0}, {80, 0, 0}, {80, 80, 40}, {0, 80, 0}}});
  const DepthBuffer buffer = painted(projected(scene, view_at(from_above(), scene)), 100);
  // On the line whose centre is s above the lower side, the depth runs from 0 on the left to s/2 on the right.
  for (const std::uint32_t row : {20u, 50u, 80u}) {
    const double s = 90 - (row + 0.5);
    for (const std::uint32_t column : {15u, 45u, 85u}) {
      const double share = (column + 0.5 - 10) / 80;
      EXPECT_NEAR(buffer.depth(column, row), 20 - share * s / 2, 1e-4) << column << ", " << row;
    }
  }
}

/// A surface of triangles that covers the sheet: every pixel is painted once.
TEST(ZBuffer, NeighboursShareNothingAndLeaveNothingOut) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> move(-0.9, 0.9);
  constexpr int kCells = 30;
  Scene scene;
  begin_object(scene);
  for (int j = 0; j <= kCells; ++j)
    for (int i = 0; i <= kCells; ++i)
      scene.vertices.push_back({i * 4.0 + move(random), j * 4.0 + move(random), move(random)});
  for (std::uint32_t j = 0; j < kCells; ++j)
    for (std::uint32_t i = 0; i < kCells; ++i) {
      const std::uint32_t a = j * (kCells + 1) + i, b = a + 1, c = a + kCells + 1, d = c + 1;
      if ((i + j) % 3 == 0) {
        scene.faces.add_face(std::vector<std::uint32_t>{a, b, d, c});
      } else {
        scene.faces.add_triangle(a, b, c);
        scene.faces.add_triangle(b, d, c);
      }
    }
  end_object(scene);
  const ProjectedScene page = projected(scene, view_at(from_above(), scene));
  for (const Filling filling : kFillings) {
    DepthBuffer buffer(PixelGrid::over(page.view.window, 333), {});
    const PaintCounts counts = buffer.add(page, filling);
    EXPECT_EQ(counts.tests, 333u * 333u);
    EXPECT_EQ(counts.writes, 333u * 333u);
  }
}

constexpr std::uintmax_t kMostBytes = 20'000;

/// Depths at a point of the lattice: of the nearest triangle that surely holds it, of the nearest that may hold it, and of a
/// face.
struct DepthsAt {
  double surely = HUGE_VAL, maybe = HUGE_VAL, of_face = HUGE_VAL;
};

DepthsAt depths_at(const ProjectedScene& scene, Point2 p, std::uint32_t face) {
  constexpr double kInside = 1e-3;
  DepthsAt nearest;
  for_triangles_at(scene, p, [&](const Triangle& t, double z, double least) {
    if (!scene.face_is_transparent.empty() && scene.face_is_transparent[t.face]) return;  // not in the pixels
    if (scene.is_edge_on(t)) return;
    if (least > kInside) nearest.surely = std::min(nearest.surely, z);
    if (least > -kInside) nearest.maybe = std::min(nearest.maybe, z);
    if (least > -kInside && t.face == face) nearest.of_face = std::min(nearest.of_face, z);
  });
  return nearest;
}

/// The depth buffer by both of its fillings, and the painter by its three sorts, where it says nothing against its order.
TEST(Pixels, ShowWhatAPlainSearchFindsOnTheCorpus) {
  constexpr double kDepthMm = 0.01;
  struct Way {
    const char *method, *setting;
    unsigned word;
  };
  std::size_t compared = 0, number = 0;
  std::map<std::string, int> right, beyond;
  for (const std::filesystem::path& file : corpus_files(kMostBytes)) {
    if (!is_chosen("scenes of pixels", number++, 3)) continue;
    const Scene scene = scene_of_file(file);
    for (const StandardView& standard : standard_views(scene)) {
      if (std::string_view(standard.name) != "odd" && std::string_view(standard.name) != "near") continue;
      const View view = make_view(scene, make_camera(standard.camera, scene), standard.sheet.frame, standard.sheet.page,
                                  standard.sheet.scale);
      const ProjectedScene page = projected(scene, view);
      for (const Way& way : {Way{"zbuffer", "filling", 0},
                             {"zbuffer", "filling", 1},
                             {"painter", "depth-sort", 0},
                             {"painter", "depth-sort", 1},
                             {"painter", "depth-sort", 2}}) {
        SCOPED_TRACE(file.stem().string() + ", " + standard.name + ", " + way.method + " " + std::to_string(way.word));
        if (!page.face_is_transparent.empty() && std::string_view(way.method) == "painter") continue;  // it paints glass
        VisibilityOptions options;
        options.span_lines = SpanLines{2.5, 5, 42};
        options.settings.set(way.setting, ParameterWord{way.word});
        const VisibilityResult result = find_method(way.method)->compute_visibility(page, options);
        ++(result.unsupported_reason.empty() ? right : beyond)[way.method];
        if (!result.unsupported_reason.empty()) continue;
        const PixelModel& pixels = *result.pixels;
        for (std::size_t i = 0; i < pixels.face.size(); ++i) {
          const Point2 mm = pixels.corner_mm + Point2(i % pixels.width + 0.5, i / pixels.width + 0.5) * pixels.pixel_mm;
          const DepthsAt z = depths_at(page, (mm - page.lattice.origin_mm) / page.lattice.step_mm, pixels.face[i]);
          // Where triangles of a face lie over each other, or a centre is close to a side, either may be right.
          if (z.surely != z.maybe) continue;
          ++compared;
          ASSERT_EQ(pixels.face[i] == DepthBuffer::kNothing, z.surely == HUGE_VAL) << mm.x << ", " << mm.y;
          if (z.surely == HUGE_VAL) continue;
          ASSERT_NEAR(z.of_face, z.surely, kDepthMm) << mm.x << ", " << mm.y;
          if (std::string_view(way.method) == "zbuffer") {  // those of the painter are what it sorts by
            ASSERT_NEAR(pixels.depth[i], z.surely, kDepthMm) << mm.x << ", " << mm.y;
          }
        }
      }
    }
  }
  EXPECT_GT(compared, runs_all() ? 500'000u : 150'000u);
  EXPECT_GT(right["painter"], runs_all() ? 200 : 50);
  EXPECT_GT(beyond["painter"], runs_all() ? 100 : 20);
}

void expect_same(DepthBuffer& a, DepthBuffer& b) {
  const PixelModel p = a.take_pixels(), q = b.take_pixels();
  EXPECT_EQ(p.face, q.face);
  EXPECT_EQ(p.depth, q.depth);
}

TEST(ZBuffer, ObjectsAddedLaterGiveTheSameBuffer) {
  const Scene first = random_boxes(20, 1, 10, {4, 4, 4}), second = random_boxes(15, 2, 10, {4, 4, 4});
  Scene both = first;
  append_scene(both, Scene(second));
  const View view = view_at(along({-1, 2, -1}), both, 1.5);
  for (const Filling filling : kFillings) {
    DepthBuffer at_once = painted(projected(both, view), 300, filling);
    DepthBuffer added(PixelGrid::over(view.window, 300), {});
    added.add(projected(first, view), filling);
    const PaintCounts counts = added.add(projected(second, view), filling, 20 * 6);
    EXPECT_EQ(counts.faces, filling == Filling::table ? 15u * 6 : 15u * 12);
    expect_same(added, at_once);
  }
}

TEST(ZBuffer, OneThreadAndManyPaintTheSame) {
  const Scene scene = random_boxes(300, 9, 10, {4, 4, 4});
  const ProjectedScene page = projected(scene, view_at(along({-1, 2, -1}), scene, 4));
  for (const Filling filling : kFillings) {
    std::vector<DepthBuffer> buffers;
    for (const unsigned threads : {1u, 4u})
      run_with_threads(threads, [&] { buffers.push_back(painted(page, 512, filling)); });
    expect_same(buffers[0], buffers[1]);
  }
}

/// Plates one step of depth apart are told apart, plates half a step apart are not: of those the first stays.
TEST(ZBuffer, WholeDepths) {
  for (const double distance : {1.0, 0.5}) {
    const Scene scene = scene_of_faces({{{0, 0, 0}, {80, 0, 0}, {80, 80, 0}, {0, 80, 0}},
                                        {{20, 20, distance}, {60, 20, distance}, {60, 60, distance}, {20, 60, distance}}});
    const ProjectedScene page = projected(scene, view_at(from_above(), scene));
    const double nearest = -distance / 2;  // the middle of the scene has depth 0
    EXPECT_EQ(painted(page, 100, Filling::table, {nearest - 1, 1}).face(50, 50), distance == 1 ? 1u : 0u);
    EXPECT_EQ(painted(page, 100).face(50, 50), 1u);
  }
}

/// A line that crosses a plate: hidden behind it but for a pixel at each rim.
TEST(ZBuffer, LinesEndWithinAPixelOfARim) {
  const Scene scene = scene_of_faces(
      {{{30, 0, 5}, {50, 0, 5}, {50, 80, 5}, {30, 80, 5}}, {{0, 40, 0}, {80, 40, 0}, {80, 41, 0}, {0, 41, 0}}});
  const ProjectedScene page = projected(scene, view_at(from_above(), scene));
  const DepthBuffer buffer = painted(page, 100);
  const EdgeSampling sampling(buffer, page.lattice, page.view.window);
  std::vector<LinePart> parts;
  int lines = 0;
  for (const ProjectedEdge& e : page.edges) {
    const PageLine line(page.vertices[e.v0], page.vertices[e.v1], e.face0, e.face1);
    if (std::abs(line.dx) < 10 * std::abs(line.dy) || std::abs(line.dx) * page.lattice.step_mm < 79) continue;
    ++lines;
    sampling.find(line, parts);
    ASSERT_EQ(parts.size(), 2u);
    EXPECT_EQ(parts[0].from, 0);
    EXPECT_EQ(parts[1].to, 1);
    EXPECT_NEAR(parts[0].to * 80, 30, 1);
    EXPECT_NEAR(parts[1].from * 80, 50, 1);
    EXPECT_GE(parts[0].to * 80, 30);
    EXPECT_LE(parts[1].from * 80, 50);
  }
  EXPECT_EQ(lines, 2);
}

}  // namespace
}  // namespace ligne::test
