// The number of faces before an edge: counted edge by edge, and carried from vertex to vertex in three ways.

#include "support/corpus_scene.hpp"
#include "support/scenes.hpp"
#include "support/test.hpp"

namespace ligne::test {
namespace {

/// Places of the words of --propagate.
enum Word : unsigned { kTest = 1, kCount, kNature, kPath };

VisibilityResult carried(const ProjectedScene& projected, Word word) {
  VisibilityOptions options;
  options.hidden_strokes = true;
  options.settings.set("propagate", ParameterWord{word});
  return find_method("appel")->compute_visibility(projected, options);
}

/// Strokes in the order of their sources and parameters, with the number of faces before each.
std::vector<std::string> words_of(const StrokeModel& model) {
  std::vector<std::string> words;
  for (const Stroke& s : model.strokes) {
    char text[160];
    std::snprintf(text, sizeof text, "%08u %.6f %.6f %s before it: %u", s.source, s.t_from, s.t_to,
                  s.visible ? "visible" : "hidden", s.level);
    words.emplace_back(text);
  }
  std::sort(words.begin(), words.end());
  return words;
}

/// Plates of 4, 3 and 2 units before a line of 6: behind three, two and one of them.
TEST(Propagation, CountsTheFacesBeforeEachPart) {
  const Scene scene = scene_of_faces({{{-3, 9, 0}, {3, 9, 0}, {3, 9, 8}, {-3, 9, 8}},
                                      {{-2, 3, -1}, {2, 3, -1}, {2, 3, 1}, {-2, 3, 1}},
                                      {{-1.5, 2, -1}, {1.5, 2, -1}, {1.5, 2, 1}, {-1.5, 2, 1}},
                                      {{-1, 1, -1}, {1, 1, -1}, {1, 1, 1}, {-1, 1, 1}}});
  const ProjectedScene projected = project_on_a4(scene, along({0, 1, 0}), "all");
  for (const Word word : {kTest, kCount, kNature, kPath}) {
    const VisibilityResult result = carried(projected, word);
    std::map<unsigned, double> share;  // of the lowest edge of the farthest plate, by faces before it
    double total = 0;
    const Topology topology = build_topology(scene);
    for (const Stroke& s : result.strokes->strokes) {
      const Edge& edge = topology.edges[s.source];
      if (scene.vertices[edge.v0].y != 9 || scene.vertices[edge.v0].z != 0 || scene.vertices[edge.v1].z != 0) continue;
      share[s.level] += s.t_to - s.t_from;
      total += s.t_to - s.t_from;
      EXPECT_EQ(s.visible, s.level == 0);
    }
    EXPECT_NEAR(total, 1, 1e-6);
    EXPECT_NEAR(share[0], 2.0 / 6, 1e-6);
    EXPECT_NEAR(share[1], 1.0 / 6, 1e-6);
    EXPECT_NEAR(share[2], 1.0 / 6, 1e-6);
    EXPECT_NEAR(share[3], 2.0 / 6, 1e-6);
  }
}

TEST(Propagation, GivesWhatATestOfEachEdgeGives) {
  std::vector<std::pair<std::string, Scene>> scenes;
  for (const unsigned seed : {1u, 2u, 3u}) {
    scenes.emplace_back("penetrating " + std::to_string(seed), random_boxes(20, seed, 5, {4, 2, 1}));
    scenes.emplace_back("apart " + std::to_string(seed), random_boxes(60, seed, 60, {9, 4, 5}));
  }
  for (const std::filesystem::path& file : corpus_files(20'000))
    scenes.emplace_back(file.stem().string(), scene_of_file(file));
  std::uint64_t carried_edges = 0;
  for (const auto& [name, scene] : scenes) {
    const ProjectedScene projected = project_on_a4(scene, along({-0.37, 0.83, -0.41}));
    const VisibilityResult each = carried(projected, kTest);
    for (const Word word : {kCount, kNature, kPath}) {
      const VisibilityResult result = carried(projected, word);
      carried_edges += count_of(result.statistics, "edges carried");
      EXPECT_EQ(words_of(*result.strokes), words_of(*each.strokes)) << name << ", way " << word;
    }
  }
  EXPECT_GT(carried_edges, 1000u);
}

/// Most edges of boxes that touch nothing are carried, at a fraction of the tests.
TEST(Propagation, SparesTests) {
  const ProjectedScene projected = project_on_a4(random_boxes(200, 5, 40, {4, 2, 3}), along({-1, 2, -1}));
  const std::uint64_t all = count_of(carried(projected, kTest).statistics, "of them for edges");
  for (const Word word : {kCount, kNature, kPath}) {
    const Statistics statistics = carried(projected, word).statistics;
    EXPECT_GT(count_of(statistics, "edges carried"), 3 * count_of(statistics, "edges against all faces"));
    EXPECT_LT(3 * count_of(statistics, "of them for edges"), all);
  }
}

}  // namespace
}  // namespace ligne::test
