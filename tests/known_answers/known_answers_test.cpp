// Every method that draws lines against every answer worked out by hand.

#include "compare.hpp"
#include "known_answer.hpp"
#include "main/checks.hpp"
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

}  // namespace
}  // namespace ligne::test
