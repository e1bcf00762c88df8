/// Profiles and widths of `ligne draw`.

#include "draw_program.hpp"
#include "support/standard.hpp"

namespace ligne::test {
namespace {

const std::string kCorpus = LIGNE_SOURCE_DIR "/tests/corpus/";

struct PagePiece {
  std::array<double, 2> from, to;
  std::string line_class;

  double length() const { return std::hypot(to[0] - from[0], to[1] - from[1]); }
};

std::vector<PagePiece> visible_pieces(const json& drawing) {
  std::vector<PagePiece> pieces;
  for (const json& s : drawing["strokes"]) {
    if (!s["visible"].get<bool>()) continue;
    pieces.push_back({s["points"][0].get<std::array<double, 2>>(), s["points"][1].get<std::array<double, 2>>(),
                      s["class"].get<std::string>()});
  }
  return pieces;
}

/// Lengths of visible lines by class, mm.
std::map<std::string, double> lengths(const json& drawing) {
  std::map<std::string, double> sums;
  for (const PagePiece& p : visible_pieces(drawing)) sums[p.line_class] += p.length();
  return sums;
}

class ProfileTest : public DrawTest {
 protected:
  /// A bar across a board, and apart from it.
  void write_bar_and_board() const {
    write("bar.json", R"({"format": "ligne-scene", "version": 1, "objects": [
      {"name": "bar", "vertices": [[-5,0,4], [15,0,4], [15,0,6], [-5,0,6]], "faces": [{"outer": [0,1,2,3]}]},
      {"name": "board", "vertices": [[0,5,0], [10,5,0], [10,5,10], [0,5,10]], "faces": [{"outer": [0,1,2,3]}]}]})");
  }
};

TEST_F(ProfileTest, ABoxHasItAllRound) {
  for (const char* quality : {"clear", "exact"}) {
    for (const char* method : {"appel", "warnock", "watkins", "atherton-weiler"}) {
      for (const char* kind : {"sheet", "parts"}) {
        auto iso = lengths(drawn({kCorpus + "cube.json", "--quality", quality, "--method", method, "--profile", kind}));
        EXPECT_EQ(iso.size(), 2u);
        EXPECT_NEAR(iso["profile"], 2 * iso["crease"], 1e-3) << "a hexagon, and the three edges before it";
        auto front = lengths(
            drawn({kCorpus + "cube.json", "--view", "front", "--quality", quality, "--method", method, "--profile", kind}));
        EXPECT_EQ(front.size(), 1u) << quality << ' ' << method;
        EXPECT_NEAR(front["profile"], 4 * 190, 1e-3);
      }
    }
  }
  auto seen = strokes_by_class(drawn({kCorpus + "cube.json", "--eye", "9,-12,10", "--profile", "sheet"}));
  EXPECT_EQ(seen["profile"], 6);
  EXPECT_EQ(seen["crease"], 3);
}

TEST_F(ProfileTest, IsDrawnWhereItIsAskedFor) {
  const std::string cube = kCorpus + "cube.json";
  EXPECT_EQ(strokes_by_class(drawn({cube})).count("profile"), 0u);
  EXPECT_EQ(strokes_by_class(drawn({cube, "--edges", "all"})).count("profile"), 0u);
  EXPECT_EQ(strokes_by_class(drawn({cube, "--edges", "feature,profile"}))["profile"], 6);
  EXPECT_EQ(strokes_by_class(drawn({cube, "--edges", "feature,profile", "--profile", "off"})).count("profile"), 0u);
  const std::map<std::string, int> only{{"profile", 6}};
  EXPECT_EQ(strokes_by_class(drawn({cube, "--edges", "profile"})), only);
  EXPECT_EQ(strokes_by_class(drawn({cube, "--edges", "profile", "--hidden", "solid"})), only);
  expect_error({"draw", cube, "--profile", "all", "-o", "x.svg"}, 2,
               "ligne: --profile: \"all\" is not one of off, sheet or parts\n");
}

TEST_F(ProfileTest, ChangesExactlyWhereAnotherPartBegins) {
  write_bar_and_board();
  for (const char* quality : {"clear", "exact"}) {
    const json drawing = drawn({"bar.json", "--view", "front", "--profile", "sheet", "--quality", quality});
    const double unit = 277.0 / 20;
    auto sheet = lengths(drawing);
    EXPECT_NEAR(sheet["border"], 2 * 10 * unit, 1e-3) << "the bar before the board";
    EXPECT_NEAR(sheet["profile"], (2 * 10 + 2 * 2 + 2 * 10 + 4 * 4) * unit, 1e-3);
    for (const PagePiece& p : visible_pieces(drawing)) {
      if (p.line_class != "border") continue;
      EXPECT_NEAR(std::min(p.from[0], p.to[0]), 10 + 5 * unit, 1e-6);
      EXPECT_NEAR(std::max(p.from[0], p.to[0]), 10 + 15 * unit, 1e-6);
    }
    auto parts = lengths(drawn({"bar.json", "--view", "front", "--profile", "parts", "--quality", quality}));
    EXPECT_EQ(parts.size(), 1u) << "the board is another part, and farther back";
  }
}

