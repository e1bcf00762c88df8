// The number of faces before an edge: counted edge by edge, and carried from vertex to vertex in three ways.

#include "base/parallel.hpp"
#include "linework/stroke_geometry.hpp"
#include "main/tier.hpp"
#include "support/corpus_scene.hpp"
#include "support/scenes.hpp"

namespace ligne::test {
namespace {

/// Places of the words of --set propagate.
enum Word : unsigned { kTest = 1, kCount, kNature, kPath };

VisibilityResult carried(const ProjectedScene& projected, Word word) {
  VisibilityOptions options;
  options.hidden_strokes = true;
  options.settings.set("propagate", ParameterWord{word});
  return find_method("appel")->compute_visibility(projected, options);
}

/// The strokes by source and parameter. Neighbours behind equally many faces are one: only sets of faces part them.
std::vector<Stroke> joined(const StrokeModel& model) {
  std::vector<Stroke> all = model.strokes, joined;
  std::stable_sort(all.begin(), all.end(), [](const Stroke& a, const Stroke& b) {
    return std::tie(a.source, a.t_from) < std::tie(b.source, b.t_from);
  });
  for (const Stroke& s : all) {
    Stroke* const last = joined.empty() ? nullptr : &joined.back();
    if (last && !last->visible && !s.visible && last->source == s.source && last->t_to == s.t_from &&
        last->level == s.level) {
      last->t_to = s.t_to;
    } else {
      joined.push_back(s);
    }
  }
  return joined;
}

/// Strokes in the order of their sources and parameters, with the number of faces before each.
std::vector<std::string> words_of(const StrokeModel& model) {
  std::vector<std::string> words;
  for (const Stroke& s : joined(model)) {
    char text[160];
    std::snprintf(text, sizeof text, "%08u %.6f %.6f %s before it: %u", s.source, s.t_from, s.t_to,
                  s.visible ? "visible" : "hidden", s.level);
    words.emplace_back(text);
  }
  std::sort(words.begin(), words.end());
  return words;
}

/// Four plates one behind the other, by number from the farthest: the sets grow by one plate at each end.
TEST(Propagation, NamesTheFacesBeforeEachPart) {
  const Scene scene = scene_of_faces({{{-3, 9, 0}, {3, 9, 0}, {3, 9, 8}, {-3, 9, 8}},
                                      {{-2, 3, -1}, {2, 3, -1}, {2, 3, 1}, {-2, 3, 1}},
                                      {{-1.5, 2, -1}, {1.5, 2, -1}, {1.5, 2, 1}, {-1.5, 2, 1}},
                                      {{-1, 1, -1}, {1, 1, -1}, {1, 1, 1}, {-1, 1, 1}}});
  const VisibilityResult result = carried(project_on_a4(scene, along({0, 1, 0}), "all"), kNature);
  const Topology topology = build_topology(scene);
  std::map<std::vector<std::uint32_t>, double> share;
  for (const HiddenPart& part : result.strokes->hidden_parts) {
    const Edge& edge = topology.edges[part.source];
    if (scene.vertices[edge.v0].y == 9 && scene.vertices[edge.v0].z == 0 && scene.vertices[edge.v1].z == 0)
      share[part.faces] += part.t_to - part.t_from;
  }
  ASSERT_EQ(share.size(), 3u);
  EXPECT_NEAR((share[{1}]), 1.0 / 6, 1e-6);
  EXPECT_NEAR((share[{1, 2}]), 1.0 / 6, 1e-6);
  EXPECT_NEAR((share[{1, 2, 3}]), 2.0 / 6, 1e-6);
}

/// Whether a face has a triangle over the page point whose depth there is less; both with some slack for points of edges.
bool is_before(const ProjectedScene& scene, std::uint32_t face, Point2 at, double depth) {
  constexpr double kSlack = 1e-3;
  bool found = false;
  for_triangles_at(scene, (at - scene.lattice.origin_mm) / scene.lattice.step_mm,
                   [&](const Triangle& triangle, double z, double least) {
                     found |= triangle.face == face && least > -kSlack && z < depth + kSlack;
                   });
  return found;
}

/// Every set has as many faces as were counted, each of them once, and before the middle of the part.
TEST(Propagation, EveryFaceOfASetIsBeforeTheLine) {
  std::size_t sets = 0;
  for (const char* name : {"bricks", "lattice_of_bars", "gear", "holes_behind_holes", "cyclic_4", "stair", "nested_cubes"}) {
    const ProjectedScene projected = project_on_a4(corpus_scene(name), along({-0.37, 0.83, -0.41}));
    const VisibilityResult result = carried(projected, kNature);
    for (const Stroke& s : result.strokes->strokes) {
      const HiddenPart* const part = hidden_part_of(*result.strokes, s);
      ASSERT_EQ(part != nullptr, !s.visible);
      if (!part) continue;
      ++sets;
      EXPECT_EQ(part->count, s.level);
      EXPECT_EQ(part->faces.size(), part->count);
      EXPECT_EQ(std::ranges::adjacent_find(part->faces, std::greater_equal{}), part->faces.end());
      const Point2 middle = (projected.lattice.to_mm(s.from) + projected.lattice.to_mm(s.to)) / 2.0;
      for (const std::uint32_t face : part->faces)
        EXPECT_TRUE(is_before(projected, face, middle, (double(s.z_from) + s.z_to) / 2)) << name << ", face " << face;
    }
  }
  EXPECT_GT(sets, 300u);
}

TEST(Propagation, LeavesOutWhatManyFacesHide) {
  StrokeModel all =
      std::move(*carried(project_on_a4(random_boxes(40, 7, 30, {4, 2, 3}), along({-1, 2, -1})), kTest).strokes);
  StrokeModel few = all;
  leave_out_often_hidden(few, 2);
  std::erase_if(all.strokes, [](const Stroke& s) { return !s.visible && s.level > 2; });
  EXPECT_EQ(words_of(few), words_of(all));
  EXPECT_TRUE(std::ranges::any_of(few.strokes, [](const Stroke& s) { return s.level == 2; }));
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
      carried_edges += count_of(result.statistics, "edges propagated");
      EXPECT_EQ(words_of(*result.strokes), words_of(*each.strokes)) << name << ", way " << word;
    }
  }
  EXPECT_GT(carried_edges, 1000u);
}

