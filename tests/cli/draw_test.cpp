/// Every option of `ligne draw`, by what it changes.

#include "draw_program.hpp"

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

TEST_F(DrawTest, StatsToErrorAndFile) {
  const Outcome outcome = run_well("draw cube.obj -o out.svg --stats --stats-json stats.json");
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(outcome.err.rfind("method ", 0), 0u) << outcome.err;
  const json stats = json::parse(contents(file("stats.json")));
  EXPECT_EQ(stats["format"], "ligne-stats");
  EXPECT_FALSE(stats["counts"].empty());
  std::set<std::string> stages;
  for (const auto& [name, seconds] : stats["stages"].items()) {
    stages.insert(name);
    EXPECT_GE(seconds.get<double>(), 0);
    expect_parts(outcome.err, {"  " + name + " "});
  }
  EXPECT_EQ(stages, (std::set<std::string>{"read", "topology", "project", "study", "drawing", "write", "output"}));
  for (const auto& [name, seconds] : stats["processor_seconds"].items()) {
    EXPECT_EQ(stages.erase(name), 1u) << name;
    EXPECT_GE(seconds.get<double>(), 0);
  }
  EXPECT_TRUE(stages.empty());
}

TEST_F(DrawTest, OnlyDrawnPartsAreSubdivided) {
  std::string text = "o small\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\no large\n";
  for (int i = 0; i < 2000; ++i) text += "f 1 2 3 4\n";
  write("parts.obj", text);
  constexpr int kPiecesOfASide = 1 << 7;
  EXPECT_EQ(strokes_by_class(drawn("parts.obj --subdivide catmull-clark:7 --only small"))["border"], 4 * kPiecesOfASide);
  const Outcome outcome = run("draw parts.obj --subdivide catmull-clark:7 -o x.svg");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(outcome.err.rfind("ligne: parts.obj: 7 levels of subdivision would make 65568768 triangles of it", 0), 0u)
      << outcome.err;
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

}  // namespace
}  // namespace ligne::test
