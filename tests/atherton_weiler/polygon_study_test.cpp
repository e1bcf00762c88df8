// The classical study by its own figures: zones, slabs, wrong sorts and bodies of scenes that were made to show them, levels
// behind transparent faces; and crowds of boxes by both studies.

#include "drawing/measures.hpp"
#include "main/tier.hpp"
#include "scene/clean/clean.hpp"
#include "scene/readers/reader.hpp"
#include "support/scenes.hpp"
#include "visibility/atherton_weiler/atherton_weiler.hpp"
#include "visibility/edges/appel.hpp"

namespace ligne::test {
namespace {

constexpr unsigned kFaces = 0, kPolygons = 1, kSilhouettes = 2;

/// A setting of the study of polygons.
struct Setting {
  const char* name;
  unsigned word;
};
constexpr Setting kGeneralClip{"clip", 0}, kConvexClip{"clip", 1}, kOctagons{"zones", 1}, kHulls{"zones", 2},
    kContours{"zones", 3}, kAtOnce{"inside", 1};

VisibilityResult compute_visibility(const Scene& scene, const char* from, unsigned how, std::vector<Setting> more = {}) {
  CameraRequest request;
  request.named_view = from;
  const View view = make_view(scene, make_camera(request, scene), {{{0, 0}, {200, 200}}}, {{0, 0}, {200, 200}});
  VisibilityOptions options;
  options.settings.set("study", ParameterWord{how});
  for (const Setting& setting : more) options.settings.set(setting.name, ParameterWord{setting.word});
  return AthertonWeilerMethod().compute_visibility(project(scene, build_topology(scene), view, {}), options);
}

VisibilityResult compute_visibility(const std::string& file, const char* from, unsigned how,
                                    std::vector<Setting> more = {}) {
  Warnings warnings;
  return compute_visibility(read_scene(std::filesystem::path(LIGNE_SOURCE_DIR) / "tests" / file, {}, warnings), from, how,
                            std::move(more));
}

/// Every setting by itself, and all together.
const std::vector<std::vector<Setting>> kEverySetting = {{},
                                                         {kGeneralClip},
                                                         {kOctagons},
                                                         {kHulls},
                                                         {kContours},
                                                         {kAtOnce},
                                                         {kGeneralClip, kContours, kAtOnce},
                                                         {kHulls, kAtOnce}};

/// Areas in mm^2 by face and level.
std::map<std::pair<std::uint32_t, std::uint32_t>, double> areas(const VisibilityResult& result) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, double> sums;
  for (const Region& r : *result.regions) sums[{r.face, r.level}] += area_of(r);
  return sums;
}

constexpr double kArea = 1e-9 * 200 * 200;  ///< part of the page, for sums of areas in mm^2

std::uint64_t count(const VisibilityResult& result, std::string_view name) {
  for (const auto& [known, number] : result.statistics.counts)
    if (known == name) return number;
  ADD_FAILURE() << "there is no count of " << name;
  return 0;
}

std::uint64_t count(const std::string& scene, const char* from, unsigned how, std::string_view name,
                    std::vector<Setting> more = {}) {
  return count(compute_visibility("corpus/" + scene + ".json", from, how, std::move(more)), name);
}

TEST(PolygonStudy, Zones) {
  EXPECT_EQ(count("thesis_2_63", "front", kPolygons, "zones"), 3u);
  EXPECT_EQ(count("thesis_2_64", "front", kPolygons, "zones"), 1u);
}

TEST(PolygonStudy, KnownCounts) {
  const struct {
    const char *name, *scene, *from, *count;
    std::uint64_t number;
  } rows[] = {
      {"slabs", "thesis_2_64", "front", "slabs", 3},
      {"flat faces parallel to the page: slab 1 of the figure falls into two", "thesis_2_66", "front", "slabs", 3},
      {"the screen face clips the four others", "thesis_2_66", "front", "clips", 4},
      {"nothing is left to be compared", "thesis_2_66", "front", "regions", 1},
      {"a wrong sort is found", "thesis_2_68", "front", "wrong sorts", 2},
      {"and undone", "thesis_2_68", "front", "deepest recursion", 2},
      {"a right sort", "stack_of_plates", "top", "wrong sorts", 0},
      {"penetration is cut along the common line", "two_plates_penetrating", "iso", "cuts along common lines", 1},
      {"nothing penetrates", "stack_of_plates", "iso", "cuts along common lines", 0},
  };
  for (const auto& row : rows)
    EXPECT_EQ(count(row.scene, row.from, kPolygons, row.count), row.number) << row.name << ": " << row.scene;
}

TEST(PolygonStudy, CyclicOverlapIsUndone) {
  for (const char* scene : {"cyclic_3", "cyclic_4", "cyclic_5", "cyclic_6"}) {
    EXPECT_GT(count(scene, "front", kPolygons, "wrong sorts"), 0u) << scene;
    EXPECT_EQ(count(scene, "front", kPolygons, "regions"), count(scene, "front", kFaces, "regions")) << scene;
  }
}

TEST(PolygonStudy, ConvexBodiesAreTakenTogether) {
  EXPECT_EQ(count("grid_3", "iso", kSilhouettes, "convex objects"), 27u);
  EXPECT_EQ(count("grid_3", "iso", kPolygons, "convex objects"), 0u);
  EXPECT_EQ(count("octahedron", "iso", kSilhouettes, "convex objects"), 1u);
  EXPECT_EQ(count("inside_out_cube", "iso", kSilhouettes, "convex objects"), 1u) << "winding does not matter";
  EXPECT_EQ(count("l_block", "iso", kSilhouettes, "convex objects"), 0u) << "not convex";
  EXPECT_EQ(count("open_box", "iso", kSilhouettes, "convex objects"), 0u) << "not closed";
  EXPECT_EQ(count("cube", "front", kSilhouettes, "convex objects"), 0u) << "one face alone is no body";
  EXPECT_LT(count("grid_3", "iso", kSilhouettes, "clips"), count("grid_3", "iso", kPolygons, "clips") / 4);
}

/// Faces in the plane y = depth, over x and z.
void add_flat(Scene& scene, double depth, const std::vector<std::array<double, 2>>& corners) {
  std::vector<Point3> points;
  for (const auto& [x, z] : corners) points.push_back({x, depth, z});
  test::add_face(scene, {points});
}

/// Pairs of a face and a copy behind it, at places apart: three bars that lean, three angles, each in the notch of the one
/// before, and three frames, each in the hole of the one before.
Scene leaning_bars() {
  Scene scene;
  for (const double x : {0.0, 3.0, 6.0})
    for (const double y : {0.0, 1.0}) add_flat(scene, y, {{x, y / 2}, {x + 1, y / 2}, {x + 10, 9}, {x + 9, 9}});
  return scene;
}
Scene nested_angles() {
  Scene scene;
  for (const double a : {0.0, 3.0, 6.0})
    for (const double y : {0.0, 1.0}) {
      const double b = a + y / 2;
      add_flat(scene, y, {{b, b}, {9, b}, {9, b + 1}, {b + 1, b + 1}, {b + 1, 9}, {b, 9}});
    }
  return scene;
}
Scene nested_frames() {
  Scene scene;
  const auto square = [](double y, double low, double high) {
    return std::vector<Point3>{{low, y, low}, {high, y, low}, {high, y, high}, {low, y, high}};
  };
  for (const double a : {0.0, 3.0, 6.0})
    for (const double y : {0.0, 1.0}) {
      const double b = a + y / 2;
      test::add_face(scene, {square(y, b, 20 - b), square(y, b + 1, 19 - b)});
    }
  return scene;
}

/// [Boulle1980] 2.4.3.2: the costlier the test the more zones; each zone is a pair of faces and takes one clip.
TEST(PolygonStudy, CostlierTestsFindMoreZones) {
  const struct {
    const char* name;
    Scene scene;
    std::array<std::uint64_t, 4> zones;  ///< by boxes, octagons, hulls, contours
  } rows[] = {{"bars that lean", leaning_bars(), {1, 3, 3, 3}},
              {"angles in each other", nested_angles(), {1, 1, 1, 3}},
              {"frames in each other", nested_frames(), {1, 1, 1, 3}}};
  for (const auto& row : rows) {
    Scene scene = row.scene;
    Warnings warnings;
    finish_scene(scene, warnings);
    const auto wanted = areas(compute_visibility(scene, "front", kFaces));
    for (unsigned test = 0; test < 4; ++test) {
      SCOPED_TRACE(std::string(row.name) + ", test " + std::to_string(test));
      const VisibilityResult found = compute_visibility(scene, "front", kPolygons, {{"zones", test}});
      EXPECT_EQ(count(found, "zones"), row.zones[test]);
      if (row.zones[test] == 3) {
        EXPECT_EQ(count(found, "clips"), 3u);
      }
      for (const auto& [key, area] : areas(found)) EXPECT_NEAR(area, wanted.at(key), kArea);
    }
  }
}

/// Many faces at one place are one zone after as many tests as joins; many faces apart need none.
TEST(PolygonStudy, ZonesOfCrowdsTakeFewTests) {
  constexpr int kMany = 500;
  Scene stacked, apart;
  for (int i = 0; i < kMany; ++i) {
    add_flat(stacked, i, {{0, 0}, {5, 0}, {2, 4}});
    const double x = i % 25, z = i / 25;
    add_flat(apart, i, {{x, z}, {x + 1, z}, {x, z + 1}});
  }
  Warnings warnings;
  finish_scene(stacked, warnings);
  finish_scene(apart, warnings);
  for (const Setting& test : {kOctagons, kHulls, kContours}) {
    SCOPED_TRACE(test.word);
    const VisibilityResult one = compute_visibility(stacked, "front", kPolygons, {test});
    EXPECT_EQ(count(one, "zones"), 1u);
    EXPECT_EQ(count(one, "tests for zones"), std::uint64_t{kMany - 1});
    const VisibilityResult many = compute_visibility(apart, "front", kPolygons, {test});
    EXPECT_EQ(count(many, "zones"), std::uint64_t{kMany});
    EXPECT_EQ(count(many, "tests for zones"), 0u);
  }
}

/// Compares strokes and regions to the last bit.
void expect_identical(const VisibilityResult& a, const VisibilityResult& b) {
  ASSERT_EQ(a.strokes->strokes.size(), b.strokes->strokes.size());
  for (std::size_t i = 0; i < a.strokes->strokes.size(); ++i) {
    const Stroke &s = a.strokes->strokes[i], &t = b.strokes->strokes[i];
    EXPECT_TRUE(s.from == t.from && s.to == t.to && s.source == t.source && s.level == t.level) << "stroke " << i;
  }
  ASSERT_EQ(a.regions->size(), b.regions->size());
  for (std::size_t i = 0; i < a.regions->size(); ++i)
    EXPECT_EQ((*a.regions)[i].contours, (*b.regions)[i].contours) << "region " << i;
}

/// [Boulle1980] 3.2.3.4, figure 3.31: the clip of convex contours makes the same clips of the same polygons.
TEST(PolygonStudy, TheConvexClipIsTheGeneralOne) {
  for (const char* scene : {"thesis_3_31", "thesis_3_31_corner", "thesis_3_33b", "bricks", "lattice_of_bars", "grid_3",
                            "three_prisms_penetrating", "cross_of_plates", "cyclic_5", "duplicate_faces"}) {
    for (const unsigned how : {kPolygons, kSilhouettes}) {
      SCOPED_TRACE(std::string(scene) + (how == kPolygons ? " polygons" : " silhouettes"));
      const std::string file = std::string("corpus/") + scene + ".json";
      const VisibilityResult general = compute_visibility(file, "iso", how, {kGeneralClip}),
                             convex = compute_visibility(file, "iso", how, {kConvexClip});
      for (const char* name :
           {"clips", "wrong sorts", "cuts along common lines", "deepest recursion", "clips with nothing inside", "regions"})
        EXPECT_EQ(count(general, name), count(convex, name)) << name;
      EXPECT_EQ(count(general, "convex contours clipped"), 0u);
      EXPECT_LE(count(convex, "signs of corners in clips"), count(general, "signs of corners in clips"));
      expect_identical(general, convex);
      expect_identical(convex, compute_visibility(file, "iso", how));
    }
  }
  EXPECT_EQ(count("grid_3", "top", kPolygons, "general clips", {kConvexClip}), 0u) << "squares hide squares";
}

/// [Boulle1980] 2.4.2.4: a nearer face takes the place of the clip face at once.
TEST(PolygonStudy, NearerFacesTakeTheirPlaceAtOnce) {
  EXPECT_EQ(count("thesis_2_68", "front", kPolygons, "deepest recursion", {kAtOnce}), 1u);
  EXPECT_GT(count("thesis_2_68", "front", kPolygons, "clip faces given up at once", {kAtOnce}), 0u);
  EXPECT_EQ(count("stack_of_plates", "top", kPolygons, "clip faces given up at once", {kAtOnce}), 0u) << "a right sort";
  for (const char* scene : {"cyclic_3", "cyclic_4", "cyclic_5", "cyclic_6"})
    EXPECT_EQ(count(scene, "front", kPolygons, "regions", {kAtOnce}), count(scene, "front", kFaces, "regions")) << scene;
}

TEST(PolygonStudy, LevelsBehindGlassAreTheSame) {
  for (const auto& [name, count] :
       {std::pair("transparent_three", std::size_t{1 + 2 + 3 + 4}), std::pair("glass_triangle", std::size_t{1 + 1 + 16})}) {
    SCOPED_TRACE(name);
    const std::string file = std::string("atherton_weiler/scenes/") + name + ".json";
    const auto wanted = areas(compute_visibility(file, "front", kFaces));
    EXPECT_EQ(wanted.size(), count);
    for (const unsigned how : {kPolygons, kSilhouettes}) {
      for (const std::vector<Setting>& settings : kEverySetting) {
        const auto found = areas(compute_visibility(file, "front", how, settings));
        ASSERT_EQ(found.size(), wanted.size());
        for (const auto& [key, area] : wanted)
          EXPECT_NEAR(found.at(key), area, kArea) << key.first << ", level " << key.second;
      }
    }
  }
}

TEST(PolygonStudy, AHoleIsInTheRegionRightRoundIt) {
  // A wall of 20 x 20, before it a frame of 12 x 12 round 8 x 8, and in the middle of that a plate of 2 x 2.
  const auto square = [](double low, double high, double y) {
    return std::vector<Point3>{{low, y, low}, {high, y, low}, {high, y, high}, {low, y, high}};
  };
  Scene scene;
  test::add_face(scene, {square(0, 20, 6)});
  test::add_face(scene, {square(4, 16, 3), square(6, 14, 3)});
  test::add_face(scene, {square(9, 11, 3)});
  Warnings warnings;
  finish_scene(scene, warnings);
  for (const unsigned how : {kFaces, kPolygons, kSilhouettes}) {
    std::vector<double> of_wall;
    double all = 0;
    const VisibilityResult result = compute_visibility(scene, "front", how);
    for (const Region& r : *result.regions) {
      all += area_of(r);
      if (r.face == 0) of_wall.push_back(area_of(r));
    }
    std::sort(of_wall.begin(), of_wall.end());
    ASSERT_EQ(of_wall.size(), 2u);
    EXPECT_NEAR(of_wall[0] / all, (64 - 4) / 400.0, 1e-9);
    EXPECT_NEAR(of_wall[1] / all, (400 - 144) / 400.0, 1e-9);
  }
}

/// Turned boxes, each in a cell of its own, every fourth transparent: over a face lie more sides than are laid over it at a
/// time.
TEST(PolygonStudy, CrowdsAreTheSame) {
  for (unsigned seed = 0; seed < 3; ++seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> side(2, 5), angle(-3, 3);
    Scene scene;
    scene.materials.resize(2);
    scene.materials[1].opacity = 0.5;
    for (int i = 0; i < 64; ++i) {
      // No side is longer than 5, so that a box turned about its centre stays in a cell of 9.
      const test::Basis basis = test::rotation(angle(random), angle(random), angle(random));
      const Point3 centre{9.0 * (i % 4), 9.0 * (i / 4 % 4), 9.0 * (i / 16)}, size{side(random), side(random), side(random)};
      const auto along = [&](const Point3& axis) { return axis.x * centre.x + axis.y * centre.y + axis.z * centre.z; };
      test::add_box(scene, Point3{along(basis[0]), along(basis[1]), along(basis[2])} - size * 0.5, size, basis);
      scene.face_material.resize(scene.faces.size(), i % 4 == 3 ? 1 : 0);
    }
    Warnings warnings;
    finish_scene(scene, warnings);
    const auto wanted = areas(compute_visibility(scene, "iso", kFaces));
    EXPECT_GT(wanted.size(), 150u);
    for (std::size_t i = 0; i < kEverySetting.size(); ++i) {
      auto found = areas(compute_visibility(scene, "iso", kPolygons, kEverySetting[i]));
      for (const auto& [key, area] : wanted) found[key] -= area;
      for (const auto& [key, area] : found)
        EXPECT_NEAR(area, 0, kArea) << "seed " << seed << ", settings " << i << ", face " << key.first << ", level "
                                    << key.second;
    }
  }
}

// Lines behind transparent faces against another method on other scenes: what is seen at all is what is seen when the
// transparent faces are taken away, and what is seen directly is what is seen when they are opaque.

/// An end of a visible part is right to a micrometre, across an edge that it passes at a small angle to several.
constexpr double kEdgeMm = 0.02;

Scene boxes_of_glass(unsigned seed) {
  Scene scene;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> u(-1, 1);
  for (int i = 0; i < 40; ++i) {
    // One after the other: the order in which arguments are evaluated is the compiler's.
    const Point3 middle = Point3{u(random), u(random), u(random)} * 4.0,
                 turns = Point3{u(random), u(random), u(random)} * 3.0;
    add_box(scene, middle, {2, 1.5, 1}, rotation(turns.x, turns.y, turns.z));
  }
  scene.materials = {{"plain", {0.8, 0.8, 0.8}, 1}, {"glass", {0.5, 0.7, 0.9}, 0.4}};
  scene.face_material.resize(scene.faces.size());
  for (std::uint32_t& m : scene.face_material) m = u(random) < 0;
  return scene;
}

ProjectedScene projected(const Scene& scene, const CameraRequest& camera) {
  const Rect page{{0, 0}, {kPageWidth, kPageHeight}};
  const View view = make_view(scene, make_camera(camera, scene), {{{10, 10}, {kPageWidth - 10, kPageHeight - 10}}}, page);
  LineClasses edges;
  for (const LineClass c : {LineClass::outline, LineClass::border, LineClass::crease, LineClass::mesh}) edges.add(c);
  return project(scene, build_topology(scene), view, {edges, 30});
}

/// Drawn length by edge, of the strokes of these levels.
std::vector<double> lengths(const StrokeModel& model, unsigned least_level, unsigned most_level) {
  std::vector<double> sums(model.edge_count, 0);
  for (const Stroke& s : model.strokes)
    if (s.visible && s.level >= least_level && s.level <= most_level)
      sums[s.source] += glm::distance(model.lattice.to_mm(s.from), model.lattice.to_mm(s.to));
  return sums;
}

double sum(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

void expect_equal(const std::vector<double>& found, const std::vector<double>& wanted) {
  ASSERT_EQ(found.size(), wanted.size());
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], wanted[i], kEdgeMm) << "edge " << i;
}

