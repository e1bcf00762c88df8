// The oracle on scenes whose answers are worked out by hand. Page and model units are the same here (scale 1).

#include <unistd.h>

#include "main/script.hpp"
#include "oracle/answers.hpp"
#include "support/mesh_text.hpp"
#include "support/scene_parts.hpp"
#include "support/test.hpp"

namespace oracle {
namespace {

using ligne::Scene;
using ligne::test::add_box;
using ligne::test::add_face;
using ligne::test::scene_of_faces;

constexpr double kTolerance = 0.003;  // what is within a micrometre of a change is undecided, at both ends

View along(const Point3& direction, const Point3& up = {0, 0, 1}) {
  View view;
  view.direction = direction;
  view.up = up;
  view.offset = {100, 100};
  return view;
}

/// The eye at the origin looks along y; ten units away the page has the scale 10.
View from_the_origin() {
  View view;
  view.perspective = true;
  view.target = {0, 10, 0};
  view.scale = 10;
  view.offset = {100, 100};
  return view;
}

/// Index of the edge between the two points, of the first object that has it.
std::size_t edge_between(const Oracle& oracle, Point3 a, Point3 b) {
  const auto edges = oracle.edges();
  for (std::size_t i = 0; i < edges.size(); ++i)
    if ((edges[i].a == a && edges[i].b == b) || (edges[i].a == b && edges[i].b == a)) return i;
  ADD_FAILURE() << "there is no such edge";
  return 0;
}

/// The part [from, to] of the parameter has the answer all over, but for what lies within a micrometre of its ends, or of a
/// side that crosses the edge there.
void expect_part(const std::vector<Interval>& intervals, double from, double to, Answer answer, double length) {
  const double margin = kTolerance / length;
  for (const Interval& i : intervals) {
    if (i.t1 <= from + margin || i.t0 >= to - margin || i.t1 - i.t0 < margin) continue;
    EXPECT_EQ(i.answer, answer) << "from " << i.t0 << " to " << i.t1;
  }
  ASSERT_FALSE(intervals.empty());
  EXPECT_LE(intervals.front().t0, from + margin);
  EXPECT_GE(intervals.back().t1, to - margin);
}

double length_of(const std::vector<Interval>& intervals, Answer answer) {
  double sum = 0;
  for (const Interval& i : intervals) sum += i.answer == answer ? std::hypot(i.to.x - i.from.x, i.to.y - i.from.y) : 0;
  return sum;
}

double length_of_all(const Oracle& oracle, Answer answer) {
  double sum = 0;
  for (std::size_t i = 0; i < oracle.edges().size(); ++i) sum += length_of(oracle.visible_intervals(i), answer);
  return sum;
}

/// "SIGHT A B: MESH": what is seen of the edge from A to B along that direction, or by an eye at the origin, and where that
/// changes, without what is undecided within a micrometre of a change.
std::string seen_of(const std::string& text) {
  const std::vector<std::string> words = ligne::test::words_of(text.substr(0, text.find(':')));
  const View view = words.at(0) == "eye" ? from_the_origin() : along(ligne::test::point_of(words[0]));
  const Point3 a = ligne::test::point_of(words.at(1)), b = ligne::test::point_of(words.at(2));
  const Scene scene = ligne::test::mesh_of(ligne::test::unescaped(text.substr(text.find(':') + 2)) + "\nexact").scene();
  const Oracle oracle(scene, view);
  constexpr std::array kNames{"visible", "hidden", "undecided"};
  std::string all, last;
  for (const Interval& i : oracle.visible_intervals(edge_between(oracle, a, b))) {
    const char* const answer = i.answer == Answer::visible ? kNames[0] : i.answer == Answer::hidden ? kNames[1] : kNames[2];
    if ((i.t1 - i.t0) * glm::distance(a, b) < kTolerance || answer == last) continue;
    EXPECT_EQ(oracle.edges()[edge_between(oracle, a, b)].a, a);
    if (!all.empty()) all += " " + ligne::test::as_text(std::round(i.t0 * 1000) / 1000) + " ";
    all += last = answer;
    if (i.answer == Answer::undecided && i.exactly_hidden) all += " exactly";
  }
  return all;
}

[[maybe_unused]] const bool sights_are_added =
    ligne::test::add_function_scripts(LIGNE_SOURCE_DIR "/tests/oracle/sights", {{"edge", seen_of}});

TEST(Oracle, SeenThroughAHole) {
  Scene scene;
  add_face(scene,
           {{{-10, 0, -10}, {10, 0, -10}, {10, 0, 10}, {-10, 0, 10}}, {{-4, 0, -4}, {-4, 0, 4}, {4, 0, 4}, {4, 0, -4}}});
  add_face(scene, {{{-20, 5, -1}, {20, 5, -1}, {20, 5, 1}, {-20, 5, 1}}});
  const Oracle oracle(scene, along({0, 3, 0}));
  const auto i = oracle.visible_intervals(edge_between(oracle, {-20, 5, 1}, {20, 5, 1}));
  expect_part(i, 0, 0.25, Answer::visible, 40);
  expect_part(i, 0.25, 0.4, Answer::hidden, 40);
  expect_part(i, 0.4, 0.6, Answer::visible, 40);
  expect_part(i, 0.6, 0.75, Answer::hidden, 40);
  expect_part(i, 0.75, 1, Answer::visible, 40);
}

TEST(Oracle, CubeInIsometry) {
  Scene scene;
  add_box(scene, {0, 0, 0}, {10, 10, 10});
  const Oracle oracle(scene, along({-1, 1, -1}));
  const double edge = 10 * std::sqrt(2.0 / 3);
  EXPECT_EQ(oracle.edges().size(), 12u);
  // The three hidden edges lie exactly behind the three front ones, that is behind common sides of faces.
  EXPECT_NEAR(length_of_all(oracle, Answer::visible), 9 * edge, 9 * kTolerance);
  EXPECT_NEAR(length_of_all(oracle, Answer::hidden), 3 * edge, 3 * kTolerance);
  EXPECT_EQ(std::count_if(oracle.edges().begin(), oracle.edges().end(),
                          [](const Edge& e) { return e.edge_class == EdgeClass::outline; }),
            6);
  EXPECT_EQ(std::count_if(oracle.edges().begin(), oracle.edges().end(),
                          [](const Edge& e) { return e.edge_class == EdgeClass::crease; }),
            6);
}

TEST(Oracle, TouchingCubesHideNoneOfTheirCommonLines) {
  Scene scene;
  add_box(scene, {0, 0, 0}, {10, 10, 10});
  add_box(scene, {10, 0, 0}, {10, 10, 10});
  const Oracle oracle(scene, along({-0.37, 0.83, -0.41}));
  EXPECT_TRUE(oracle.intersections().empty());
  // The upright edge at x = 10, y = 0 belongs to both cubes and is seen twice.
  int n = 0;
  for (std::size_t k = 0; k < oracle.edges().size(); ++k) {
    const Edge& e = oracle.edges()[k];
    if (e.a != Point3{10, 0, 0} || e.b != Point3{10, 0, 10}) continue;
    ++n;
    expect_part(oracle.visible_intervals(k), 0, 1, Answer::visible, 10);
  }
  EXPECT_EQ(n, 2);
}

TEST(Oracle, PenetratingPlates) {
  // Two squares that cross at right angles along x, from x = -5 to 5.
  const Scene scene =
      scene_of_faces({{{-5, -5, 0}, {5, -5, 0}, {5, 5, 0}, {-5, 5, 0}}, {{-5, 0, -5}, {5, 0, -5}, {5, 0, 5}, {-5, 0, 5}}});
  const Oracle oracle(scene, along({0, 1, -1.5}));
  ASSERT_EQ(oracle.intersections().size(), 1u);
  EXPECT_TRUE(oracle.intersections()[0].proper);
  EXPECT_NEAR(std::abs(oracle.intersections()[0].b.x - oracle.intersections()[0].a.x), 10, kTolerance);
  EXPECT_NEAR(oracle.intersections()[0].a.y, 0, 1e-12);
  EXPECT_NEAR(length_of(oracle.intersection_intervals(0), Answer::visible), 10, kTolerance);
  // The level square's far half is hidden by the upright one up to the height of that: its side edges from y = 0 on.
  const auto i = oracle.visible_intervals(edge_between(oracle, {-5, -5, 0}, {-5, 5, 0}));
  EXPECT_EQ(i.front().answer, Answer::visible);
}

TEST(Oracle, TouchingIsNoPenetration) {
  // An upright plate stands on a level one; another hangs 1e-14 through it, which is nothing.
  const Scene scene = scene_of_faces({{{-5, -5, 0}, {5, -5, 0}, {5, 5, 0}, {-5, 5, 0}},
                                      {{-3, 0, 0}, {3, 0, 0}, {3, 0, 4}, {-3, 0, 4}},
                                      {{-3, 1, -4}, {3, 1, -4}, {3, 1, 1e-14}, {-3, 1, 1e-14}}});
  const Oracle oracle(scene, along({-0.37, 0.83, -0.41}));
  for (const Intersection& x : oracle.intersections()) EXPECT_FALSE(x.proper);
  EXPECT_LE(oracle.intersections().size(), 1u);
}

TEST(Oracle, SurfaceThroughAPlateAlongACommonEdge) {
  // Two upright rectangles of one object with a common edge that lies in the level plate.
  Scene scene;
  add_face(scene, {{{-5, -5, 0}, {5, -5, 0}, {5, 5, 0}, {-5, 5, 0}}});
  ligne::test::begin_object(scene);
  scene.vertices.insert(scene.vertices.end(), {{-3, 0, -4}, {3, 0, -4}, {3, 0, 0}, {-3, 0, 0}, {3, 0, 4}, {-3, 0, 4}});
  const std::uint32_t lower[] = {4, 5, 6, 7}, upper[] = {7, 6, 8, 9};
  scene.faces.add_face(lower);
  scene.faces.add_face(upper);
  ligne::test::end_object(scene);
  const Oracle oracle(scene, along({-0.37, 0.83, -0.41}));
  ASSERT_EQ(oracle.intersections().size(), 2u);  // of the plate with either rectangle
  for (const Intersection& x : oracle.intersections()) {
    EXPECT_TRUE(x.proper);
    EXPECT_NEAR(std::abs(x.a.x - x.b.x), 6, kTolerance);
  }
}

TEST(Oracle, ThreeBarsInARing) {
  Scene scene;
  const double sixty = std::acos(-1.0) / 3;
  for (int i = 0; i < 3; ++i) {
    const double c = std::cos(2 * i * sixty), s = std::sin(2 * i * sixty);
    const auto at = [&](double u, double v, double z) { return Point3{c * u - s * v, s * u + c * v, z}; };
    add_face(scene, {{at(-6, -3, -1), at(6, -3, 1), at(6, -1, 1), at(-6, -1, -1)}});
  }
  const Oracle oracle(scene, along({0, 0, -1}, {0, 1, 0}));
  EXPECT_NEAR(length_of_all(oracle, Answer::visible), 3 * (2 * 12 + 2 * 2 - 2 * 2 / std::sin(sixty)), 12 * kTolerance);
  EXPECT_NEAR(length_of_all(oracle, Answer::hidden), 3 * 2 * 2 / std::sin(sixty), 12 * kTolerance);
}

TEST(Oracle, NothingBehindTheEye) {
  // A wall before the eye and one behind it; a floor that runs under the eye.
  const Scene scene = scene_of_faces({{{-5, -10, -5}, {5, -10, -5}, {5, -10, 5}, {-5, -10, 5}},
                                      {{-1, 10, -1}, {1, 10, -1}, {1, 10, 1}, {-1, 10, 1}},
                                      {{-3, -20, -1}, {3, -20, -1}, {3, 20, -1}, {-3, 20, -1}}});
  const Oracle oracle(scene, from_the_origin());
  EXPECT_TRUE(oracle.visible_intervals(edge_between(oracle, {-5, -10, -5}, {5, -10, -5})).empty());
  expect_part(oracle.visible_intervals(edge_between(oracle, {-1, 10, 1}, {1, 10, 1})), 0, 1, Answer::visible, 20);
  const auto floor = oracle.visible_intervals(edge_between(oracle, {3, -20, -1}, {3, 20, -1}));
  ASSERT_GT(floor.size(), 1u);
  EXPECT_NEAR(floor.back().t1, 1, 1e-12);
  // Where the floor's edge enters the window, at its lower or right side: from a micrometre outside to one inside nothing is
  // decided.
  const auto beyond = [](Point2 p) { return std::max(p.y - 210, p.x - 297); };
  EXPECT_NEAR(beyond(floor[0].from), 0.001, 1e-6);
  EXPECT_NEAR(beyond(floor[1].from), -0.001, 1e-6);
  EXPECT_TRUE(floor[0].at_border);
  EXPECT_EQ(floor[0].answer, Answer::undecided);
  EXPECT_FALSE(floor[1].at_border);
}

TEST(Oracle, FacesAtAPoint) {
  Scene scene;
  add_face(scene, {{{0, 0, 0}, {10, 0, 0}, {10, 0, 10}, {0, 0, 10}}, {{4, 0, 4}, {6, 0, 4}, {6, 0, 6}, {4, 0, 6}}});
  add_face(scene, {{{0, 5, 0}, {10, 5, 0}, {10, 5, 10}}});
  const Oracle oracle(scene, along({0, 1, 0}));
  const auto both = oracle.faces_at({108, 99});
  ASSERT_EQ(both.size(), 2u);
  EXPECT_EQ(both[0].face, 0u);
  EXPECT_NEAR(both[1].depth_mm - both[0].depth_mm, 5, 1e-12);
  EXPECT_EQ(oracle.faces_at({105.5, 95.5}).size(), 1u);  // in the hole: the triangle behind
  EXPECT_EQ(oracle.faces_at({102, 92}).size(), 1u);      // the triangle does not come here
  EXPECT_TRUE(oracle.faces_at({111, 99}).empty());
  ASSERT_EQ(oracle.faces_at({110, 95}).size(), 2u);
  EXPECT_TRUE(oracle.faces_at({110, 95})[0].on_side);
  EXPECT_NEAR(oracle.distance_to_sides({103, 99}), 1, 1e-12);
}

/// Answers that are kept between runs.
class KeptAnswers : public testing::Test {
 protected:
  KeptAnswers() {
    add_box(scene_, {0, 0, 0}, {10, 10, 10});
    add_box(scene_, {5, -3, 4}, {10, 10, 10});  // penetrates the other
  }
  ~KeptAnswers() override { std::filesystem::remove_all(folder_); }

