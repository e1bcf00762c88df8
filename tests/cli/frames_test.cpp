/// Successive views: --frames, --turn.

#include <cmath>
#include <filesystem>
#include <set>

#include "draw_program.hpp"
#include "support/pdf_info.hpp"

namespace ligne::test {
namespace {

/// Of the matrix from the model to the page.
double matrix(const json& drawing, int row, int column) {
  return drawing["view"]["matrix"][static_cast<std::size_t>(4 * row + column)].get<double>();
}

class FramesTest : public DrawTest {
 protected:
  std::string refusal(std::vector<std::string> options) const {
    options.insert(options.begin(), {"draw", "cube.obj", "-q"});
    const Outcome outcome = run(options);
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(new_files(), std::vector<std::string>());
    return outcome.err;
  }
  json frame(const std::string& name) const { return json::parse(contents(file(name))); }
};

TEST_F(FramesTest, HaveNumberedNames) {
  EXPECT_EQ(run({"draw", "cube.obj", "--frames", "3", "-o", "f%02d.svg"}).status, 0);
  EXPECT_EQ(run({"draw", "cube.obj", "--frames", "2", "-o", "100%-g%d.pdf"}).status, 0);
  EXPECT_EQ(new_files(), std::vector<std::string>({"100%-g1.pdf", "100%-g2.pdf", "f01.svg", "f02.svg", "f03.svg"}));
}

TEST_F(FramesTest, NeedAPlaceForTheNumber) {
  EXPECT_EQ(refusal({"--frames", "3", "-o", "f.svg"}),
            "ligne: --output: 'f.svg' has no place for the number of a frame: name%03d; only a PDF holds them all\n");
  EXPECT_EQ(refusal({"--frames", "3", "-o", "f%d-%d.svg"}),
            "ligne: --output: 'f%d-%d.svg' has two places for the number of a frame\n");
  EXPECT_EQ(refusal({"--frames", "1", "-o", "f%d.svg"}), "ligne: --frames: \"1\" is not a whole number from 2 to 100000\n");
  EXPECT_EQ(refusal({"--turn", "30", "-o", "f.svg"}), "ligne: --turn requires --frames\n");
  EXPECT_EQ(refusal({"--frames", "3", "--report", "-o", "f%d.svg"}), "ligne: --report: is of one view\n");
}

TEST_F(FramesTest, ArePagesOfOnePdf) {
  ASSERT_EQ(run({"draw", "cube.obj", "--frames", "5", "-o", "f.pdf"}).status, 0);
  const std::string pdf = contents(file("f.pdf"));
  EXPECT_EQ(pdf.substr(0, 5), "%PDF-");
  if (!pdf_info_is_there()) GTEST_SKIP() << "pdfinfo (poppler-utils) is not here";
  EXPECT_NE(pdf_info(pdf).find("Pages:           5\n"), std::string::npos);
}

/// The statistics say what was made once.
TEST_F(FramesTest, TellWhatWasSaved) {
  const auto counts = [&](const std::string& method) {
    EXPECT_EQ(run({"draw", "cube.obj", "--frames", "4", "--turn", "12", "--method", method, "--stats-json", "s.json", "-o",
                   "f%d.svg"})
                  .status,
              0);
    return json::parse(contents(file("s.json")))["counts"];
  };
  const json appel = counts("appel"), bsp = counts("bsp"), newell = counts("newell");
  for (const json& method : {appel, bsp, newell}) EXPECT_EQ(method["of them with the topology of the first"], 3);
  EXPECT_EQ(bsp["of them with the tree of the first"], 3);
  EXPECT_FALSE(appel.contains("of them with the tree of the first"));
  EXPECT_EQ(newell["of them with the list of the one before"], 3);
  ASSERT_EQ(run({"draw", "cube.obj", "--method", "bsp", "--stats-json", "s.json", "-o", "f.svg"}).status, 0);
  EXPECT_EQ(bsp["depth of the tree"], json::parse(contents(file("s.json")))["counts"]["depth of the tree"]);
}

/// The cube has the same sides after a quarter of a turn; in between it is wider, and has the same scale.
TEST_F(FramesTest, TurnTheModelAtOneScale) {
  ASSERT_EQ(run({"draw", "cube.obj", "--view", "front", "--frames", "8", "--edges", "all", "-o", "f%d.json"}).status, 0);
  const json first = frame("f1.json");
  for (int i = 2; i <= 8; ++i) {
    const json other = frame("f" + std::to_string(i) + ".json");
    EXPECT_EQ(other["page"], first["page"]);
    for (const int row : {0, 1}) {
      const auto length = [&](const json& drawing) {
        double sum = 0;
        for (int k = 0; k < 3; ++k) sum += std::pow(matrix(drawing, row, k), 2);
        return std::sqrt(sum);
      };
      EXPECT_NEAR(length(other), length(first), 1e-9);
    }
    EXPECT_EQ(strokes_by_class(other), strokes_by_class(i % 2 == 1 ? first : frame("f2.json"))) << i;
  }
}

/// Counter-clockwise as seen from above: what is in front goes to the right.
TEST_F(FramesTest, TurnToTheRight) {
  ASSERT_EQ(run({"draw", "cube.obj", "--view", "front", "--frames", "2", "--turn", "60", "-o", "f%d.json"}).status, 0);
  const json drawing = frame("f2.json");
  // The y axis is up, and the viewer stands at +z.
  const double right = matrix(drawing, 0, 2), scale = matrix(drawing, 0, 0);
  EXPECT_GT(right, 0);
  EXPECT_NEAR(right / scale, std::tan(30 * 3.14159265358979 / 180), 1e-9);
}

/// Neither a compiled tree nor the work that all views share changes what is drawn.
TEST_F(FramesTest, AreTheViewsOneByOne) {
  const auto pieces = [](const json& drawing) {
    std::multiset<std::string> found;
    for (const json& stroke : drawing["strokes"]) {
      const json& interval = stroke["interval"];
      found.insert(stroke["class"].get<std::string>() + " " + stroke["source"].dump() + " " +
                   std::to_string(interval[0].get<double>()) + " " + std::to_string(interval[1].get<double>()));
    }
    return found;
  };
  const std::string model = (std::filesystem::path(LIGNE_SOURCE_DIR) / "tests/corpus/letter_e.json").string();
  for (const std::string method : {"appel", "bsp", "convex-tree", "newell", "atherton-weiler"}) {
    ASSERT_EQ(run({"draw", model, "--direction", "2,3,-1", "--frames", "4", "--method", method, "-o", "f%d.json"}).status,
              0);
    const char* const directions[] = {"2,3,-1", "3,-2,-1", "-2,-3,-1", "-3,2,-1"};
    for (int i = 0; i < 4; ++i) {
      EXPECT_EQ(pieces(frame("f" + std::to_string(i + 1) + ".json")),
                pieces(drawn({model, "--direction=" + std::string(directions[i]), "--method", method})))
          << method << " " << i;
    }
  }
}

}  // namespace
}  // namespace ligne::test
