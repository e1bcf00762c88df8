/// ligne plot, ligne devices, and the plotter's options of the other commands, as a user runs them.

#include <nlohmann/json.hpp>

#include "drawing_quantities.hpp"
#include "program.hpp"
#include "support/page_lines.hpp"

namespace ligne::test {
namespace {

using nlohmann::json;

class PlotTest : public ProgramTest {
 protected:
  std::string written(const std::string& name, const Words& arguments) const {
    const Outcome outcome = run_well(arguments + Words{"-o", name});
    return outcome.status == 0 ? contents(file(name)) : "";
  }
};

TEST_F(PlotTest, CurvesWhereThePenArrives) {
  write("round.svg",
        "<svg width='100mm' height='60mm' viewBox='0 0 100 60' fill='none' stroke='black'><circle cx='70' cy='40' r='8'/>"
        "<path d='M20 10l8.66 5v10l-8.66 5l-8.66-5v-10z'/><circle cx='30' cy='40' r='5'/></svg>");
  const auto begins = [&](const std::string& svg) {
    std::vector<std::string> starts;
    for (std::size_t at = svg.find("d=\"M"); at != std::string::npos; at = svg.find("d=\"M", at + 1))
      starts.push_back(svg.substr(at + 4, svg.find_first_of("cClLZ", at + 4) - at - 4));
    return starts;
  };
  const auto curved_paths = [](const std::string& svg) {
    int count = 0;
    for (std::size_t at = svg.find("d=\"M"); at != std::string::npos; at = svg.find("d=\"M", at + 1))
      count += svg.substr(at + 3, svg.find('"', at + 3) - at - 3).find_first_of("cC") != std::string::npos;
    return count;
  };
  for (const std::string optimize : {"join", "full"}) {
    const Words command{"plot", "round.svg", "--pen", "rest=1,black,0.3", "--optimize", optimize};
    Words curved = command + "--curves on";
    const std::string lines = written("l.svg", command), curves = written("c.svg", curved);
    EXPECT_EQ(begins(lines).size(), 3u);
    EXPECT_EQ(begins(curves), begins(lines)) << curves;
    EXPECT_LT(curves.size() * 2, lines.size());
    EXPECT_EQ(curved_paths(curves), 2) << "not the hexagon: " << curves;
    EXPECT_EQ(curved_paths(lines), 0);
  }
  EXPECT_LT(written("plain.svg", "plot round.svg --curves on").size() * 2, written("plain-l.svg", "plot round.svg").size());
}

TEST_F(PlotTest, BrokenStoredOrdersAreRefused) {
  ASSERT_NE(written("stored.json", {"draw", LIGNE_SOURCE_DIR "/tests/corpus/bricks.json", "--method", "newell", "-q"}), "");
  const auto refused = [&](const Words& arguments, const std::string& part) {
    expect_outcome(arguments + Words("-o x.svg"), kFailed, {part});
    EXPECT_FALSE(exists("x.svg"));
  };
  json broken = json::parse(contents(file("stored.json")));
  broken["order"][0]["material"] = 7;
  write("broken.json", broken.dump());
  refused("plot broken.json --fill material", "a piece of the order has a missing material");
  broken["order"][0].erase("material");
  write("older.json", broken.dump());
  refused("plot older.json --fill material", "piece 0 of the order: has no material; draw it again");
  broken["order"][0]["outer"] = json::array();
  write("empty.json", broken.dump());
  refused("plot empty.json --fill material", "piece 0 of the order: a contour has fewer than three points");
}

// Profiles and widths of `ligne draw`.

const std::string kCorpus = LIGNE_SOURCE_DIR "/tests/corpus/";

using PagePlace = std::array<double, 2>;
Point2 point(const PagePlace& p) { return {p[0], p[1]}; }

struct PagePiece {
  PagePlace from, to;
  std::string line_class;
};

std::vector<PagePiece> visible_pieces(const json& drawing) {
  std::vector<PagePiece> pieces;
  for (const json& s : drawing["strokes"]) {
    if (!s["visible"].get<bool>()) continue;
    pieces.push_back({s["points"][0].get<PagePlace>(), s["points"][1].get<PagePlace>(), s["class"].get<std::string>()});
  }
  return pieces;
}

using ProfileTest = DrawTest;

TEST_F(ProfileTest, CornersThatLookInwardsHaveItToo) {
  for (const char* scene : {"l_block.json", "letter_e.json", "gear.json", "star_prism.json"}) {
    for (const char* view : {"front", "top", "right"}) {
      const json drawing = drawn({kCorpus + scene, "--view", view, "--profile", "sheet"});
      // Every end of a profile is that of another one: profiles are closed.
      std::map<PagePlace, int> ends;
      for (const PagePiece& p : visible_pieces(drawing))
        if (p.line_class == "profile") ++ends[p.from], ++ends[p.to];
      EXPECT_FALSE(ends.empty());
      for (const auto& [p, count] : ends) EXPECT_EQ(count % 2, 0) << scene << ' ' << view << ' ' << p[0] << ' ' << p[1];
    }
  }
}

double distance(const PagePlace& p, const PagePiece& piece) {
  return distance_to_segment(point(p), point(piece.from), point(piece.to));
}

/// Whether a line passes beside the place, in the ink of another one, at less than eight degrees: there a change is off by
/// what is looked at beside the line (picture/clear/profile.cpp).
bool passes_beside(const PagePlace& p, const PagePiece& own, const PagePiece& other) {
  const Point2 a = point(own.to) - point(own.from), b = point(other.to) - point(other.from);
  const double sine = std::abs(a.x * b.y - a.y * b.x) / (glm::length(a) * glm::length(b));
  constexpr double kThirdOfPenMm = 0.35 / 3, kSineOfEightDegrees = 0.139;
  // A line that continues this one ends before the place or begins behind it.
  const double along = glm::dot(point(p) - point(other.from), b);
  return along > 0 && along < glm::dot(b, b) && sine < kSineOfEightDegrees && distance(p, other) < kThirdOfPenMm;
}

/// On smooth contours: where a profile goes on as an outline, another line meets it.
TEST_F(ProfileTest, SmoothOutlinesChangeWhereTheyMeetOtherLines) {
  const std::string knot = LIGNE_SOURCE_DIR "/examples/models/trefoil.obj";
  int changes = 0;
  for (const char* view : {"iso", "top", "dimetric", "trimetric"}) {
    const std::vector<PagePiece> pieces = visible_pieces(drawn({knot, "--view", view, "--profile", "sheet"}));
    std::map<PagePlace, std::set<std::string>> classes;
    for (const PagePiece& p : pieces)
      for (const auto& end : {p.from, p.to}) classes[end].insert(p.line_class);
    for (const auto& [place, here] : classes) {
      if (here.size() < 2) continue;
      ++changes;
      int meeting = 0;
      const PagePiece* own = nullptr;
      for (const PagePiece& p : pieces)
        if (p.from == place || p.to == place) own = &p;
      for (const PagePiece& p : pieces) meeting += distance(place, p) < 0.005 || passes_beside(place, *own, p);
      EXPECT_GE(meeting, 3) << view << ' ' << place[0] << ' ' << place[1];
    }
  }
  EXPECT_GE(changes, 8);
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
  // The nearest glass lies within the outline of the wall and its neighbours: none of its rim is against the sheet.
  for (const char* line_class : {"border", "profile"}) EXPECT_GT(length_mm(drawing, line_class, true), 0) << line_class;
}

}  // namespace
}  // namespace ligne::test