/// Most edges of boxes that touch nothing are carried, at a fraction of the tests.
TEST(Propagation, SparesTests) {
  const ProjectedScene projected = project_on_a4(random_boxes(200, 5, 40, {4, 2, 3}), along({-1, 2, -1}));
  const std::uint64_t all = count_of(carried(projected, kTest).statistics, "of these, for edges");
  for (const Word word : {kCount, kNature, kPath}) {
    const Statistics statistics = carried(projected, word).statistics;
    EXPECT_GT(count_of(statistics, "edges propagated"), 3 * count_of(statistics, "edges against all faces"));
    EXPECT_LT(3 * count_of(statistics, "of these, for edges"), all);
  }
}

// Every method gives the same strokes for any number of threads.

/// A method of another product has its own test of it.
std::vector<const Method*> methods_of_strokes() {
  std::vector<const Method*> methods;
  for (const Method* method : all_methods())
    if (method->traits().products & kStrokes) methods.push_back(method);
  return methods;
}

class Determinism : public testing::TestWithParam<const Method*> {};

TEST_P(Determinism, OneThreadAndManyGiveTheSameStrokes) {
  // Hidden lines and intersections cost a method the more, the more boxes hide each other.
  const int part = runs_all() ? 1 : 3;
  for (const auto& [boxes, hidden] : {std::pair(1500 / part, false), std::pair(500 / part, true)}) {
    const PictureRequest request{along({-1, 2, -1}), "all", hidden, 0, std::string(GetParam()->traits().name)};
    const Scene scene = random_boxes(boxes, 7, 10, {2, 2, 2});
    Picture one, four;
    run_with_threads(1, [&] { one = draw(scene, request); });
    run_with_threads(4, [&] { four = draw(scene, request); });
    ASSERT_GT(one.model.strokes.size(), 1000u);
    VisibilityResult first, second;
    first.strokes = one.model, second.strokes = four.model;
    EXPECT_TRUE(bytes_of(first) == bytes_of(second));
  }
}

