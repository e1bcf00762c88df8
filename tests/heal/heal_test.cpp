/// Changes that healing makes to a scene, and things that it leaves alone.

#include "scene/heal/heal.hpp"
#include "base/no_index.hpp"
#include "base/parallel.hpp"
#include "scene/clean/clean.hpp"
#include "scene/contacts/chord_errors.hpp"
#include "scene/heal/border_edges.hpp"
#include "scene/heal/edge_tree.hpp"
#include "scene/readers/reader.hpp"
#include "support/mesh_text.hpp"
#include "support/scene_parts.hpp"
#include "support/test.hpp"

namespace ligne {
namespace {

namespace fs = std::filesystem;

const fs::path kCorpus = fs::path(LIGNE_SOURCE_DIR) / "tests/corpus";

Scene read(const fs::path& file) {
  Warnings warnings;
  return read_scene(file, {}, warnings);
}

Scene corpus(const std::string& name) { return read(kCorpus / (name + ".json")); }

struct Healed {
  Scene scene;
  HealReport report;
  Topology topology;
};

Healed healed(Scene scene, HealOptions options = {}) {
  Topology topology = build_topology(scene);
  HealReport report = heal(scene, topology, options);
  return {std::move(scene), std::move(report), std::move(topology)};
}

std::size_t border_edges(const Topology& topology) {
  return static_cast<std::size_t>(
      std::count_if(topology.edges.begin(), topology.edges.end(), [](const Edge& e) { return e.face1 == kNone; }));
}

/// Triangles of a grid of n x n squares with a little relief, as one object.
Scene relief(int n) {
  const std::string count = std::to_string(n);
  return test::mesh_of("grid " + count + " x " + count + " triangles: u; v; 0.25*mod(7*u+3*v,5)").scene();
}

TEST(Heal, KnowsTheEndsOfBordersWithoutATopology) {
  const Scene sheet = relief(5);
  const std::vector<std::uint8_t> marked = ends_of_odd_edges(sheet);
  for (std::uint32_t v = 0; v < marked.size(); ++v) {
    const Point3 p = sheet.vertices[v];
    EXPECT_EQ(marked[v] != 0, p.x == 0 || p.x == 5 || p.y == 0 || p.y == 5) << v;
  }
  Scene box;
  test::add_box(box, {0, 0, 0}, {1, 2, 3});
  EXPECT_EQ(ends_of_odd_edges(box), std::vector<std::uint8_t>(8, 0)) << "closed";
  // As many faces as threads share, and the same marks.
  const Scene large = relief(400);
  std::vector<std::uint8_t> alone, together;
  run_with_threads(1, [&] { alone = ends_of_odd_edges(large); });
  run_with_threads(3, [&] { together = ends_of_odd_edges(large); });
  EXPECT_EQ(alone, together);
  EXPECT_EQ(std::count(alone.begin(), alone.end(), 1), 4 * 400);
}

TEST(Heal, OfTheCorpusOnlyTheDefectsAreChanged) {
  const std::set<std::string> defects{"cube_stored_twice", "cube_with_crack", "cube_with_loose_lid", "duplicate_faces",
                                      "duplicate_objects", "mixed_winding",   "t_junction",          "zero_area_faces"};
  std::set<std::string> changed;
  for (const auto& entry : fs::directory_iterator(kCorpus)) {
    if (entry.path().extension() != ".json") continue;
    const Scene before = read(entry.path());
    const Healed after = healed(before);
    if (!after.report.nothing()) {
      changed.insert(entry.path().stem().string());
      continue;
    }
    EXPECT_EQ(before.vertices, after.scene.vertices) << entry.path();
    EXPECT_TRUE(std::ranges::equal(before.faces.corners(), after.scene.faces.corners())) << entry.path();
  }
  EXPECT_EQ(changed, defects);
}

TEST(Heal, FacesStoredTwiceWhereManyOthersHaveTheirLowestVertex) {
  constexpr std::uint32_t n = 40;
  Scene scene;
  test::begin_object(scene);
  scene.vertices.emplace_back(0, 0, 0);
  // One side of each petal is among the first edges of vertex 0, the other among the last.
  for (const double turn : {0.0, 0.5})
    for (std::uint32_t i = 0; i < n; ++i) {
      const double angle = 2 * std::numbers::pi * (i + turn) / n;
      scene.vertices.emplace_back(std::cos(angle), std::sin(angle), 0);
    }
  for (std::uint32_t i = 0; i < n; ++i) scene.faces.add_triangle(0, 1 + i, 1 + n + i);
  scene.faces.add_triangle(0, n, 2 * n);
  test::end_object(scene);
  const Healed after = healed(std::move(scene));
  EXPECT_EQ(after.report.faces_twice, 1u);
  EXPECT_EQ(after.scene.faces.size(), n);
}

TEST(Heal, ThreeThousandEqualCubesAreOne) {
  Scene as_objects, as_one;
  for (int i = 0; i < 3000; ++i) test::add_box(as_objects, {0, 0, 0}, {1, 2, 3});
  as_one = as_objects;
  Object whole = as_one.objects[0];
  whole.vertex_end = as_one.objects.back().vertex_end, whole.face_end = as_one.objects.back().face_end;
  as_one.objects = {whole};
  test::finish(as_one);
  const Healed of_objects = healed(as_objects), of_one = healed(as_one);
  EXPECT_EQ(of_objects.report.objects_twice, 2999u);
  EXPECT_EQ(of_objects.scene.faces.size(), 6u);
  EXPECT_EQ(of_one.report.faces_twice, 2999u * 6);
  EXPECT_EQ(of_one.scene.faces.size(), 6u);
}

TEST(Heal, ACrackIsSewnAtItsTJunction) {
  const Scene before = corpus("cube_with_crack");
  const Healed after = healed(before);
  // The vertex of the front moves onto the lid's edge, since that leaves both faces flat.
  ASSERT_EQ(after.scene.vertices.size(), before.vertices.size());
  for (std::size_t v = 0; v < before.vertices.size(); ++v)
    EXPECT_EQ(after.scene.vertices[v], before.vertices[v].z == 4 - 0x1p-13 ? Point3(2, 0, 4) : before.vertices[v]);
  EXPECT_EQ(after.scene.faces.size(), 6u);
  EXPECT_EQ(border_edges(after.topology), 0u);
  EXPECT_EQ(after.report.edges_split, 1u);
  ASSERT_EQ(after.report.sewn.size(), 1u);
  EXPECT_DOUBLE_EQ(after.report.sewn[0].distance, 0x1p-13);
}

TEST(Heal, NothingMovesFurtherThanTheDistance) {
  const Scene before = corpus("cube_with_loose_lid");
  const Healed after = healed(before);
  EXPECT_EQ(border_edges(after.topology), 0u);
  EXPECT_EQ(after.scene.vertices.size(), 8u);
  EXPECT_EQ(after.report.vertices_moved, 4u);
  for (const Point3& p : after.scene.vertices)
    EXPECT_NE(std::find(before.vertices.begin(), before.vertices.end(), p), before.vertices.end());
}

TEST(Heal, ASecondTimeChangesNothing) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(kCorpus))
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  for (const char* model :
       {"chair_model.obj", "2CylinderEngine.glb", "spider.obj", "octagonal_pocket.ply", "featuretype.stl"}) {
    if (fs::exists(fs::path(LIGNE_MODELS_DIR) / model)) files.push_back(fs::path(LIGNE_MODELS_DIR) / model);
  }
  for (const fs::path& file : files) {
    const Healed once = healed(read(file));
    const Healed twice = healed(once.scene);
    EXPECT_EQ(twice.report.faces_twice + twice.report.edges_sewn(), 0u) << file;
  }
}

