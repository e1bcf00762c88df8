// Lines behind transparent faces against another method on other scenes: what is seen at all is what is seen when the
// transparent faces are taken away, and what is seen directly is what is seen when they are opaque.

#include "main/tier.hpp"
#include "support/scenes.hpp"
#include "visibility/methods.hpp"

namespace ligne::test {
namespace {

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
  return project_on_a4(scene, camera, "outline border crease mesh");
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
  expect_equal(lengths(*found.strokes, 0, 255), lengths(*appel_method().compute_visibility(without, {}).strokes, 0, 255));
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
    for_triangles_at(scene, p, [&](const Triangle& t, double z, double least) {
      const bool is_of_edge = t.face == edge->face0 || t.face == edge->face1;
      if (!is_of_edge && least > 0 && z < (double(s.z_from) + s.z_to) / 2)
        ++(scene.face_is_transparent[t.face] ? transparent : opaque);
    });
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
      const StrokeModel in_front = *appel_method().compute_visibility(opaque, {}).strokes,
                        all = *appel_method().compute_visibility(without, {}).strokes;
      for (const unsigned study : {0u, 1u, 2u}) {
        SCOPED_TRACE(study);
        VisibilityOptions options;
        options.settings.set("study", ParameterWord{study});
        const StrokeModel found = *atherton_weiler_method().compute_visibility(with_glass, options).strokes;
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
