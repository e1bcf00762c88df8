/// The surfaces behind the mesh in the JSON drawing. More of them: scripts/shapes.txt.

#include "draw_program.hpp"
#include "patches/part_scenes.hpp"

namespace ligne::test {
namespace {

class SurfacesTest : public DrawTest {
 protected:
  void SetUp() override {
    DrawTest::SetUp();
    write("plate.obj", obj_of(bored_plate(2.5, 4)));
    write("ball.obj", obj_of(ball()));
  }
};

TEST_F(SurfacesTest, TheDrawingHasTheBoresOfAPlate) {
  const json drawing = drawn("plate.obj --up-axis z");
  EXPECT_EQ(drawing["version"], 2);
  const json& surfaces = drawing["surfaces"];
  ASSERT_EQ(surfaces.size(), 2u);
  std::set<int> radii;
  for (const json& s : surfaces) {
    EXPECT_EQ(s["kind"], "cylinder");
    EXPECT_EQ(s["outward"], false);
    EXPECT_EQ(s["turn"], 360);
    EXPECT_EQ(s["faces"], kBoreFacets);
    EXPECT_EQ(s["object"], 0);
    EXPECT_NEAR(s["along"][1].get<double>() - s["along"][0].get<double>(), 5, 1e-5);
    radii.insert(static_cast<int>(std::lround(s["radius"].get<double>() * 10)));
  }
  EXPECT_EQ(radii, (std::set<int>{25, 40}));
  // Each rim lies between a plane and a bore; both ends of its strokes are as far from the axis as the radius.
  std::size_t rims = 0;
  for (const json& stroke : drawing["strokes"]) {
    const json& of_faces = stroke["source"]["surfaces"];
    ASSERT_EQ(of_faces.size(), 2u);
    for (const json& number : of_faces) {
      if (number.is_null()) continue;
      const json& s = surfaces.at(number.get<std::size_t>());
      for (const json& end : stroke["source"]["ends"]) {
        const double away =
            std::hypot(end[0].get<double>() - s["at"][0].get<double>(), end[1].get<double>() - s["at"][1].get<double>());
        EXPECT_NEAR(away, s["radius"].get<double>(), 1e-4);
      }
      ++rims;
    }
  }
  EXPECT_GE(rims, 2u * kBoreFacets) << "the upper rims are seen whole";
}

TEST_F(SurfacesTest, PlotReadsThem) {
  json drawing = drawn("plate.obj ball.obj --hidden dashed");
  write("with.json", drawing.dump());
  drawing.erase("surfaces");
  for (json& stroke : drawing["strokes"]) stroke["source"].erase("surfaces");
  write("without.json", drawing.dump());
  for (const char* name : {"with", "without"}) {
    const Outcome outcome = run_well({"plot", std::string(name) + ".json", "-o", std::string(name) + ".svg"});
    EXPECT_EQ(outcome.err, "");
  }
  EXPECT_EQ(contents(file("with.svg")), contents(file("without.svg")));
  EXPECT_NE(contents(file("with.svg")).find("<path"), std::string::npos);
}

}  // namespace
}  // namespace ligne::test
