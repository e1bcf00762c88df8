// The classical study by its own figures: zones, slabs, wrong sorts and bodies of scenes that were made to show them, levels
// behind transparent faces; and crowds of boxes by both studies.

#include "drawing/measures.hpp"
#include "main/script.hpp"
#include "scene/clean/clean.hpp"
#include "scene/readers/reader.hpp"
#include "support/scenes.hpp"
#include "visibility/methods.hpp"

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
  return atherton_weiler_method().compute_visibility(project(scene, build_topology(scene), view, {}), options);
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

/// "SCENE VIEW COUNT", also "SCENE VIEW SETTING=WORD COUNT": a count of the study of polygons, or of silhouettes.
std::string count_as_text(const std::string& text, unsigned how) {
  std::string_view rest = text;
  const std::string scene = take_word(rest), view = take_word(rest);
  std::vector<Setting> settings;
  std::string name;
  if (const std::size_t equals = rest.find('='); equals != rest.npos) {
    name = rest.substr(0, equals);
    settings.push_back({name.c_str(), static_cast<unsigned>(std::stoul(take_word(rest).substr(equals + 1)))});
  }
  return std::to_string(count(scene, view.c_str(), how, rest, settings));
}

[[maybe_unused]] const bool counts_are_added =
    add_function_scripts(LIGNE_SOURCE_DIR "/tests/atherton_weiler/counts",
                         {{"polygons", [](auto& text) { return count_as_text(text, kPolygons); }},
                          {"silhouettes", [](auto& text) { return count_as_text(text, kSilhouettes); }}});

TEST(PolygonStudy, CyclicOverlapIsUndone) {
  for (const char* scene : {"cyclic_3", "cyclic_4", "cyclic_5", "cyclic_6"}) {
    EXPECT_GT(count(scene, "front", kPolygons, "wrong sorts"), 0u) << scene;
    EXPECT_EQ(count(scene, "front", kPolygons, "regions"), count(scene, "front", kFaces, "regions")) << scene;
  }
}

TEST(PolygonStudy, ConvexBodiesTakeFewClips) {
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
    finish(scene);
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
      EXPECT_TRUE(bytes_of(general) == bytes_of(convex));
      EXPECT_TRUE(bytes_of(convex) == bytes_of(compute_visibility(file, "iso", how)));
    }
  }
}

/// [Boulle1980] 2.4.2.4: a nearer face takes the place of the clip face at once.
TEST(PolygonStudy, NearerFacesTakeTheirPlaceAtOnce) {
  EXPECT_GT(count("thesis_2_68", "front", kPolygons, "clip faces given up at once", {kAtOnce}), 0u);
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
  finish(scene);
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
    finish(scene);
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

}  // namespace
}  // namespace ligne::test
