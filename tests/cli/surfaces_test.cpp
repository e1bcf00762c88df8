/// The surfaces behind the mesh in the JSON drawing, and what `ligne info` says of them.

#include "draw_program.hpp"
#include "patches/part_scenes.hpp"

namespace ligne::test {
namespace {

class SurfacesTest : public DrawTest {
 protected:
  void SetUp() override {
    DrawTest::SetUp();
    write("plate.obj", obj_of(bored_plate(2.5, 4)));
    write("turned.obj", obj_of(turned_part()));
    write("ball.obj", obj_of(ball()));
  }

  json info_of(const Words& models) const {
    const Outcome outcome = run_well("info --json" + models);
    return json::parse(outcome.out)["scene"];
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

TEST_F(SurfacesTest, TheDrawingHasOtherKinds) {
  std::map<std::string, json> by_kind;
  const json drawing = drawn("turned.obj ball.obj");
  for (const json& s : drawing["surfaces"]) by_kind[s["kind"].get<std::string>()] = s;
  ASSERT_EQ(by_kind.size(), 4u);
  EXPECT_NEAR(by_kind["cone"]["slope"].get<double>(), -0.5, 1e-4);
  EXPECT_NEAR(by_kind["torus"]["tube"].get<double>(), 2, 1e-4);
  EXPECT_NEAR(by_kind["torus"]["radius"].get<double>(), 8, 1e-4);
  EXPECT_FALSE(by_kind["torus"].contains("turn"));
  EXPECT_FALSE(by_kind["sphere"].contains("axis"));
  EXPECT_EQ(by_kind["sphere"]["object"], 1) << "the ball is the second object";
  EXPECT_EQ(by_kind["sphere"]["outward"], true);
  EXPECT_NEAR(by_kind["sphere"]["at"][2].get<double>(), 3, 1e-4) << "the centre";
  EXPECT_NEAR(by_kind["torus"]["at"][2].get<double>(), 5, 1e-4);
}

TEST_F(SurfacesTest, DrawingsWithoutThemSayNothing) {
  for (const Words& arguments :
       std::vector<Words>{{"cube.obj"}, {"plate.obj", "--quality", "exact"}, {"plate.obj", "--edges", "outline"}}) {
    const json drawing = drawn(arguments);
    EXPECT_FALSE(drawing.contains("surfaces")) << arguments[0];
    for (const json& stroke : drawing["strokes"]) EXPECT_FALSE(stroke["source"].contains("surfaces"));
  }
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

TEST_F(SurfacesTest, InfoCountsThem) {
  const json surfaces = info_of("plate.obj turned.obj ball.obj")["surfaces"];
  EXPECT_EQ(surfaces["cylinders"], 3);
  EXPECT_EQ(surfaces["bores"], 2);
  EXPECT_EQ(surfaces["bosses"], 1);
  EXPECT_EQ(surfaces["arcs"], 0);
  EXPECT_EQ(surfaces["cones"], 1);
  EXPECT_EQ(surfaces["spheres"], 1);
  EXPECT_EQ(surfaces["tori"], 1);
  EXPECT_EQ(surfaces["groups"][0], json::parse(R"({"kind":"cylinder","outward":false,"arc":false,"radius":2.5,"count":1})"));
  EXPECT_FALSE(info_of("cube.obj").contains("surfaces"));
  const Outcome exact = run_well("info plate.obj --quality exact");
  EXPECT_EQ(exact.out.find("surfaces"), std::string::npos);
}

TEST_F(SurfacesTest, InfoPutsEqualRadiiTogether) {
  write("same.obj", obj_of(bored_plate(2.5, 2.5)));
  const std::string text = run("info same.obj turned.obj").out;
  expect_parts(text, {"\n  surfaces       2 bores, 1 boss, 1 cone, 1 torus\n                 2 bores, radius 2.5\n",
                      " 1 boss, radius 6\n", " 1 convex cone, 26.565", " degrees from the axis\n",
                      " 1 hollow torus, radius of the tube 2\n"});
  write("box.obj", obj_of(rounded_box({8, 6, 4}, 6)));
  expect_parts(run({"info", "box.obj"}).out, {"  surfaces       12 arcs of cylinders, 8 spheres\n"
                                              "                 12 convex arcs, radius 1\n"
                                              "                 8 convex spheres, radius 1\n"});
}

TEST_F(SurfacesTest, InfoEndsAListThatIsLong) {
  Words arguments = "info";
  for (int i = 0; i < 12; ++i) {
    const std::string name = "plate" + std::to_string(i) + ".obj";
    write(name, obj_of(bored_plate(2 + 0.25 * i, 2 + 0.25 * (i % 11))));
    arguments.push_back(name);
  }
  const std::string text = run(arguments).out;
  expect_parts(text, {"  surfaces       24 bores\n", " 3 bores, radius 2\n", " 2 bores, radius 2.25\n",
                      "                 and 2 more\n"});
  EXPECT_EQ(count_of(text, " bores, radius "), 10u);
}

}  // namespace
}  // namespace ligne::test