INSTANTIATE_TEST_SUITE_P(Methods, Determinism, testing::ValuesIn(methods_of_strokes()),
                         [](const auto& info) { return as_test_name(info.param->traits().name); });

/// Lines beside a scene that are edges of no face, by every method.

/// The strokes of class axes of lines beside a plate of 2 x 2 at z = 0, seen from above at 10 mm by unit.
std::vector<Stroke> seen(const Method& method, const std::vector<std::array<Point3, 2>>& lines, bool hidden,
                         double* step_mm) {
  Scene scene;
  add_box(scene, {-1, -1, -1}, {2, 2, 1}, kUpright);
  const Topology topology = build_topology(scene);
  const Camera camera = make_camera(along({0, 0, -1}), scene);
  const View view = make_view(scene, camera, {{{10, 10}, {90, 90}}}, {{0, 0}, {100, 100}}, 10);
  ProjectedScene projected = project(scene, topology, view, {classes("feature"), 30});
  const std::uint32_t edges = projected.source_count;
  add_lines(projected, lines, LineClass::axes);
  EXPECT_EQ(projected.source_count, edges + lines.size());
  VisibilityOptions options;
  options.hidden_strokes = hidden;
  const StrokeModel model = *method.compute_visibility(projected, options).strokes;
  *step_mm = model.lattice.step_mm;
  std::vector<Stroke> strokes;
  for (const Stroke& s : model.strokes) {
    if (s.line_class != LineClass::axes) continue;
    EXPECT_GE(s.source, edges);
    strokes.push_back(s);
  }
  return strokes;
}

double length(const std::vector<Stroke>& strokes, double step_mm, bool visible) {
  double sum = 0;
  for (const Stroke& s : strokes)
    if (s.visible == visible) sum += std::hypot(double(s.to.x) - s.from.x, double(s.to.y) - s.from.y) * step_mm;
  return sum;
}

TEST(LinesOfNoFace, AreHiddenByFacesAndHideNothing) {
  constexpr double kMicrometre = 1e-3;
  for (const Method* method : all_methods()) {
    if (!(method->traits().products & kStrokes) || !method->traits().only_for.empty()) continue;
    SCOPED_TRACE(method->traits().name);
    const double tolerance = std::max(kMicrometre, 2 * method->traits().tolerance_mm);
    double step = 0;
    const auto below = seen(*method, {{{{-3, 0.5, -2}, {3, 0.5, -2}}}}, true, &step);
    EXPECT_NEAR(length(below, step, true), 40, tolerance);
    EXPECT_NEAR(length(below, step, false), 20, tolerance);
    const auto above = seen(*method, {{{{-3, 0.5, 1}, {3, 0.5, 1}}}}, true, &step);
    EXPECT_NEAR(length(above, step, true), 60, tolerance);
    // Lines are cut off at the sheet, 10 units wide: the parameters are those of the whole line.
    const auto clipped =
        seen(*method, {{{{0, 2, 0}, {1, 2, 0}}}, {{{-20, 3, 0}, {20, 3, 0}}}, {{{-20, 30, 0}, {20, 30, 0}}}}, false, &step);
    ASSERT_EQ(clipped.size(), 2u);
    EXPECT_NEAR(length(clipped, step, true), 10 + 100, tolerance);
    const Stroke& cut = clipped[0].source > clipped[1].source ? clipped[0] : clipped[1];
    EXPECT_NEAR(cut.t_from, 15.0 / 40, 1e-6);
    EXPECT_NEAR(cut.t_to, 25.0 / 40, 1e-6);
  }
}

}  // namespace
}  // namespace ligne::test
