/// Every option of `ligne draw`, by what it changes.

#include <cmath>
#include <set>

#include "draw_program.hpp"

namespace ligne::test {
namespace {

struct Extent {
  double left = 1e300, top = 1e300, right = -1e300, bottom = -1e300;
  double width() const { return right - left; }
  double height() const { return bottom - top; }
};

Extent extent(const json& drawing) {
  Extent box;
  for (const json& stroke : drawing["strokes"]) {
    for (const json& point : stroke["points"]) {
      box.left = std::min(box.left, point[0].get<double>());
      box.right = std::max(box.right, point[0].get<double>());
      box.top = std::min(box.top, point[1].get<double>());
      box.bottom = std::max(box.bottom, point[1].get<double>());
    }
  }
  return box;
}

TEST_F(DrawTest, SaysWhatWasClippedAway) {
  const json front = drawn("cube.obj --view front")["view"];
  EXPECT_EQ(front["window"], json::parse("[0,0,210,297]"));
  EXPECT_FALSE(front.contains("near"));
  const json eye = drawn("cube.obj --eye 0,0,100 --target 0,0,0 --fov 10")["view"];
  EXPECT_NEAR(eye["near"].get<double>(), 0.1, 1e-12) << "a thousandth of the distance to the target";
  const json& window = eye["window"];
  EXPECT_GE(window[0], 0.0);
  EXPECT_LT(window[0], window[2]);
  EXPECT_LE(window[2], 297.0);
}

TEST_F(DrawTest, TrueScaleSizeAndPlace) {
  const Extent box = extent(drawn("cube.obj --view front --scale 2:1"));
  EXPECT_NEAR(box.width(), 40, kMicrometre);
  EXPECT_NEAR(box.height(), 40, kMicrometre);
  EXPECT_NEAR(box.left + box.right, 210, kMicrometre);
  EXPECT_NEAR(box.top + box.bottom, 297, kMicrometre);
  EXPECT_NEAR(extent(drawn("cube.obj --view front --scale 1:10 --unit cm")).width(), 20, kMicrometre);
  EXPECT_NEAR(extent(drawn("cube.obj --view front --scale 1:10 --unit 25")).width(), 50, kMicrometre);
}

TEST_F(DrawTest, FitFillsThePageWithinItsMargins) {
  const Extent portrait = extent(drawn("cube.obj --view front"));
  EXPECT_NEAR(portrait.width(), 190, kMicrometre);
  const Extent wide = extent(drawn("square.obj --view front --margin 2cm"));
  EXPECT_NEAR(wide.left, 20, kMicrometre) << "the page lies on its side by itself";
  EXPECT_NEAR(wide.right, 277, kMicrometre);
  EXPECT_NEAR(extent(drawn("square.obj --view front --portrait")).width(), 190, kMicrometre);
  EXPECT_NEAR(extent(drawn("cube.obj --view front --landscape")).height(), 190, kMicrometre);
  EXPECT_NEAR(extent(drawn("cube.obj --view front --page A3")).width(), 277, kMicrometre);
  EXPECT_NEAR(extent(drawn("square.obj --view front --page 10cmx20cm")).width(), 80, kMicrometre);
}

TEST_F(DrawTest, ViewsAndAxes) {
  // The square lies in x, y: wide from the front, a line from the top, and upright when x is up.
  EXPECT_NEAR(extent(drawn("square.obj --view front --scale 1:1")).width(), 40, kMicrometre);
  EXPECT_NEAR(extent(drawn("square.obj --view top --scale 1:1")).height(), 0, kMicrometre);
  EXPECT_NEAR(extent(drawn("square.obj --direction 0,0,-1 --scale 1:1")).width(), 40, kMicrometre);
  EXPECT_NEAR(extent(drawn("square.obj --direction 0,0,-1 --up 1,0,0 --scale 1:1")).height(), 40, kMicrometre);
  EXPECT_NEAR(extent(drawn("square.obj --direction 0,0,-1 --up-axis x --scale 1:1")).height(), 40, kMicrometre);
  for (const char* view : {"back", "left", "right", "bottom", "iso", "dimetric", "trimetric"}) {
    EXPECT_FALSE(drawn({"cube.obj", "--view", view})["strokes"].empty()) << view;
  }
}

TEST_F(DrawTest, Perspective) {
  // The front face of the cube stands 90 before the eye, the target plane 100.
  const Extent box = extent(drawn("cube.obj --eye 0,0,100 --target 0,0,0 --scale 1:1"));
  EXPECT_NEAR(box.width(), 20 * 100.0 / 90, kMicrometre);
  // An angle of 20 degrees shows 2 * 40 * tan(10 degrees) of a slat 20 high, 40 before the eye.
  write("slat.obj", "v -1 -10 0\nv 1 -10 0\nv 1 10 0\nv -1 10 0\nf 1 2 3 4\n");
  const auto height = [&](const char* fov) {
    return extent(drawn({"slat.obj", "--eye", "0,0,40", "--scale", "1:1", "--fov", fov})).height();
  };
  EXPECT_NEAR(height("20"), 14.1061, kMicrometre);
  EXPECT_NEAR(height("90"), 20, kMicrometre);
}

TEST_F(DrawTest, ClassesCreaseAndHiddenLines) {
  EXPECT_EQ(strokes_by_class(drawn("cube.obj")), (std::map<std::string, int>{{"outline", 6}, {"crease", 3}}));
  EXPECT_EQ(strokes_by_class(drawn("cube.obj --edges outline")), (std::map<std::string, int>{{"outline", 6}}));
  EXPECT_EQ(strokes_by_class(drawn("cube.obj --crease 91")), (std::map<std::string, int>{{"outline", 6}}));
  EXPECT_EQ(strokes_by_class(drawn("cube.obj --crease 91 --edges all")),
            (std::map<std::string, int>{{"outline", 6}, {"mesh", 3}}));
  EXPECT_EQ(strokes_by_class(drawn("square.obj")), (std::map<std::string, int>{{"border", 4}}));
  EXPECT_EQ(strokes_by_class(drawn("cube.obj --hidden dashed --view dimetric"))["hidden"], 3);
  EXPECT_EQ(strokes_by_class(drawn("cube.obj --hidden none --view dimetric")).count("hidden"), 0u);
}

TEST_F(DrawTest, CullLeavesTheVisibleLinesAsTheyAre) {
  const json all = drawn("cube.obj --view dimetric"), culled = drawn("cube.obj --view dimetric --cull");
  EXPECT_EQ(all["strokes"], culled["strokes"]);
  EXPECT_EQ(strokes_by_class(drawn("cube.obj --cull --hidden solid")).count("hidden"), 0u);
  const Outcome open = run_well("draw cube.obj square.obj --cull -o both.svg");
  EXPECT_EQ(open.error_lines(), 1u);
  expect_parts(open.err, {"warning: 1 of 2 objects keep their back faces"});
  EXPECT_EQ(run("draw cube.obj square.obj --cull -q -o both.svg").err, "");
}

TEST_F(DrawTest, HiddenLinesAreDashedOrSolid) {
  run_well("draw cube.obj --view dimetric --hidden dashed -o d.svg");
  ASSERT_EQ(run("draw cube.obj --view dimetric --hidden solid -o s.svg").status, 0);
  const std::string dashed = contents(file("d.svg")), solid = contents(file("s.svg"));
  expect_parts(dashed, {"stroke-dasharray"});
  expect_no_parts(solid, {"stroke-dasharray"});
  expect_parts(solid, {"id=\"hidden\""});
}

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

TEST_F(DrawTest, WarnockShowsItsWindowsAndAreas) {
  const Words warnock = "draw cube.obj --method warnock --set resolution=64";
  const auto with = [&](const Words& more) { return run(warnock + more).status; };
  ASSERT_EQ(with("--show windows -o shown.svg"), 0);
  ASSERT_EQ(with("-o plain.svg"), 0);
  EXPECT_NE(contents(file("shown.svg")).find("id=\"debug\""), std::string::npos);
  EXPECT_EQ(run("draw cube.obj --method newell --show zones -o shown.svg").err,
            "ligne: cube.obj: warning: --show: there is nothing of that kind to draw\n");
  EXPECT_EQ(contents(file("plain.svg")).find("id=\"debug\""), std::string::npos);
  ASSERT_EQ(with("--show windows -o shown.json"), 0);
  const json drawing = json::parse(contents(file("shown.json")));
  EXPECT_GE(drawing["debug"].size(), 4u) << "the first window at least";
  EXPECT_EQ(drawing["regions"].size(), 3u) << "a cube shows three faces";
}

TEST_F(DrawTest, FormatsBySuffixAndByName) {
  const std::pair<const char*, const char*> formats[] = {
      {"svg", "<?xml"}, {"pdf", "%PDF-"}, {"png", "\x89PNG"}, {"json", "{"}};
  for (const auto& [format, mark] : formats) {
    const std::string name = std::string("out.") + format;
    ASSERT_EQ(run({"draw", "cube.obj", "-o", name}).status, 0) << name;
    EXPECT_EQ(contents(file(name)).rfind(mark, 0), 0u) << name;
    const Outcome to_pipe = run({"draw", "cube.obj", "-o", "-", "--format", format});
    EXPECT_EQ(to_pipe.out, contents(file(name))) << name;
    run_well({"draw", "cube.obj", "-o", "other", "--format", format});
    EXPECT_EQ(contents(file("other")), contents(file(name))) << name;
  }
}

TEST_F(DrawTest, PenTitleAndResolution) {
  const std::string plain = run("draw cube.obj -o - --format svg").out;
  expect_parts(plain, {"stroke-width=\"0.35\""});
  const std::string wide = run("draw cube.obj -o - --format svg --pen-width 1mm --title 'A <cube> & co'").out;
  expect_parts(wide, {"stroke-width=\"1\"", "A &lt;cube&gt; &amp; co"});
  const std::string png = run("draw cube.obj -o - --format png --dpi 25.4 --page 100x50").out;
  ASSERT_GT(png.size(), 24u);
  const auto big_endian = [&](std::size_t at) {
    return (static_cast<unsigned char>(png[at + 2]) << 8) + static_cast<unsigned char>(png[at + 3]);
  };
  EXPECT_EQ(big_endian(16), 100);
  EXPECT_EQ(big_endian(20), 50);
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

TEST_F(DrawTest, SameBytesForAnyNumberOfThreads) {
  const std::string model = LIGNE_SOURCE_DIR "/examples/models/stair-tower.obj";
  const auto bytes = [&](const char* threads) {
    return run({"draw", model, "-q", "-o", "-", "--format", "svg", "--hidden", "dashed", "--threads", threads}).out;
  };
  const std::string one = bytes("1");
  EXPECT_GT(one.size(), 10000u);
  EXPECT_EQ(one, bytes("2"));
  EXPECT_EQ(one, bytes("7"));
}

TEST_F(DrawTest, ProgressIsForTerminalsUnlessAskedFor) {
  EXPECT_EQ(run("draw cube.obj -o out.svg").err, "");
  EXPECT_EQ(run("draw cube.obj -o out.svg --progress never").err, "");
  const std::string model = LIGNE_SOURCE_DIR "/examples/models/stair-tower.obj";
  EXPECT_NE(run({"draw", model, "-o", "out.svg", "--progress", "always"}).err.find("%"), std::string::npos);
}

TEST_F(DrawTest, WarningsAreOneLineEachAndQuietIsQuiet) {
  write("doubtful.obj", "v 0 0 0\nv 9 0 0\nv 0 9 0\nf 1 2 3\nf 1 1 2\nf 2 2 3\n");
  const Outcome loud = run_well("draw doubtful.obj -o out.svg");
  EXPECT_EQ(loud.error_lines(), 1u) << loud.err;
  EXPECT_EQ(loud.err.rfind("ligne: doubtful.obj: warning: 2 ", 0), 0u) << loud.err;
  EXPECT_EQ(run("draw doubtful.obj -o out.svg -q").err, "");
}

TEST_F(DrawTest, EmptyDrawingIsAWarningAndAFile) {
  const Outcome outcome = run_well("draw square.obj --edges crease -o out.svg");
  EXPECT_EQ(outcome.err.rfind("ligne: square.obj: warning: ", 0), 0u) << outcome.err;
  EXPECT_NE(contents(file("out.svg")).find("</svg>"), std::string::npos);
  const Outcome behind = run_well("draw cube.obj --eye 0,0,100 --target 0,0,200 -o behind.pdf");
  EXPECT_EQ(behind.error_lines(), 1u) << behind.err;
  EXPECT_EQ(contents(file("behind.pdf")).rfind("%PDF-", 0), 0u);
}

TEST_F(DrawTest, PictureLargerThanThePageIsAWarning) {
  const Outcome outcome = run_well("draw cube.obj --scale 100:1 -o out.svg");
  EXPECT_EQ(outcome.err.rfind("ligne: cube.obj: warning: the picture is larger than the page", 0), 0u) << outcome.err;
}

TEST_F(DrawTest, SeveralModelsMakeOneScene) {
  const auto together = strokes_by_class(drawn("cube.obj square.obj"));
  EXPECT_GE(together.at("outline"), 6);
  EXPECT_GT(together.at("border"), 0);
}

TEST_F(DrawTest, MergedCoplanarFacesHaveNoLineBetweenThem) {
  write("strip.obj", "v 0 0 0\nv 10 0 0\nv 20 0 0\nv 0 10 0\nv 10 10 0\nv 20 10 0\nf 1 2 5 4\nf 2 3 6 5\n");
  EXPECT_EQ(strokes_by_class(drawn("strip.obj --edges all"))["mesh"], 1);
  EXPECT_EQ(strokes_by_class(drawn("strip.obj --edges all --merge-coplanar")).count("mesh"), 0u);
}

TEST_F(DrawTest, ControlMeshesAreDrawnAsTheirSurfaces) {
  // The middles of the cube's faces come to 68/81 of their distance from its middle.
  const auto width = [&](const Words& more) {
    return extent(drawn("cube.obj --view front --scale 1:1 --quality exact" + more)).width();
  };
  EXPECT_NEAR(width({}), 20, kMicrometre);
  EXPECT_NEAR(width("--subdivide catmull-clark"), 20 * 68.0 / 81, kMicrometre);
  EXPECT_NEAR(width("--subdivide catmull-clark:2"), 20 * 68.0 / 81, kMicrometre);
  EXPECT_LT(width("--subdivide loop:3"), 17.9);
  // No edge of the surface is a crease.
  const std::map<std::string, int> strokes = strokes_by_class(drawn("cube.obj --subdivide catmull-clark"));
  EXPECT_EQ(strokes.size(), 1u);
  EXPECT_GT(strokes.at("outline"), 0);
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

TEST_F(DrawTest, WeldedSeamsAreNoBorders) {
  write("seam.obj",
        "v 0 0 0\nv 10 0 0\nv 20 0 0\nv 0 10 0\nv 10 10 0\nv 20 10 0\nv 10 0.01 0\nv 10 9.99 0\nf 1 2 5 4\nf 7 3 6 8\n");
  EXPECT_GT(strokes_by_class(drawn("seam.obj"))["border"], 6);
  for (const char* weld : {"auto", "off"}) EXPECT_GT(strokes_by_class(drawn({"seam.obj", "--weld", weld}))["border"], 6);
  for (const char* quality : {"clear", "exact"}) {
    EXPECT_EQ(strokes_by_class(drawn({"seam.obj", "--weld", "0.02", "--quality", quality}))["border"], 6);
  }
}

TEST_F(DrawTest, ClearLinesOfFacesStoredTwice) {
  write("twice.obj",
        "v 0 0 0\nv 10 0 0\nv 10 10 0\nv 0 10 0\nv 20 0 1\nv 20 10 1\nf 1 2 3 4\nf 2 5 6 3\nf 4 3 2 1\nf 6 5 2 3\n");
  const Outcome clear = run("draw twice.obj -o clear.json --stats-json stats.json");
  expect_parts(clear.err, {"2 faces stored twice are drawn once"});
  EXPECT_EQ(json::parse(contents(file("stats.json")))["clear"]["faces stored twice"], 2);
  const Outcome exact = run("draw twice.obj --quality exact -o exact.json --stats-json stats.json");
  EXPECT_EQ(exact.err, "");
  EXPECT_FALSE(json::parse(contents(file("stats.json"))).contains("clear"));
  EXPECT_EQ(run("draw twice.obj --quality fair -o x.svg").status, 2);
  const Outcome info = run("info twice.obj");
  expect_parts(info.out, {"2 faces have the vertices of another face"});
}

TEST_F(DrawTest, CurvesWhereLinesAreClear) {
  std::string disc, face = "f";
  constexpr int kCorners = 48;
  for (int i = 0; i < kCorners; ++i) {
    const double t = 2 * 3.14159265358979 * i / kCorners;
    disc += "v " + std::to_string(std::cos(t)) + " " + std::to_string(std::sin(t)) + " 0\n";
    face += " " + std::to_string(i + 1);
  }
  write("disc.obj", disc + face + "\n");
  const auto curves = [&](const Words& options) {
    const Outcome outcome = run_well("draw disc.obj --view iso -o - --format svg" + options);
    const std::string path = outcome.out.substr(outcome.out.find("<path d=\"M") + 9);
    return path.substr(0, path.find('"')).find_first_of("Cc") != std::string::npos;
  };
  EXPECT_TRUE(curves({}));
  EXPECT_FALSE(curves("--curves off"));
  EXPECT_FALSE(curves("--quality exact"));
  EXPECT_TRUE(curves("--quality exact --curves on"));
  EXPECT_FALSE(curves("--pen rest=1")) << "pens keep the points";
  EXPECT_EQ(drawn("disc.obj -q --curves on")["strokes"], drawn("disc.obj -q --curves off")["strokes"]);
  EXPECT_EQ(run("draw disc.obj --curves maybe -o x.svg").status, 2);
}

TEST_F(DrawTest, NamesWithSpacesAndUtf8) {
  std::filesystem::copy_file(file("cube.obj"), file("le cube \xc3\xa9t\xc3\xa9.obj"));
  run_well({"draw", "le cube \xc3\xa9t\xc3\xa9.obj", "-o", "une \xc3\xa9toile 'x'.svg"});
  EXPECT_TRUE(exists("une \xc3\xa9toile 'x'.svg"));
  std::filesystem::copy_file(file("cube.obj"), file("-dash.obj"));
  run_well("draw -o dash.svg -- -dash.obj");
}

TEST_F(DrawTest, NothingButTheOutputIsWritten) {
  run_well("draw cube.obj -o out.svg");
  EXPECT_EQ(new_files(), Words{"out.svg"});
}

TEST_F(DrawTest, ExampleModelsAreDrawnWithoutWarnings) {
  for (const char* name : {"gear-pair.json", "pipe-tee.json", "stair-tower.obj"}) {
    const Outcome outcome = run({"draw", std::string(LIGNE_SOURCE_DIR "/examples/models/") + name, "-o", "out.svg"});
    EXPECT_EQ(outcome.status, 0) << name;
    EXPECT_EQ(outcome.err, "") << name;
  }
}

}  // namespace
}  // namespace ligne::test
