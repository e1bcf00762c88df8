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

using ProfileTest = DrawTest;

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

}  // namespace
}  // namespace ligne::test
