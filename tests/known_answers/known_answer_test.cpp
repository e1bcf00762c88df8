// The reader of the answers.

#include "known_answer.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace ligne::test {
namespace {

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

TEST(KnownAnswerReader, ReadsWhatIsThere) {
  const KnownAnswer answer = parse_known_answer(square().dump(), "A", {});
  EXPECT_EQ(answer.name, "A");
  EXPECT_EQ(answer.reasoning.size(), 1u);
  EXPECT_EQ(answer.camera.named_view, "front");
  EXPECT_EQ(answer.edges, "feature");
  EXPECT_EQ(answer.scene.faces.size(), 1u);
  EXPECT_TRUE(answer.with_hidden);
  ASSERT_EQ(answer.segments.size(), 5u);
  EXPECT_EQ(answer.segments[1].to, (Point3{1, 0, 1}));
  EXPECT_EQ(answer.segments[1].line_class, LineClass::border);
  EXPECT_TRUE(answer.segments[1].visible);
  EXPECT_EQ(answer.segments[4].line_class, LineClass::crease);
  EXPECT_FALSE(answer.segments[4].visible);
}

TEST(KnownAnswerReader, ReadsAPerspectiveView) {
  json document = square();
  document["view"] =
      json::parse(R"({"eye": [0, -9, 0], "target": [0, 0, 0], "fov": 60, "right": [1, 0, 0], "down": [0, 0, -1]})");
  const KnownAnswer answer = parse_known_answer(document.dump(), "A", {});
  ASSERT_TRUE(answer.camera.eye && answer.camera.target);
  EXPECT_EQ(*answer.camera.eye, (Point3{0, -9, 0}));
  EXPECT_EQ(answer.camera.fov_degrees, 60);
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
