/// Every option of `ligne draw`, by what it changes.

#include "patches/part_scenes.hpp"
#include "program.hpp"

namespace ligne::test {
namespace {

/// A cube behind a plate: its far edges are behind two faces of its own and the plate.
TEST_F(DrawTest, HiddenLinesBehindFewFaces) {
  write("behind.obj", contents(file("cube.obj")) + "v -30 -30 40\nv 5 -30 40\nv 5 30 40\nv -30 30 40\nf 9 10 11 12\n");
  const auto hidden = [](const json& drawing) {
    std::map<unsigned, double> length;  // by number of faces before it, mm
    for (const json& s : drawing["strokes"]) {
      const auto from = s["points"][0], to = s["points"][1];
      const unsigned faces = s["visible"].get<bool>() ? 0u : s.value("hidden_by", 0u);
      length[faces] += std::hypot(from[0].get<double>() - to[0].get<double>(), from[1].get<double>() - to[1].get<double>());
    }
    return length;
  };
  const Words scene{"behind.obj", "--view", "dimetric", "--quality", "exact", "--method", "appel"};
  const std::map<unsigned, double> all = hidden(drawn(scene + "--hidden dashed --set propagate=test"));
  ASSERT_EQ(all.size(), 3u) << "seen, behind one face, behind two";
  for (const char* how : {"test", "count", "nature", "path"}) {
    for (const unsigned most : {1u, 2u, 3u}) {
      std::map<unsigned, double> few = all;
      std::erase_if(few, [&](const auto& entry) { return entry.first > most; });
      const auto found = hidden(
          drawn(scene + Words{"--hidden", "dashed:" + std::to_string(most), "--set", std::string("propagate=") + how}));
      ASSERT_EQ(found.size(), few.size()) << how;
      for (const auto& [faces, length] : few) EXPECT_NEAR(found.at(faces), length, kMicrometre) << how << ", " << faces;
    }
  }
  // Counted without being asked to.
  EXPECT_EQ(hidden(drawn("behind.obj --view dimetric --quality exact --hidden solid:1")).size(), 2u);
}

/// The faces before each hidden stroke stand in the file, as many as it is hidden by.
TEST_F(DrawTest, HidingFacesOfStrokes) {
  const json drawing = drawn("cube.obj square.obj --view dimetric --hidden dashed --method appel --set propagate=nature");
  std::size_t hidden = 0;
  for (const json& s : drawing["strokes"]) {
    EXPECT_EQ(s.contains("hiding_faces"), !s["visible"].get<bool>());
    if (!s.contains("hiding_faces")) continue;
    ++hidden;
    EXPECT_EQ(s["hiding_faces"].size(), s["hidden_by"].get<std::size_t>());
  }
  EXPECT_GT(hidden, 3u);
}

TEST_F(DrawTest, EveryMethodByName) {
  const json methods = json::parse(run("methods --json").out);
  for (const json& method : methods["methods"]) {
    const auto& products = method["produces"];
    if (std::find(products.begin(), products.end(), "strokes") == products.end()) continue;
    const std::string name = method["name"];
    EXPECT_EQ(strokes_by_class(drawn({"cube.obj", "--method", name})), strokes_by_class(drawn("cube.obj --method auto")))
        << name;
  }
}

TEST_F(DrawTest, SpansInJson) {
  const json cube = drawn("cube.obj --method watkins --lines 100 --landscape");
  const json& spans = cube["spans"];
  ASSERT_GT(spans.size(), 80u);
  double area = 0;
  for (const json& line : spans) {
    double x = 0;
    EXPECT_NEAR(line["y"].get<double>(), (line["line"].get<double>() + 0.5) * 2.1, 1e-9);
    for (const json& span : line["spans"]) {
      EXPECT_GE(span[0].get<double>(), x);
      EXPECT_GT(span[1].get<double>(), span[0].get<double>());
      x = span[1].get<double>();
      area += (span[1].get<double>() - span[0].get<double>()) * 2.1;
    }
  }
  // A cube seen along its diagonal is a regular hexagon, here 190 mm high between two corners.
  EXPECT_NEAR(area, 95 * 95 * 3 * std::sqrt(3) / 2, 150);
  EXPECT_FALSE(drawn("cube.obj --method watkins").contains("spans"));
}

// Successive views: --frames, --turn. More of them: scripts/profile.txt.

/// A number of the matrix from the model to the page.
double matrix(const json& drawing, int row, int column) {
  return drawing["view"]["matrix"][static_cast<std::size_t>(4 * row + column)].get<double>();
}

/// The cube has the same sides after a quarter of a turn; in between it is wider, and has the same scale.
TEST_F(DrawTest, FramesTurnTheModelAtOneScale) {
  const auto frame = [&](const std::string& name) { return json::parse(contents(file(name))); };
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

// All methods, by name.

TEST_F(ProgramTest, InfoTextNamesEveryMethod) {
  const json methods = json::parse(run("methods --json").out);
  EXPECT_EQ(methods["format"], "ligne-methods");
  ASSERT_FALSE(methods["methods"].empty());
  const Outcome info = run_well("info square.obj --stats");
  expect_parts(info.err, {"topology"});
  const std::string list = run("methods").out;
  int defaults = 0;
  for (const json& method : methods["methods"]) {
    const std::string name = method["name"];
    expect_parts(info.out, {"\n  " + name + " "});
    expect_parts(list, {name, method["paper"].get<std::string>()});
    defaults += method["default"].get<bool>();
    ASSERT_EQ(method["parts"].size(), 7u) << name;
    std::string symbols;
    for (const json& part : method["parts"]) {
      symbols += part["symbol"].get<std::string>() + ' ';
      EXPECT_FALSE(part["text"].get<std::string>().empty()) << name;
    }
    EXPECT_EQ(symbols, "MD Td Psi sigma Ti RI MV ");
  }
  EXPECT_EQ(defaults, 1);
  expect_parts(info.out, {"open: 4 border edges"});
}

TEST_F(ProgramTest, CompareAsJsonHasOneSchemaForAllMethods) {
  const Outcome outcome = run_well("compare cube.obj --json");
  EXPECT_EQ(outcome.err, "");
  const json found = json::parse(outcome.out);
  EXPECT_EQ(found["format"], "ligne-compare");
  EXPECT_EQ(found["version"], 1);
  EXPECT_EQ(found["reference"], "appel");
  EXPECT_EQ(found["traits"]["faces"], 6);
  EXPECT_EQ(found["auto"]["method"], "appel");
  const json& methods = found["methods"];
  ASSERT_GT(methods.size(), 5u);
  for (const json& m : methods) {
    EXPECT_TRUE(m["drawn"]) << m["name"];
    ASSERT_EQ(m.size(), methods[0].size()) << m["name"];
    for (const auto& [key, value] : methods[0].items()) EXPECT_TRUE(m.contains(key)) << m["name"] << " " << key;
    for (const auto& [key, value] : methods[0]["operations"].items()) EXPECT_TRUE(m["operations"].contains(key));
    if (m["exact"] == true) {
      EXPECT_EQ(m["differs_mm"], 0) << m["name"];
    }
  }
  ASSERT_EQ(found["differences_mm"].size(), methods.size());
}

/// The surfaces behind the mesh in the JSON drawing. More of them: scripts/shapes.txt.

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
