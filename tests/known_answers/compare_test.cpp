// The comparison must find whatever is wrong with a drawing, and nothing else.

#include <nlohmann/json.hpp>

#include "compare.hpp"
#include "known_answer.hpp"
#include "support/test.hpp"

namespace ligne::test {
namespace {

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

using nlohmann::json;

json square() {
  return json::parse(R"({
    "about": "a square from the front",
    "reasoning": ["All four sides are borders, and nothing is before them."],
    "view": {"name": "front", "right": [1, 0, 0], "down": [0, 0, -1]},
    "edges": "feature",
    "scene": {"format": "ligne-scene", "version": 1,
      "objects": [{"vertices": [[0, 0, 0], [1, 0, 0], [1, 0, 1], [0, 0, 1]], "faces": [{"outer": [0, 1, 2, 3]}]}]},
    "visible": {"border": [[[0, 0, 0], [1, 0, 0]], [[1, 0, 0], [1, 0, 1]], [[1, 0, 1], [0, 0, 1]], [[0, 0, 1], [0, 0, 0]]]},
    "hidden": {"crease": [[[0, 0, 0], [1, 0, 1]]]}
  })");
}

std::string error_of(const json& document) {
  try {
    parse_known_answer(document.dump(), "A", {});
  } catch (const KnownAnswerError& error) {
    return error.what();
  }
  return "no error";
}

TEST(KnownAnswerReader, SaysWhatIsWrong) {
  const auto with = [](const char* pointer, const json& value) {
    json document = square();
    document[json::json_pointer(pointer)] = value;
    return document;
  };
  EXPECT_EQ(error_of(with("/note", "x")), "A: the file: unknown key 'note'");
  EXPECT_EQ(error_of(with("/reasoning", json::array())), "A: reasoning: is empty");
  EXPECT_EQ(error_of(with("/view/name", "north")), "A: view.name: there is no view 'north'");
  EXPECT_EQ(error_of(with("/view/direction", {0, 1, 0})), "A: view: needs one of 'name', 'direction' and 'eye'");
  EXPECT_EQ(error_of(with("/edges", "outline,rim")), "A: there is no class 'rim'");
  EXPECT_EQ(error_of(with("/hidden/rim", json::parse("[[[0,0,0],[1,0,1]]]"))), "A: there is no class 'rim'");
  EXPECT_EQ(error_of(with("/visible/border/0/1", {0, 0, 0})), "A: visible.border: [[0,0,0],[0,0,0]] has no length");
  EXPECT_EQ(error_of(with("/visible/border/0/1", {0, 0})), "A: visible.border: is not a point [x, y, z]");
  EXPECT_EQ(error_of(with("/scene/objects/0/vertices/0", {0, 1, 0})), "A: scene: had to be mended");
  json document = square();
  document.erase("visible");
  EXPECT_EQ(error_of(document), "A: key 'visible' is missing");
}

}  // namespace
}  // namespace ligne::test
