/// Successive views: --frames, --turn; surfaces among models.

#include "draw_program.hpp"
#include "support/pdf_info.hpp"
#include "support/standard.hpp"
#include "surface_program.hpp"

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

/// The statistics say what was made once.
TEST_F(FramesTest, TellWhatWasSaved) {
  const auto counts = [&](const std::string& method) {
    run_well({"draw", "cube.obj", "--frames", "4", "--turn", "12", "--method", method, "--stats-json", "s.json", "-o",
              "f%d.svg"});
    return json::parse(contents(file("s.json")))["counts"];
  };
  const json appel = counts("appel"), bsp = counts("bsp"), newell = counts("newell");
  for (const json& method : {appel, bsp, newell}) EXPECT_EQ(method["of these, with the topology of the first"], 3);
  EXPECT_EQ(bsp["of these, with the tree of the first"], 3);
  EXPECT_FALSE(appel.contains("of these, with the tree of the first"));
  EXPECT_EQ(newell["of these, with the list of the previous one"], 3);
  run_well("draw cube.obj --method bsp --stats-json s.json -o f.svg");
  EXPECT_EQ(bsp["depth of the tree"], json::parse(contents(file("s.json")))["counts"]["depth of the tree"]);
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

/// Counter-clockwise as seen from above: what is in front goes to the right.
TEST_F(FramesTest, TurnToTheRight) {
  run_well("draw cube.obj --view front --frames 2 --turn 60 -o f%d.json");
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
    run_well({"draw", model, "--direction", "2,3,-1", "--frames", "4", "--method", method, "-o", "f%d.json"});
    const char* const directions[] = {"2,3,-1", "3,-2,-1", "-2,-3,-1", "-3,2,-1"};
    for (int i = 0; i < 4; ++i) {
      EXPECT_EQ(pieces(frame("f" + std::to_string(i + 1) + ".json")),
                pieces(drawn({model, "--direction=" + std::string(directions[i]), "--method", method})))
          << method << " " << i;
    }
  }
}

/// Surfaces among the models of `ligne draw`.

using nlohmann::json;

class MixedSceneTest : public SurfaceProgramTest {
 protected:
  /// A box of 2 x 2 from z = -1 to 1 round the origin.
  void write_box(const std::string& name, bool y_up) const {
    std::string obj;
    for (const int z : {-1, 1}) {
      for (const auto& [x, y] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
        obj += "v " + std::to_string(x) + " " + std::to_string(y_up ? z : y) + " " + std::to_string(y_up ? -y : z) + "\n";
      }
    }
    write(name, obj + "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n");
  }
  json mixed(const Words& arguments) const {
    const Outcome outcome = run_well("draw" + arguments + "-o - --format json");
    return outcome.status == 0 ? json::parse(outcome.out) : json();
  }
};

TEST_F(MixedSceneTest, CurvesAndModelsHideEachOtherAndMeetInAFootLine) {
  // A box that stands half in a plane of 6 x 6, seen from above: its top hides 2 x 2 of the plane's curves.
  for (const bool y_up : {false, true}) {
    write_box("box.obj", y_up);
    const Words scene{"box.obj", "--surface", "0", "-x", "-3:3:7", "-y", "-3:3:7", "--up-axis", y_up ? "y" : "z"};
    const json above = mixed(scene + "--view top --quality exact");
    EXPECT_NEAR(length(above, "horizon"), 14 * 6 - 2 * 2 - 8, 1e-3)
        << "the curves below the box and its outline are not seen";
    EXPECT_NEAR(length(above, "outline") + length(above, "crease"), 8, 1e-3);
    // From the front and above the foot line is seen on two sides of four.
    const json iso = mixed(scene + "--view iso");
    EXPECT_GT(length(iso, "intersection"), 1);
    EXPECT_GT(length(iso, "horizon"), 30);
  }
}

// [Boulle1980] figure 1.1 has curved surfaces among plane ones. A plane in u and v is that in x and y; a ball round the box
// hides all of it.
TEST_F(MixedSceneTest, ParametricSurfacesStandAmongModels) {
  write_box("box.obj", false);
  for (const char* view : {"--view top", "--view iso"}) {
    const Words end = Words{"--up-axis", "z", "--quality", "exact"} + view;
    const json plane = mixed(Words{"box.obj", "--surface", "0", "-x", "-3:3:7", "-y", "-3:3:7"} + end);
    const json same = mixed(Words{"box.obj", "--parametric", "u", "v", "0", "-u", "-3:3:7", "-v", "-3:3:7"} + end);
    for (const char* layer : {"horizon", "outline", "border", "crease", "intersection"})
      EXPECT_NEAR(length(same, layer), length(plane, layer), 1e-3) << layer;
  }
  const Words ball{"box.obj", "--parametric", "2*cos(u)*cos(v)", "2*sin(u)*cos(v)", "2*sin(v)", "-v", "-pi/2:pi/2:9"};
  EXPECT_EQ(length(mixed(ball + "--view iso"), "crease"), 0);
}

TEST_F(MixedSceneTest, FormulasTakeTheGroundOfTheModels) {
  write_box("box.obj", false);
  const json above = mixed("box.obj --up-axis z --surface 5 --view top");
  // The box's outline lies under the rim of the surface, and stands for it.
  EXPECT_NEAR(length(above, "horizon") + length(above, "outline"), 80 * 2, 1e-3);
  EXPECT_EQ(length(above, "crease"), 0);
}

}  // namespace
}  // namespace ligne::test
