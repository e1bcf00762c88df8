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

}  // namespace
}  // namespace ligne::test