// Its topology: HealLargeMesh.
TEST(Heal, TheSceneStaysFinished) {
  for (const char* name : {"cube_stored_twice", "cube_with_crack", "cube_with_loose_lid", "t_junction"}) {
    const Healed after = healed(corpus(name));
    Scene again = after.scene;
    Warnings warnings;
    finish_scene(again, warnings);
    EXPECT_TRUE(warnings.counts().empty()) << name;
    EXPECT_EQ(again.vertices.size(), after.scene.vertices.size()) << name;
  }
}

TEST(Heal, SameSceneForAnyNumberOfThreads) {
  const fs::path engine = fs::path(LIGNE_MODELS_DIR) / "2CylinderEngine.glb";
  if (!fs::exists(engine)) GTEST_SKIP() << "shared models are absent";
  std::array<Scene, 2> scenes;
  for (const unsigned threads : {1u, 8u})
    run_with_threads(threads, [&] { scenes[threads > 1] = healed(read(engine)).scene; });
  EXPECT_EQ(scenes[0].vertices, scenes[1].vertices);
  EXPECT_TRUE(std::ranges::equal(std::as_const(scenes[0]).faces.corners(), std::as_const(scenes[1]).faces.corners()));
  EXPECT_EQ(scenes[0].corner_flags, scenes[1].corner_flags);
}