TEST_F(ProfileTest, PartsThatTouchHaveNone) {
  auto sheet = lengths(drawn({kCorpus + "cube_on_table.json", "--profile", "sheet"}));
  auto parts = lengths(drawn({kCorpus + "cube_on_table.json", "--profile", "parts"}));
  EXPECT_GT(parts["profile"], sheet["profile"]) << "the cube before the table";
  EXPECT_GT(parts["crease"] + parts["outline"] + parts["border"], 0) << "not where it stands on it";
  // Nothing of the lower edges of the cube is a profile.
  const json drawing = drawn({kCorpus + "cube_on_table.json", "--only", "cube", "--edges", "feature,profile"});
  EXPECT_EQ(strokes_by_class(drawing)["profile"], 6) << "alone it is a hexagon";
}

TEST_F(ProfileTest, TheRimOfAHoleHasIt) {
  const std::string plate = kCorpus + "plate_one_hole.json";
  auto alone = lengths(drawn({plate, "--hide", "bar", "--view", "front", "--profile", "sheet"}));
  EXPECT_EQ(alone.size(), 1u);
  EXPECT_NEAR(alone["profile"], (4 * 8 + 4 * 4) * 190.0 / 8, 1e-3);
  auto before = lengths(drawn({plate, "--view", "front", "--profile", "sheet"}));
  const double unit = 190.0 / 8;
  // The bar is behind the rim on one unit of the left and of the right, and beside the plate; its own edges end at the rim.
  EXPECT_NEAR(before["border"], (2 * 1 + 2 * 1) * unit, 1e-3);
}

TEST_F(ProfileTest, CornersThatLookInwardsHaveItToo) {
  for (const char* scene : {"l_block.json", "letter_e.json", "gear.json", "star_prism.json"}) {
    for (const char* view : {"front", "top", "right"}) {
      const json drawing = drawn({kCorpus + scene, "--view", view, "--profile", "sheet"});
      // Every end of a profile is that of another one: profiles are closed.
      std::map<std::array<double, 2>, int> ends;
      for (const PagePiece& p : visible_pieces(drawing)) {
        if (p.line_class == "profile") ++ends[p.from], ++ends[p.to];
      }
      EXPECT_FALSE(ends.empty());
      for (const auto& [p, count] : ends) EXPECT_EQ(count % 2, 0) << scene << ' ' << view << ' ' << p[0] << ' ' << p[1];
    }
  }
}

double distance(const std::array<double, 2>& p, const PagePiece& piece) {
  const double dx = piece.to[0] - piece.from[0], dy = piece.to[1] - piece.from[1];
  const double along = (p[0] - piece.from[0]) * dx + (p[1] - piece.from[1]) * dy;
  const double t = std::clamp(along / (dx * dx + dy * dy), 0.0, 1.0);
  return std::hypot(piece.from[0] + t * dx - p[0], piece.from[1] + t * dy - p[1]);
}

/// Whether a line passes beside the place, in the ink of another one, at less than eight degrees: there a change is off by
/// what is looked at beside the line (picture/clear/profile.cpp).
bool passes_beside(const std::array<double, 2>& p, const PagePiece& own, const PagePiece& other) {
  const double ax = own.to[0] - own.from[0], ay = own.to[1] - own.from[1];
  const double bx = other.to[0] - other.from[0], by = other.to[1] - other.from[1];
  const double sine = std::abs(ax * by - ay * bx) / (std::hypot(ax, ay) * std::hypot(bx, by));
  constexpr double kThirdOfPenMm = 0.35 / 3, kSineOfEightDegrees = 0.139;
  // A line that continues this one ends before the place or begins behind it.
  const double along = (p[0] - other.from[0]) * bx + (p[1] - other.from[1]) * by;
  return along > 0 && along < bx * bx + by * by && sine < kSineOfEightDegrees && distance(p, other) < kThirdOfPenMm;
}

/// On smooth contours: where a profile goes on as an outline, another line meets it.
TEST_F(ProfileTest, SmoothOutlinesChangeWhereTheyMeetOtherLines) {
  const std::string knot = LIGNE_SOURCE_DIR "/examples/models/trefoil.obj";
  int changes = 0;
  for (const char* view : {"iso", "top", "dimetric", "trimetric"}) {
    const std::vector<PagePiece> pieces = visible_pieces(drawn({knot, "--view", view, "--profile", "sheet"}));
    std::map<std::array<double, 2>, std::set<std::string>> classes;
    for (const PagePiece& p : pieces) {
      for (const auto& end : {p.from, p.to}) classes[end].insert(p.line_class);
    }
    for (const auto& [place, here] : classes) {
      if (here.size() < 2) continue;
      ++changes;
      int meeting = 0;
      const PagePiece* own = nullptr;
      for (const PagePiece& p : pieces) {
        if (p.from == place || p.to == place) own = &p;
      }
      for (const PagePiece& p : pieces) meeting += distance(place, p) < 0.005 || passes_beside(place, *own, p);
      EXPECT_GE(meeting, 3) << view << ' ' << place[0] << ' ' << place[1];
    }
  }
  EXPECT_GE(changes, 8);
}