/// Warnock's method takes glass away before its study: [Boulle1980] 2.2.2.6.
TEST(TransparentFaces, AreLeftOutByWarnock) {
  const Scene scene = boxes_of_glass(3);
  const ProjectedScene with_glass = projected(scene, along({-1, 2, -1}));
  ProjectedScene without = with_glass;
  std::erase_if(without.triangles, [&](const Triangle& t) { return with_glass.face_is_transparent[t.face] != 0; });
  without.face_is_transparent.clear();
  const auto glass = [&](std::uint32_t face) { return face == kNone || with_glass.face_is_transparent[face]; };
  std::erase_if(without.edges, [&](const ProjectedEdge& e) { return glass(e.face0) && glass(e.face1); });
  const VisibilityResult found = find_method("warnock")->compute_visibility(with_glass, {});
  expect_equal(lengths(*found.strokes, 0, 255), lengths(*AppelMethod().compute_visibility(without, {}).strokes, 0, 255));
  const auto faces = std::ranges::count(with_glass.face_is_transparent, std::uint8_t{1});
  EXPECT_EQ(found.left_out, std::to_string(faces) + " transparent faces");
  for (const Region& r : *found.regions) EXPECT_FALSE(with_glass.face_is_transparent[r.face]);
  EXPECT_EQ(find_method("warnock")->compute_visibility(without, {}).left_out, "");
}

