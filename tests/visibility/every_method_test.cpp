// Every method gives the same strokes for any number of threads.

#include "base/parallel.hpp"
#include "main/tier.hpp"
#include "support/scenes.hpp"
#include "support/test.hpp"

namespace ligne::test {
namespace {

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
    const Scene scene = random_boxes(boxes, 7, 10, {2, 2, 2});
    const auto with_threads = [&, hidden = hidden](int n) {
      Picture picture;
      run_with_threads(n, [&] {
        picture = draw(scene, {along({-1, 2, -1}), "all", hidden, 0, std::string(GetParam()->traits().name)});
      });
      return picture;
    };
    const Picture one = with_threads(1), four = with_threads(4);
    ASSERT_GT(one.model.strokes.size(), 1000u);
    expect_same_strokes(one.model, four.model);
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