TEST_F(ProfileTest, TheSameForAnyNumberOfThreads) {
  for (const char* model : {"trefoil.obj", "gear-pair.json", "pipe-tee.json"}) {
    for (const char* kind : {"sheet", "parts"}) {
      const auto bytes = [&](const char* threads) {
        return run({"draw", std::string(LIGNE_SOURCE_DIR "/examples/models/") + model, "--profile", kind, "--threads",
                    threads, "-o", "-", "--format", "json"})
            .out;
      };
      const std::string one = bytes("1");
      EXPECT_GT(one.size(), 1000u);
      EXPECT_EQ(one, bytes("3")) << model << ' ' << kind;
    }
  }
}

TEST_F(ProfileTest, GlassIsInTheWayOfTheSheet) {
  const json drawing = drawn({LIGNE_SOURCE_DIR "/tests/atherton_weiler/scenes/transparent_three.json", "--view", "front",
                              "--method", "atherton-weiler", "--profile", "sheet"});
  int through = 0;
  for (const json& s : drawing["strokes"]) {
    if (s.value("level", 0) == 0) continue;
    ++through;
    EXPECT_NE(s["class"], "profile") << "what is seen through glass is drawn as that";
  }
  EXPECT_GT(through, 0);
  auto sums = lengths(drawing);
  // The nearest glass lies within the outline of the wall and its neighbours: none of its rim is against the sheet.
  EXPECT_GT(sums["border"], 0);
  EXPECT_GT(sums["profile"], 0);
}

TEST_F(ProfileTest, IsALayerInEveryFormat) {
  const std::string gears = LIGNE_SOURCE_DIR "/examples/models/gear-pair.json";
  run_well({"draw", gears, "--profile", "sheet", "-o", "gears.json"});
  ASSERT_EQ(run({"draw", gears, "--profile", "sheet", "-o", "gears.svg"}).status, 0);
  const std::string svg = contents(file("gears.svg"));
  const std::size_t profile = svg.find("id=\"profile\" fill=\"none\" stroke=\"#000\" stroke-width=\"0.49\"");
  EXPECT_NE(profile, std::string::npos);
  EXPECT_GT(profile, svg.find("id=\"outline\"")) << "painted last";
  for (const char* from : {"gears.json", "gears.svg"}) {
    const Outcome plotted =
        run({"plot", from, "--pen", "profile=2,red,0.7", "--pen", "rest=1", "-o", "-", "--format", "hpgl"});
    EXPECT_EQ(plotted.status, 0) << plotted.err;
    expect_parts(plotted.out, {"SP2;"});
    const Outcome again = run({"plot", from, "--optimize", "off", "-o", "-", "--format", "svg"});
    EXPECT_NE(again.out.find("id=\"profile\" fill=\"none\" stroke=\"#000\" stroke-width=\"0.49\""), std::string::npos)
        << from;
  }
}

TEST_F(ProfileTest, WidthsByClass) {
  const auto svg = [&](const Words& more) {
    const Outcome outcome =
        run(Words{"draw", kCorpus + "cube.json", "--profile", "sheet", "-o", "-", "--format", "svg"} + more);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return outcome.out;
  };
  const auto has = [](const std::string& text, const std::string& id, const std::string& width) {
    return text.find("id=\"" + id + "\" fill=\"none\" stroke=\"#000\" stroke-width=\"" + width + "\"") != std::string::npos;
  };
  const std::string usual = svg("--pen-width 0.5");
  EXPECT_TRUE(has(usual, "profile", "0.7") && has(usual, "crease", "0.35")) << "two to one, of the series of ISO 128";
  const std::string chosen = svg("--width profile=1,crease=0.05cm");
  EXPECT_TRUE(has(chosen, "profile", "1") && has(chosen, "crease", "0.5"));
  const std::string dashed = svg("--hidden dashed --width hidden=0.1 --width profile=2pt");
  expect_parts(dashed,
               {"stroke-width=\"0.1\" stroke-linecap=\"butt\" stroke-linejoin=\"round\" stroke-dasharray=\"1.2 0.3\""});
  EXPECT_TRUE(has(dashed, "profile", "0.705556"));
  for (const char* wrong : {"profiles=1", "profile", "profile=", "profile=0", "=1", "profile=1,"}) {
    const Outcome outcome = run({"draw", kCorpus + "cube.json", "--width", wrong, "-o", "x.svg"});
    EXPECT_EQ(outcome.status, 2) << wrong;
    EXPECT_EQ(outcome.error_lines(), 1u);
  }
  run_well({"draw", kCorpus + "cube.json", "-o", "cube.svg"});
  EXPECT_TRUE(has(run("plot cube.svg --width crease=0.1 --optimize off -o - --format svg").out, "crease", "0.1"));
}

}  // namespace
}  // namespace ligne::test
