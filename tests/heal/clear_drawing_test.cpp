/// Clear drawings of meshes with defects against those of the shapes that they stand for.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <numeric>
#include <random>
#include <set>
#include <string>

#include <glm/geometric.hpp>

#include "picture/models.hpp"
#include "picture/scene_study.hpp"
#include "scene/readers/reader.hpp"

namespace ligne {
namespace {

namespace fs = std::filesystem;

std::string corpus_file(const std::string& name) { return LIGNE_SOURCE_DIR "/tests/corpus/" + name + ".json"; }

/// Drawn length of each class, mm.
using Lengths = std::array<double, kLineClassCount>;

Lengths lengths(const Scene& scene, Quality quality, const std::string& view) {
  PictureRequest request;
  request.lines.quality = quality;
  request.view.named_view = view;
  RunReport run;
  PreparedScene prepared = prepare(scene, request, std::nullopt, run);
  const SceneStudy found = study(prepared, std::nullopt, false, run);
  Lengths sum{};
  const StrokeModel& model = *found.result.strokes;
  for (const Stroke& s : model.strokes) {
    if (!s.visible) continue;
    sum[static_cast<std::size_t>(s.line_class)] += glm::distance(model.lattice.to_mm(s.from), model.lattice.to_mm(s.to));
  }
  return sum;
}

Lengths drawn(const std::string& file, Quality quality, const std::string& view) {
  ModelRequest models{.files = {file}};
  models.quality = quality;
  return lengths(load_models(models).scene, quality, view);
}

class Defect : public testing::TestWithParam<const char*> {};

/// The crack is an eight-thousandth of a unit, 6 micrometres on the page: so much the lines may differ at each of their
/// ends.
TEST_P(Defect, DrawsAsTheCube) {
  for (const char* view : {"iso", "front", "top", "dimetric", "right", "back"}) {
    const Lengths expected = drawn(corpus_file("cube"), Quality::exact, view);
    const Lengths clear = drawn(corpus_file(GetParam()), Quality::clear, view);
    for (std::size_t c = 0; c < kLineClassCount; ++c) {
      EXPECT_NEAR(clear[c], expected[c], 0.1) << view << ", " << kLineClassNames[c];
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Clear, Defect,
                         testing::Values("cube_stored_twice", "cube_with_crack", "cube_with_loose_lid", "duplicate_objects"),
                         [](const auto& info) { return std::string(info.param); });

/// Scenes of the corpus that clear lines draw otherwise, by the rule of docs/clear-lines.md that they are there for.
const std::set<std::string> kHealed{"cube_stored_twice",   "duplicate_faces", "cube_with_crack",
                                    "cube_with_loose_lid", "t_junction",      "crumpled_ball"};
const std::set<std::string> kSmooth{"height_field", "low_sphere", "torus"};
/// What is smaller than the pen: at most a hundredth of these lines.
const std::set<std::string> kShortBits{"grazing_penetration", "mixed_sizes",    "nearly_edge_on_iso",
                                       "needle_pyramids",     "sizes_in_a_row", "thin_slivers"};

TEST(ClearDrawing, KeepsTheLinesOfTheCorpus) {
  for (const fs::directory_entry& entry : fs::directory_iterator(LIGNE_SOURCE_DIR "/tests/corpus")) {
    const fs::path& file = entry.path();
    const std::string name = file.stem().string();
    if (file.extension() != ".json" || kHealed.contains(name) || kSmooth.contains(name)) continue;
    for (const char* view : {"iso", "front", "dimetric"}) {
      const Lengths exact = drawn(file.string(), Quality::exact, view), clear = drawn(file.string(), Quality::clear, view);
      for (std::size_t c = 0; c < kLineClassCount; ++c) {
        const double all = std::accumulate(exact.begin(), exact.end(), 0.0);
        const double tolerance = kShortBits.contains(name) ? all / 100 : 1e-3;
        EXPECT_NEAR(clear[c], exact[c], tolerance) << name << " " << view << ", " << kLineClassNames[c];
      }
    }
  }
}

/// The ball cuts itself at tips of narrow faces. What lies near both rims of a tip goes no detour round it: where pieces of
/// intersections are drawn on rims instead, they are as long as before, but for their way to the rim.
TEST(ClearDrawing, DrawsNothingRoundTheTipsOfFaces) {
  for (const char* view : {"iso", "front"}) {
    const Lengths exact = drawn(corpus_file("crumpled_ball"), Quality::exact, view),
                  clear = drawn(corpus_file("crumpled_ball"), Quality::clear, view);
    EXPECT_NEAR(std::accumulate(clear.begin(), clear.end(), 0.0), std::accumulate(exact.begin(), exact.end(), 0.0), 2)
        << view;
  }
}

/// The faces of every object in another order.
Scene shuffled(const Scene& scene, unsigned seed) {
  Scene out = scene;
  out.faces = {};
  std::mt19937 random(seed);
  for (const Object& object : scene.objects) {
    std::vector<std::uint32_t> order;
    for (std::uint32_t f = object.face_begin; f < object.face_end; ++f) order.push_back(f);
    std::shuffle(order.begin(), order.end(), random);
    for (const std::uint32_t f : order) {
      for (std::size_t c = 0; c < scene.faces.contour_count(f); ++c) {
        if (c == 0)
          out.faces.add_face(scene.faces.contour(f, c));
        else
          out.faces.add_hole(scene.faces.contour(f, c));
      }
    }
  }
  return out;
}

TEST(ClearDrawing, TheOrderOfFacesDoesNotMatter) {
  std::vector<std::string> files{corpus_file("cube_stored_twice"), corpus_file("cube_with_crack"),
                                 corpus_file("t_junction")};
  const fs::path chair = fs::path(LIGNE_MODELS_DIR) / "chair_model.obj";
  if (fs::exists(chair)) files.push_back(chair.string());
  for (const std::string& file : files) {
    Warnings warnings;
    Scene scene = read_scene(file, {}, warnings);
    scene.face_material.clear(), scene.corner_flags.clear();
    Scene other = shuffled(scene, 5);
    for (Scene* s : {&scene, &other}) {
      Topology topology = build_topology(*s);
      heal(*s, topology, {});
    }
    const Lengths a = lengths(scene, Quality::clear, "iso"), b = lengths(other, Quality::clear, "iso");
    for (std::size_t c = 0; c < kLineClassCount; ++c) EXPECT_NEAR(a[c], b[c], 1e-3) << file << ", " << kLineClassNames[c];
  }
}

}  // namespace
}  // namespace ligne