  const std::filesystem::path folder_ = testing::TempDir() + "ligne-kept-" + std::to_string(getpid()), file_ = folder_ / "a";
  Scene scene_;
  const View view_ = along({-0.37, 0.83, -0.41});
};

TEST_F(KeptAnswers, AreReadAsTheyWereGiven) {
  const Answers answers = answers_of(Oracle(scene_, view_));
  ASSERT_GT(answers.intersections.size(), 0u);
  write_answers(file_, answers);
  Answers read;
  ASSERT_TRUE(read_answers(file_, read));
  EXPECT_TRUE(read == answers);
}

TEST_F(KeptAnswers, AreNotReadFromAFileThatIsNotWhole) {
  write_answers(file_, answers_of(Oracle(scene_, view_)));
  const std::string whole = ligne::test::bytes_of_file(file_);
  Answers read;
  for (const std::size_t length : {std::size_t{0}, std::size_t{7}, whole.size() / 2, whole.size() - 1}) {
    std::ofstream(file_, std::ios::binary) << whole.substr(0, length);
    EXPECT_FALSE(read_answers(file_, read)) << length;
  }
  std::string changed = whole;
  changed[whole.size() / 3] ^= 1;
  std::ofstream(file_, std::ios::binary) << changed;
  EXPECT_FALSE(read_answers(file_, read));
  std::filesystem::remove(file_);
  EXPECT_FALSE(read_answers(file_, read));
}

TEST_F(KeptAnswers, HaveAnotherNameForWhateverIsAsked) {
  constexpr double kLeast = 1e-300, kNext = 1 + 0x1p-52;
  const std::vector<std::function<void(Scene&, View&)>> changes{
      [](Scene&, View&) {},
      [](Scene&, View& v) { v.perspective = true; },
      [](Scene&, View& v) { v.direction.x *= kNext; },
      [](Scene&, View& v) { v.eye.y = kLeast; },
      [](Scene&, View& v) { v.target.z = kLeast; },
      [](Scene&, View& v) { v.up.z = kNext; },
      [](Scene&, View& v) { v.scale = kNext; },
      [](Scene&, View& v) { v.offset.x *= kNext; },
      [](Scene&, View& v) { v.window.min.y = kLeast; },
      [](Scene&, View& v) { v.window.max.x *= kNext; },
      [](Scene& s, View&) { s.vertices[3].x = std::nextafter(s.vertices[3].x, 100.0); },
      [](Scene& s, View&) { s.objects[1].precision = 1e-9; },
      [](Scene& s, View&) { s.corner_flags.assign(s.faces.corners().size(), ligne::kCornerInner); },
      [](Scene& s, View&) {
        s.materials = {{"glass", {1, 1, 1}, 0.5}}, s.face_material.assign(s.faces.size(), 0);
      },
      [](Scene& s, View&) {
        add_face(s, {{{0, 0, 20}, {1, 0, 20}, {0, 1, 20}}});
      }};
  std::set<std::string> names{answers_name(scene_, view_, 31, Glass::hides),
                              answers_name(scene_, view_, 30, Glass::is_clear)};
  for (const auto& change : changes) {
    Scene scene = scene_;
    View view = view_;
    change(scene, view);
    names.insert(answers_name(scene, view, 30, Glass::hides));
  }
  EXPECT_EQ(names.size(), changes.size() + 2);
}

}  // namespace
}  // namespace oracle