TEST(Heal, CrowdsTakeNoTimeWithoutBound) {
  // A fan of 20,000 open triangles around one point, all within the distance, and a mesh stored twice.
  Scene scene;
  test::begin_object(scene);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> at(0, 1);
  for (std::uint32_t i = 0; i < 20'000; ++i) {
    for (int k = 0; k < 3; ++k) scene.vertices.emplace_back(at(random), at(random), at(random));
    scene.faces.add_triangle(3 * i, 3 * i + 1, 3 * i + 2);
  }
  test::end_object(scene);
  const Healed crowd = healed(scene, {2.0});
  EXPECT_LE(crowd.scene.vertices.size(), scene.vertices.size());
  Scene grid = relief(200);
  const std::size_t faces = grid.faces.size();
  for (std::uint32_t f = 0; f < faces; ++f) {
    const auto corners = std::as_const(grid.faces).contour(f, 0);
    grid.faces.add_triangle(corners[1], corners[0], corners[2]);
  }
  grid.objects[0].face_end = static_cast<std::uint32_t>(grid.faces.size());
  EXPECT_EQ(healed(grid).report.faces_twice, faces);
}

// Surfaces that touch: what tells contacts from intersections. The drawings: cli/scripts/contacts.txt.

TEST(Contacts, ChordErrorIsTheHeightOfTheArc) {
  for (const std::uint32_t n : {12u, 24u, 48u, 96u}) {
    const std::string angle = "0.1+2*pi*u/" + std::to_string(n);
    const Scene scene =
        test::mesh_of("grid " + std::to_string(n) + " x 1 round: 10*cos(" + angle + "); 10*sin(" + angle + "); 30*v\nexact")
            .scene();
    const FaceNeighbours neighbours(scene, {0, 3});
    const ChordErrors errors(scene, neighbours, {0, 3}, 40);
    const double height = 10 * (1 - std::cos(std::numbers::pi / n));
    EXPECT_NEAR(errors.of(0), height, 1e-6 * height);
    EXPECT_NEAR(errors.of(3), height, 1e-6 * height);
    EXPECT_NEAR(errors.bend(3), 2 * std::numbers::pi / n, 1e-9);
    EXPECT_EQ(ChordErrors(scene, neighbours, {0}, 360.0 / n - 1).of(0), 0) << "creases are no part of a smooth surface";
  }
}

/// A square post with narrow roundings. What is drawn of it: cli/scripts/contacts.txt.
TEST(Contacts, FlatSidesBesideNarrowRoundingsAreNoChords) {
  const Scene scene = test::mesh_of(
                          "grid 20 x 1 round: "
                          "sqrt(2)*4.7*cos(pi/2*(floor(u/5)+0.5))+0.3*cos(pi/2*(floor(u/5)+mod(u,5)/4));"
                          "sqrt(2)*4.7*sin(pi/2*(floor(u/5)+0.5))+0.3*sin(pi/2*(floor(u/5)+mod(u,5)/4)); 30*v\nexact")
                          .scene();
  const FaceNeighbours neighbours(scene, {0, 4});
  const ChordErrors errors(scene, neighbours, {0, 4}, 40);
  EXPECT_GT(errors.of(4), 0);
  EXPECT_LE(errors.of(4), errors.of(0)) << "the side lies no farther off than the rounding";
}

