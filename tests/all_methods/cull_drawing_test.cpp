// Culling changes no drawing: every scene of the corpus in every standard view, and random closed surfaces that penetrate
// themselves, drawn with and without their back faces.

#include <gtest/gtest.h>

#include <filesystem>
#include <numbers>
#include <random>
#include <set>

#include "drawing/stroke_difference.hpp"
#include "scene/clean/clean.hpp"
#include "support/comparison.hpp"
#include "support/corpus_scene.hpp"
#include "support/scenes.hpp"
#include "view/cull.hpp"

namespace ligne::test {
namespace {

struct Drawings {
  StrokeModel all, culled;
  std::size_t faces = 0;  ///< left out
};

Drawings drawings(const Scene& scene, const CameraRequest& request, const char* method = "auto") {
  const Topology topology = build_topology(scene);
  const View view = make_view(scene, make_camera(request, scene), {{{10, 10}, {kPageWidth - 10, kPageHeight - 10}}},
                              {{0, 0}, {kPageWidth, kPageHeight}});
  ProjectedScene projected = project(scene, topology, view, {classes("all"), 30});
  const auto strokes = [&] {
    StudyOptions options;
    options.wanted = kStrokes;
    StrokeModel model = *find_method(method)->study(projected, options).strokes;
    remove_coincident_strokes(model, coincidence_mm(projected));
    return model;
  };
  Drawings result;
  result.all = strokes();
  const BackFaces back_faces = find_back_faces(scene, topology, view);
  cull(projected, back_faces);
  result.faces = back_faces.faces;
  result.culled = strokes();
  return result;
}

/// What is seen in one drawing and not in the other, in words.
std::string missing(const StrokeModel& from, const StrokeModel& in, const char* where) {
  std::string faults;
  for (const Segment& open : parts_missing(from, in, kSameLineMm, true)) faults += where + words(open) + '\n';
  return faults;
}

std::string differences(const Drawings& d) {
  return missing(d.all, d.culled, "lost by culling: ") + missing(d.culled, d.all, "only when culled: ");
}

TEST(CullDrawing, ChangesNoSceneOfTheCorpus) {
  std::size_t faces = 0;
  for (const std::filesystem::path& file : corpus_files()) {
    const Scene scene = scene_of_file(file);
    for (const StandardView& view : standard_views(scene)) {
      const Drawings d = drawings(scene, view.camera);
      faces += d.faces;
      EXPECT_EQ(differences(d), "") << file.stem() << ", view " << view.name;
    }
  }
  EXPECT_GT(faces, 1000u);
}

/// A ball of n meridians and n - 3 circles of latitude, whose corners move in and out.
Scene ball(unsigned seed, double least, double most) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> radius(least, most);
  const std::uint32_t n = 8, rings = n - 3;
  Scene scene;
  begin_object(scene);
  const auto corner = [&](double latitude, double longitude) {
    scene.vertices.push_back(
        Point3{std::cos(latitude) * std::cos(longitude), std::cos(latitude) * std::sin(longitude), std::sin(latitude)} *
        radius(random));
  };
  corner(-std::numbers::pi / 2, 0);
  for (std::uint32_t ring = 1; ring <= rings; ++ring) {
    for (std::uint32_t i = 0; i < n; ++i)
      corner(std::numbers::pi * (ring / double(rings + 1) - 0.5), 2 * std::numbers::pi * i / n);
  }
  corner(std::numbers::pi / 2, 0);
  const auto at = [&](std::uint32_t ring, std::uint32_t i) { return 1 + ring * n + i % n; };
  for (std::uint32_t i = 0; i < n; ++i) {
    scene.faces.add_triangle(0, at(0, i + 1), at(0, i));
    for (std::uint32_t ring = 0; ring + 1 < rings; ++ring) {
      scene.faces.add_triangle(at(ring, i), at(ring, i + 1), at(ring + 1, i + 1));
      scene.faces.add_triangle(at(ring, i), at(ring + 1, i + 1), at(ring + 1, i));
    }
    scene.faces.add_triangle(at(rings - 1, i), at(rings - 1, i + 1), 1 + rings * n);
  }
  end_object(scene);
  Warnings warnings;
  finish_scene(scene, warnings);
  return scene;
}

TEST(CullDrawing, ChangesNoBall) {
  std::size_t culled = 0, kept = 0;
  for (unsigned seed = 0; seed < 400; ++seed) {
    // From dented ones to some that are inside out here and there.
    const Scene scene = ball(seed, 1 - 0.006 * seed, 1);
    const auto views = standard_views(scene);
    const StandardView& view = views[seed % views.size()];
    const Drawings d = drawings(scene, view.camera);
    ++(d.faces > 0 ? culled : kept);
    EXPECT_EQ(differences(d), "") << "seed " << seed << ", view " << view.name;
  }
  EXPECT_GT(culled, 50u);
  EXPECT_GT(kept, 50u);
}

/// All edges of the inner cube that it does not hide itself are seen through the outer one, whose own back edges are seen as
/// well; by every method that sees through glass.
TEST(CullDrawing, ACubeInACubeOfGlass) {
  const Scene scene = corpus_scene("cube_in_glass");
  std::size_t methods = 0;
  for (const Method* each : all_methods()) {
    if (each->traits().glass != Glass::seen_through) continue;
    ++methods;
    const std::string method(each->traits().name);
    const Drawings d = drawings(scene, along({-0.37, 0.83, -0.41}), method.c_str());
    EXPECT_EQ(d.faces, 3u) << "of the inner cube; " << method;
    EXPECT_EQ(differences(d), "") << method;
    EXPECT_EQ(d.culled.strokes.size(), d.all.strokes.size()) << method;
    std::set<std::uint32_t> edges;
    for (const Stroke& s : d.culled.strokes) edges.insert(s.source);
    EXPECT_EQ(edges.size(), 12u + 9u) << "edges of the outer cube, and those of the inner one that it does not hide itself";
  }
  EXPECT_EQ(methods, 4u);
}

TEST(CullDrawing, ChangesNoSceneWithGlass) {
  const std::filesystem::path folder = std::filesystem::path(LIGNE_SOURCE_DIR) / "tests/atherton_weiler/scenes";
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const Scene scene = scene_of_file(entry.path());
    for (const StandardView& view : standard_views(scene)) {
      const Drawings d = drawings(scene, view.camera, "atherton-weiler");
      EXPECT_EQ(differences(d), "") << entry.path().stem() << ", view " << view.name;
    }
  }
}

TEST(CullDrawing, ChangesNothingBehindGlass) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> u(-1, 1);
    Scene scene;
    for (int i = 0; i < 8; ++i) {
      const Point3 middle = Point3{u(random), u(random), u(random)} * 3.0,
                   turns = Point3{u(random), u(random), u(random)} * 3.0;
      add_box(scene, middle, {3, 2.5, 2}, rotation(turns.x, turns.y, turns.z));
    }
    scene.materials = {{"plain", {0.8, 0.8, 0.8}, 1}, {"glass", {0.5, 0.7, 0.9}, 0.4}};
    // Boxes of glass, of stone, and some with a pane.
    for (std::uint32_t f = 0; f < scene.faces.size(); ++f) {
      const std::uint32_t o = f / 6;
      scene.face_material.push_back(o % 3 == 0 || (o % 3 == 1 && f % 6 == seed % 6));
    }
    const Drawings d = drawings(scene, along({-1, 2, -1}), "atherton-weiler");
    EXPECT_GT(d.faces, 0u);
    EXPECT_EQ(differences(d), "") << "seed " << seed;
  }
}

}  // namespace
}  // namespace ligne::test