/// In the middle of every longer stroke: as many transparent triangles are in front of it as its level says, and no opaque
/// one.
void expect_levels(const StrokeModel& model, const ProjectedScene& scene) {
  for (const Stroke& s : model.strokes) {
    const Point2 from(s.from.x, s.from.y), to(s.to.x, s.to.y), p = (from + to) * 0.5;
    if (glm::distance(from, to) * model.lattice.step_mm < 1) continue;
    const auto edge =
        std::find_if(scene.edges.begin(), scene.edges.end(), [&](const ProjectedEdge& e) { return e.source == s.source; });
    unsigned transparent = 0, opaque = 0;
    for (const Triangle& t : scene.triangles) {
      if (t.face == edge->face0 || t.face == edge->face1) continue;
      double weight[3], area = 0, z = 0;
      for (int k = 0; k < 3; ++k) {
        const LatticePoint a = scene.vertices[t.v[(k + 1) % 3]].p, b = scene.vertices[t.v[(k + 2) % 3]].p;
        weight[k] = (double(b.x) - a.x) * (p.y - a.y) - (double(b.y) - a.y) * (p.x - a.x);
        area += weight[k];
      }
      for (int k = 0; k < 3; ++k) z += weight[k] / area * scene.vertices[t.v[k]].z;
      const bool inside = std::all_of(weight, weight + 3, [&](double w) { return w / area > 0; });
      if (inside && z < (double(s.z_from) + s.z_to) / 2) ++(scene.face_is_transparent[t.face] ? transparent : opaque);
    }
    EXPECT_EQ(s.level, transparent) << "edge " << s.source;
    EXPECT_EQ(opaque, 0u) << "edge " << s.source;
  }
}

