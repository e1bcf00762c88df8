/// Successive views: --frames, --turn. More of them: scripts/profile.txt.

#include "draw_program.hpp"
#include "support/pdf_info.hpp"
#include "support/standard.hpp"

namespace ligne::test {
namespace {

/// A number of the matrix from the model to the page.
double matrix(const json& drawing, int row, int column) {
  return drawing["view"]["matrix"][static_cast<std::size_t>(4 * row + column)].get<double>();
}

class FramesTest : public DrawTest {
 protected:
  json frame(const std::string& name) const { return json::parse(contents(file(name))); }
};

TEST_F(FramesTest, ArePagesOfOnePdf) {
  run_well("draw cube.obj --frames 5 -o f.pdf");
  const std::string pdf = contents(file("f.pdf"));
  EXPECT_EQ(pdf.substr(0, 5), "%PDF-");
  if (!pdf_info_is_there()) GTEST_SKIP() << "pdfinfo (poppler-utils) is not here";
  EXPECT_NE(pdf_info(pdf).find("Pages:           5\n"), std::string::npos);
}

/// The cube has the same sides after a quarter of a turn; in between it is wider, and has the same scale.
TEST_F(FramesTest, TurnTheModelAtOneScale) {
  run_well("draw cube.obj --view front --frames 8 --edges all -o f%d.json");
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
    run_well({"draw", model, "--direction", "2,3,-1", "--frames", "4", "--method", method, "-o", "f%d.json"});
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