/// The tree of segments against all segments one by one, and cells of segments against the tree.

std::vector<EdgeTree::Segment> random_segments(std::mt19937& random, std::size_t n) {
  std::uniform_real_distribution<double> place(-1, 1);
  const auto point = [&] { return Point3{place(random), place(random), place(random)}; };
  std::vector<EdgeTree::Segment> segments;
  for (std::size_t i = 0; i < n; ++i) {
    const Point3 a = point();
    segments.push_back({a, a + 0.1 * point()});
  }
  return segments;
}

TEST(EdgeTree, OfARangeTheNearestIsFoundByTheTreeToo) {
  std::mt19937 random(1);
  const std::vector<EdgeTree::Segment> segments = random_segments(random, 300);
  const EdgeTree tree(segments);
  std::vector<std::uint32_t> range(40);
  std::iota(range.begin(), range.end(), 20u);
  std::size_t found = 0;
  for (const EdgeTree::Segment& p : random_segments(random, 500)) {
    for (const double distance : {0.05, 0.3, 10.0}) {
      const NearestPoint one_by_one =
          nearest_among(segments, range, p.a, distance, [](std::uint32_t, double) { return true; });
      const NearestPoint by_tree = tree.nearest(p.a, distance, [](std::uint32_t s, double) { return s >= 20 && s < 60; });
      EXPECT_TRUE(one_by_one.segment != kNone || distance < 1);
      // The tree looks at a limited number of segments, so it may find less, and never more.
      if (by_tree.segment == kNone) continue;
      ++found;
      EXPECT_LE(one_by_one.distance, by_tree.distance);
      EXPECT_TRUE(one_by_one.segment != by_tree.segment || one_by_one.at == by_tree.at);
    }
  }
  EXPECT_GT(found, 300u);
}

TEST(SegmentCells, AmongTheSegmentsOfACellTheNearestIsThatOfTheTree) {
  std::mt19937 random(3);
  std::vector<EdgeTree::Segment> segments = random_segments(random, 3000);
  segments.push_back({{-1, -1, -1}, {1, 1, 1}});  // far longer than a cell
  segments.push_back({{1, -1, 0.5}, {1, 1, 0.5}});
  const EdgeTree tree(segments);
  for (const double reach : {0.0, 0.02, 0.04}) {
    const SegmentCells cells(segments, reach);
    std::size_t found = 0, listed = 0;
    for (std::uint32_t own = 0; own < segments.size(); ++own) {
      const auto other = [&](std::uint32_t s, double) { return s != own; };
      for (const Point3& p : {segments[own].a, 0.5 * (segments[own].a + segments[own].b)}) {
        const NearestPoint here = nearest_among(segments, cells.near(p), p, reach, other);
        const NearestPoint anywhere = tree.nearest(p, reach, other);
        EXPECT_EQ(here.segment, anywhere.segment);
        EXPECT_EQ(here.distance, anywhere.distance);
        found += here.segment != kNone;
        listed += cells.near(p).size();
      }
    }
    EXPECT_EQ(found > 300u, reach > 0);
    EXPECT_LT(listed, segments.size() * 100);
  }
}

TEST(SegmentCells, HoldWhatHasNoExtent) {
  const std::vector<EdgeTree::Segment> segments(3, {{5, 5, 5}, {5, 5, 5}});
  const SegmentCells cells(segments, 0);
  EXPECT_EQ(cells.near({5, 5, 5}).size(), 3u);
}

TEST(EdgeTree, TheDistanceItselfIsNearEnough) {
  std::mt19937 random(2);
  const std::vector<EdgeTree::Segment> segments = random_segments(random, 40);
  const EdgeTree tree(segments);
  const auto any = [](std::uint32_t, double) { return true; };
  for (const EdgeTree::Segment& p : random_segments(random, 1000)) {
    const NearestPoint found = tree.nearest(p.a, 10, any);
    EXPECT_EQ(tree.nearest(p.a, found.distance, any).segment, found.segment);
    EXPECT_EQ(tree.nearest(p.a, std::nextafter(found.distance, 0), any).segment, kNone);
  }
}

}  // namespace
}  // namespace ligne