TEST(TransparentLines, AreThoseWithoutTheGlassAndThoseInFrontOfIt) {
  for (const unsigned seed : chosen("lines through glass", 3, {1u, 2u, 3u, 4u, 5u, 6u})) {
    SCOPED_TRACE(seed);
    const Scene scene = boxes_of_glass(seed);
    for (const CameraRequest& camera : {along({-1, 2, -1}), from_eye({9, -11, 7}, {0, 0, 0})}) {
      const ProjectedScene with_glass = projected(scene, camera);
      ProjectedScene opaque = with_glass, without = with_glass;
      opaque.face_is_transparent.clear();
      without.face_is_transparent.clear();
      std::erase_if(without.triangles, [&](const Triangle& t) { return with_glass.face_is_transparent[t.face] != 0; });
      const StrokeModel in_front = *AppelMethod().compute_visibility(opaque, {}).strokes,
                        all = *AppelMethod().compute_visibility(without, {}).strokes;
      for (const unsigned study : {0u, 1u, 2u}) {
        SCOPED_TRACE(study);
        VisibilityOptions options;
        options.settings.set("study", ParameterWord{study});
        const StrokeModel found = *AthertonWeilerMethod().compute_visibility(with_glass, options).strokes;
        expect_equal(lengths(found, 0, 255), lengths(all, 0, 255));
        expect_equal(lengths(found, 0, 0), lengths(in_front, 0, 0));
        EXPECT_GT(sum(lengths(found, 1, 1)), 300);
        EXPECT_GT(sum(lengths(found, 2, 255)), 50);
        expect_levels(found, with_glass);
      }
      for (const char* method : {"newell", "bsp", "convex-tree"}) {
        SCOPED_TRACE(method);
        const StrokeModel found = *find_method(method)->compute_visibility(with_glass, {}).strokes;
        expect_equal(lengths(found, 0, 255), lengths(all, 0, 255));
        expect_equal(lengths(found, 0, 0), lengths(in_front, 0, 0));
        expect_levels(found, with_glass);
      }
    }
  }
}

}  // namespace
}  // namespace ligne::test
