// Every method that draws lines against every answer worked out by hand.

#include "compare.hpp"
#include "known_answer.hpp"
#include "main/script.hpp"
#include "main/tier.hpp"
#include "support/scenes.hpp"

namespace ligne::test {
namespace {

/// Roundings of a cross product and of the normalization before it.
constexpr double kDirectionRounding = 0x1p-50;

std::filesystem::path folder() { return std::filesystem::path(LIGNE_SOURCE_DIR) / "tests" / "known_answers"; }

std::vector<std::string> answer_names() {
  std::vector<std::string> names;
  for (const auto& file : known_answer_files(folder())) names.push_back(file.stem().string());
  return names;
}

std::vector<std::string> line_methods() {
  std::vector<std::string> names;
  for (const Method* method : all_methods()) {
    const MethodTraits& traits = method->traits();
    if ((traits.products & kStrokes) && traits.exact && traits.only_for.empty()) names.emplace_back(traits.name);
  }
  return names;
}

KnownAnswer answer_named(const std::string& name) { return read_known_answer(folder() / (name + ".json")); }

std::string text(const Point3& p) {
  std::ostringstream out;
  out << '(' << p.x << ", " << p.y << ", " << p.z << ')';
  return out.str();
}

std::vector<PageSegment> expected_segments(const KnownAnswer& answer, const View& view, bool with_hidden) {
  std::vector<PageSegment> segments;
  for (const KnownSegment& known : answer.segments) {
    if (!known.visible && !with_hidden) continue;
    const glm::dvec4 a = view.model_to_page * glm::dvec4(known.from, 1), b = view.model_to_page * glm::dvec4(known.to, 1);
    segments.push_back({{a.x / a.w, a.y / a.w},
                        {b.x / b.w, b.y / b.w},
                        a.z / a.w,
                        b.z / b.w,
                        known.line_class,
                        known.visible,
                        text(known.from) + " - " + text(known.to)});
  }
  return segments;
}

std::vector<PageSegment> drawn_segments(const Picture& picture) {
  std::vector<PageSegment> segments;
  const View& view = picture.projected.view;
  for (const Stroke& s : picture.model.strokes) {
    const Point2 a = picture.model.lattice.to_mm(s.from), b = picture.model.lattice.to_mm(s.to);
    segments.push_back({a, b, s.z_from, s.z_to, s.line_class, s.visible,
                        text(to_model_point(view, a, s.z_from)) + " - " + text(to_model_point(view, b, s.z_to))});
  }
  return segments;
}

bool same_direction(const Point3& unit, const Point3& direction) {
  return glm::length(glm::cross(unit, direction)) <= kDirectionRounding * glm::length(direction) &&
         glm::dot(unit, direction) > 0;
}

class KnownAnswers : public testing::TestWithParam<std::tuple<std::string, std::string>> {};

TEST_P(KnownAnswers, AreDrawn) {
  const KnownAnswer answer = answer_named(std::get<0>(GetParam()));
  SCOPED_TRACE(answer.about);
  PictureRequest request{answer.camera, answer.edges, false, 0, std::get<1>(GetParam())};
  for (const bool with_hidden : {false, true}) {
    if (with_hidden && !answer.with_hidden) continue;
    request.hidden = with_hidden;
    const Picture picture = draw(answer.scene, request);
    const CompareTolerance tolerance = tolerance_of_lattice(picture.projected.lattice.step_mm);
    const auto expected = expected_segments(answer, picture.projected.view, with_hidden);
    for (const std::string& difference : differences(expected, drawn_segments(picture), tolerance))
      ADD_FAILURE() << (with_hidden ? "with hidden lines: " : "") << difference;
    count_checks(Check::pairs);
  }
}

std::string parameter_name(const testing::TestParamInfo<std::tuple<std::string, std::string>>& info) {
  std::string name = std::get<0>(info.param) + "_by_" + std::get<1>(info.param);
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(All, KnownAnswers,
                         testing::Combine(testing::ValuesIn(answer_names()), testing::ValuesIn(line_methods())),
                         parameter_name);

/// The answers themselves.
class KnownAnswerFile : public testing::TestWithParam<std::string> {};

TEST_P(KnownAnswerFile, IsSound) {
  const KnownAnswer answer = answer_named(GetParam());
  EXPECT_FALSE(answer.segments.empty());
  const Camera camera = make_camera(answer.camera, answer.scene);
  EXPECT_TRUE(same_direction(camera.right, answer.right)) << "right on the page is " << text(camera.right);
  EXPECT_TRUE(same_direction(camera.down, answer.down)) << "down on the page is " << text(camera.down);
  const Picture picture = draw(answer.scene, {answer.camera, answer.edges, false, 0});
  const auto expected = expected_segments(answer, picture.projected.view, true);
  for (const std::string& overlap : overlaps(expected, tolerance_of_lattice(picture.projected.lattice.step_mm)))
    ADD_FAILURE() << overlap;
  const LineClasses selected = classes(answer.edges);
  for (const PageSegment& segment : expected) EXPECT_TRUE(selected.has(segment.line_class)) << segment.label;
}

/// The proof that the comparison can fail: whatever is changed in the answer, the drawing no longer agrees with it.
TEST_P(KnownAnswerFile, IsToTheLastCoordinate) {
  const KnownAnswer answer = answer_named(GetParam());
  const Picture picture = draw(answer.scene, {answer.camera, answer.edges, answer.with_hidden, 0});
  const CompareTolerance tolerance = tolerance_of_lattice(picture.projected.lattice.step_mm);
  const auto drawn = drawn_segments(picture);
  const auto expected = expected_segments(answer, picture.projected.view, answer.with_hidden);
  const auto notices = [&](std::size_t i, const std::string& what, auto change) {
    auto changed = expected;
    change(changed[i]);
    EXPECT_FALSE(differences(changed, drawn, tolerance).empty()) << what << ": " << expected[i].label;
  };
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const Point2 along = glm::normalize(expected[i].to - expected[i].from) * (3 * tolerance.end);
    notices(i, "longer", [&](PageSegment& s) { s.to += along; });
    notices(i, "shorter", [&](PageSegment& s) { s.to -= along; });
    notices(i, "turned", [&](PageSegment& s) { s.from += Point2{-along.y, along.x}; });
    notices(i, "nearer", [&](PageSegment& s) { s.z_from -= 1; });
    notices(i, "other class",
            [&](PageSegment& s) { s.line_class = s.line_class == LineClass::crease ? LineClass::mesh : LineClass::crease; });
    notices(i, "other visibility", [&](PageSegment& s) { s.visible = !s.visible; });
    auto without = expected;
    without.erase(without.begin() + static_cast<std::ptrdiff_t>(i));
    EXPECT_FALSE(differences(without, drawn, tolerance).empty()) << "without: " << expected[i].label;
  }
}

INSTANTIATE_TEST_SUITE_P(All, KnownAnswerFile, testing::ValuesIn(answer_names()),
                         [](const auto& info) { return info.param; });

// The comparison must find whatever is wrong with a drawing, and nothing else.

constexpr double kStep = 0x1p-17;  // the lattice of an A4 sheet, mm
const CompareTolerance kTolerance = tolerance_of_lattice(kStep);

PageSegment segment(Point2 from, Point2 to, LineClass line_class = LineClass::outline, bool visible = true) {
  return {from, to, 0, 0, line_class, visible, "s"};
}

/// A triangle whose lower side is a border, and a hidden crease in it.
std::vector<PageSegment> picture() {
  return {segment({10, 10}, {110, 10}, LineClass::border), segment({110, 10}, {60, 90}), segment({60, 90}, {10, 10}),
          segment({60, 90}, {60, 10}, LineClass::crease, false)};
}

std::vector<std::string> found(const std::vector<PageSegment>& drawn) { return differences(picture(), drawn, kTolerance); }

/// One message that begins with the word.
void expect_only(const std::vector<std::string>& messages, const std::string& word) {
  ASSERT_EQ(messages.size(), 1u) << testing::PrintToString(messages);
  EXPECT_EQ(messages[0].substr(0, word.size()), word);
}

TEST(Compare, ToleranceIsAFewSteps) {
  EXPECT_NEAR(kTolerance.line / kStep, std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(kTolerance.end / kStep, 5 / std::sqrt(2.0), 1e-12);
  EXPECT_LT(kTolerance.end, 30e-6) << "thirty nanometres on A4";
}

TEST(Compare, FindsNothingWhereNothingIsWrong) { EXPECT_EQ(found(picture()), std::vector<std::string>{}); }

TEST(Compare, DirectionOrderAndPiecesDoNotMatter) {
  const std::vector<PageSegment> drawn = {
      segment({60, 10}, {60, 90}, LineClass::crease, false), segment({60, 10}, {110, 10}, LineClass::border),
      segment({10, 10}, {60, 10}, LineClass::border), segment({60, 90}, {110, 10}), segment({10, 10}, {60, 90})};
  EXPECT_EQ(found(drawn), std::vector<std::string>{});
  // The answer in pieces and the drawing in one.
  EXPECT_EQ(differences(drawn, picture(), kTolerance), std::vector<std::string>{});
}

TEST(Compare, PiecesOfTheAnswerMayComeInAnyOrder) {
  const std::vector<PageSegment> answer = {segment({0, 0}, {10, 20}), segment({30, 60}, {40, 80}),
                                           segment({30, 60}, {20, 40}), segment({10, 20}, {20, 40})};
  EXPECT_EQ(differences(answer, {segment({0, 0}, {40, 80})}, kTolerance), std::vector<std::string>{});
  expect_only(differences(answer, {segment({0, 0}, {35, 70})}, kTolerance), "missing");
}

TEST(Compare, RoundingIsNoDifference) {
  auto drawn = picture();
  drawn[0].from += Point2{0.5, 0.5} * kStep;
  drawn[1].to += Point2{-0.5, 0.5} * kStep;
  drawn[3].to += Point2{0, 3} * kStep;  // along the line
  EXPECT_EQ(found(drawn), std::vector<std::string>{});
}

/// A change of the drawing of the picture, made to each of its segments in turn or to one, and how its messages begin.
struct Change {
  const char* name;
  std::function<void(std::vector<PageSegment>& drawn, std::size_t i)> make;
  std::vector<std::string> messages;
  bool to_each = true;
};

TEST(Compare, EveryChangeIsFound) {
  const std::vector<std::string> lost{"missing"}, extra{"not expected"}, both{"not expected", "missing"}, twice{"twice"};
  const auto one_more = [&](const PageSegment& more) {
    return [=](std::vector<PageSegment>& drawn, std::size_t) { drawn.push_back(more); };
  };
  const auto shift = [](auto& d, std::size_t i) { d[i].from += Point2{6, 6} * kStep, d[i].to += Point2{6, 6} * kStep; };
  const auto gap = [&](auto& drawn, std::size_t) {
    drawn[0].to = {50, 10};
    drawn.push_back(segment({50.0001, 10}, {110, 10}, LineClass::border));
  };
  const Change changes[] = {
      {"missing", [](auto& drawn, std::size_t i) { drawn.erase(drawn.begin() + static_cast<std::ptrdiff_t>(i)); }, lost},
      {"shifted", shift, both},
      {"another class", [](auto& drawn, std::size_t i) { drawn[i].line_class = LineClass::mesh; }, both},
      {"another visibility", [](auto& drawn, std::size_t i) { drawn[i].visible = !drawn[i].visible; }, both},
      {"one more", one_more(segment({20, 20}, {30, 20})), extra, false},
      {"beyond an end", one_more(segment({110, 10}, {120, 10}, LineClass::border)), extra, false},
      {"a short one", one_more(segment({60, 90}, {60.001, 90})), extra, false},
      {"a hidden one", one_more(segment({35, 50}, {85, 50}, LineClass::mesh, false)), extra, false},
      {"too short", [](auto& drawn, std::size_t) { drawn[0].to.x -= 5 * kStep; }, lost, false},
      {"too long", [](auto& drawn, std::size_t) { drawn[0].to.x += 5 * kStep; }, both, false},
      {"turned", [](auto& drawn, std::size_t) { drawn[0].to.y += 3 * kStep; }, both, false},
      {"a gap", gap, lost, false},
      {"at another depth", [](auto& drawn, std::size_t) { drawn[1].z_to = 1; }, both, false},
      {"drawn twice", one_more(picture()[1]), twice, false},
      {"a piece twice", one_more(segment({20, 10}, {20.001, 10}, LineClass::border)), twice, false},
  };
  for (const Change& change : changes)
    for (std::size_t i = 0; i < (change.to_each ? picture().size() : 1); ++i) {
      auto drawn = picture();
      change.make(drawn, i);
      const std::vector<std::string> messages = found(drawn);
      ASSERT_EQ(messages.size(), change.messages.size()) << change.name << ", " << i << testing::PrintToString(messages);
      for (std::size_t k = 0; k < messages.size(); ++k)
        EXPECT_TRUE(messages[k].starts_with(change.messages[k])) << change.name << ", " << i << ": " << messages[k];
    }
}

TEST(Compare, DepthsAreComparedAlongASlope) {
  auto expected = picture(), drawn = picture();
  for (auto* lines : {&expected, &drawn}) (*lines)[1].z_from = -40, (*lines)[1].z_to = 60;
  EXPECT_EQ(differences(expected, drawn, kTolerance), std::vector<std::string>{});
  std::swap(drawn[1].z_from, drawn[1].z_to);
  EXPECT_EQ(differences(expected, drawn, kTolerance).size(), 2u);
}

TEST(Compare, OverlapsOfTwoClassesAreFound) {
  const std::vector<PageSegment> lines = {segment({0, 0}, {10, 5}), segment({4, 2}, {20, 10}, LineClass::crease, false)};
  expect_only(overlaps(lines, kTolerance), "twice");
}

TEST(Compare, LinesThatMeetOrCrossOrPartAreNoOverlap) {
  const std::vector<PageSegment> lines = {segment({0, 0}, {10, 0}), segment({10, 0}, {20, 0}), segment({5, -5}, {5, 5}),
                                          segment({0, 0}, {20, 0.001}), segment({0, 1}, {10, 1})};
  EXPECT_EQ(overlaps(lines, kTolerance), std::vector<std::string>{});
}

TEST(Compare, LinesAtTwoDepthsAreNotJoined) {
  // On the page one straight line, in space two.
  auto near = segment({0, 0}, {10, 0}), far = segment({10, 0}, {20, 0});
  far.z_from = far.z_to = 30;
  EXPECT_EQ(differences({near, far}, {far, near}, kTolerance), std::vector<std::string>{});
  EXPECT_EQ(differences({near, far}, {segment({0, 0}, {20, 0})}, kTolerance).size(), 3u);
}

// The reader of the answers.

/// Reads the JSON as the file of an answer; the error without the name of the file.
std::string read_answer(const std::string& json) {
  const TemporaryFolder folder;
  folder.write("A.json", json);
  try {
    return std::to_string(read_known_answer(folder / "A.json").segments.size());
  } catch (const KnownAnswerError& error) {
    const std::string what = error.what();
    throw KnownAnswerError(what.substr(what.find("A.json: ") + 8));
  }
}

[[maybe_unused]] const bool readings_are_added =
    add_function_scripts(LIGNE_SOURCE_DIR "/tests/known_answers/values", {{"answer", read_answer}});

}  // namespace
}  // namespace ligne::test
