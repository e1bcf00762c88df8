/// Passes of the cleaning of lines: nodes, and runs that are drawn over.

#include "base/no_index.hpp"
#include "linework/map/continuations.hpp"
#include "linework/map/line_groups.hpp"
#include "linework/stroke_geometry.hpp"
#include "main/script.hpp"
#include "stroke_builder.hpp"

namespace ligne {
namespace {

using Ends = std::vector<std::uint32_t>;

// The places where strokes end, against a map of all of them.

/// By place, of random strokes in a square, so many places to a side. Every third stroke is left out.
void expect_all_places(std::size_t count, std::uint32_t side) {
  std::mt19937 random(7);
  const auto coordinate = [&] { return static_cast<std::int32_t>(random() % side); };
  std::vector<Stroke> strokes(count);
  for (Stroke& s : strokes) s.from = {coordinate(), coordinate()}, s.to = {coordinate(), coordinate()};
  std::vector<std::uint32_t> members;
  for (std::uint32_t i = 0; i < count; ++i)
    if (i % 3 != 0) members.push_back(i);
  std::map<LatticePoint, Ends> expected;
  for (std::uint32_t i = 0; i < members.size(); ++i) {
    expected[strokes[members[i]].from].push_back(2 * i);
    expected[strokes[members[i]].to].push_back(2 * i + 1);
  }
  // Places are visited at once, so each writes what is its own.
  std::vector<Ends> found(2 * members.size());
  for_each_node(strokes, members, [&](std::span<const StrokeEnd> ends) {
    Ends& here = found[ends[0].end];
    for (const auto& [p, end] : ends) {
      EXPECT_EQ(p, ends[0].p);
      here.push_back(end);
    }
  });
  std::size_t places = 0;
  for (const Ends& here : found) {
    if (here.empty()) continue;
    ++places;
    const Stroke& s = strokes[members[here[0] / 2]];
    EXPECT_EQ(here, expected[here[0] % 2 == 0 ? s.from : s.to]);
  }
  EXPECT_EQ(places, expected.size());
}

TEST(StrokeNodes, AllEndsAreVisitedPlaceByPlace) {
  for (const auto& [count, side] : {std::pair(0u, 1u), {20, 3}, {30'000, 100}, {300'000, 400}})
    expect_all_places(count, side);
}

std::vector<std::uint32_t> paired(const std::vector<LatticePoint>& directions,
                                  void (*pair)(std::span<const NodeArm>, std::span<std::uint32_t>) = pair_arms) {
  std::vector<NodeArm> arms;
  for (const LatticePoint d : directions) arms.push_back({d, static_cast<std::uint32_t>(arms.size())});
  std::vector<std::uint32_t> partner(arms.size(), kNone);
  pair(arms, partner);
  return partner;
}

/// The lines that partners make, as the first ends of their strokes; a ring ends with kNone.
std::vector<Ends> lines_of(const Ends& partner, LineOrder order) {
  std::vector<Ends> lines;
  for_each_line(partner, order, [&](std::span<const std::uint32_t> ends, bool is_ring) {
    lines.emplace_back(ends.begin(), ends.end());
    if (is_ring) lines.back().push_back(kNone);
  });
  return lines;
}

TEST(Continuations, LinesBeginAtLooseEndsOrWithTheirLowestStrokes) {
  // Strokes 0 and 3 are a ring, strokes 4, 1 and 2 an open line: end 9 is loose, 8 continues 2, 3 continues 5, 4 is loose.
  Ends partner(10, kNone);
  for (const auto& [a, b] : {std::pair(1, 6), {7, 0}, {8, 2}, {3, 5}}) join_ends(partner, a, b);
  EXPECT_EQ(lines_of(partner, LineOrder::loose_ends), (std::vector<Ends>{{4, 3, 8}, {0, 6, kNone}}));
  EXPECT_EQ(lines_of(partner, LineOrder::strokes), (std::vector<Ends>{{0, 6, kNone}, {9, 2, 5}}));
  EXPECT_TRUE(lines_of({}, LineOrder::strokes).empty());
}

/// By arm the number of its partner, or "-".
std::string pairs_of(const std::string& text) {
  std::vector<LatticePoint> directions;
  for (const std::string& word : test::words_of(text))
    if (LatticePoint p; std::sscanf(word.c_str(), "%d,%d", &p.x, &p.y) == 2) directions.push_back(p);
  std::string all;
  for (const std::uint32_t arm : paired(directions)) all += arm == kNone ? "-" : std::to_string(arm);
  return all;
}

TEST(NodePairs, FewAndManyArmsAgree) {
  std::mt19937 random(11);
  for (int round = 0; round < 5000; ++round) {
    std::vector<LatticePoint> directions(3 + random() % (kFewArms - 2));
    const int spread = round % 3 == 0 ? 1 << 20 : 1 << 26;
    for (LatticePoint& d : directions) {
      d = {int(random() % spread) - (round % 2 ? spread / 2 : 0), int(random() % (1 << 26)) - (1 << 25)};
      if (d == LatticePoint{}) d.x = 1;
    }
    EXPECT_EQ(paired(directions, pair_few_arms), paired(directions, pair_many_arms)) << "round " << round;
  }
}

TEST(NodePairs, ManyArmsOnTwoFansStayFast) {
  // Every arm of the left fan wants the same arm of the right one: a search per arm would take the square of their number.
  std::vector<LatticePoint> directions;
  for (int i = 0; i < 50000; ++i) {
    directions.push_back({-(1 << 25), i * 100});
    directions.push_back({1 << 25, i * 100 + 7});
  }
  const Ends partner = paired(directions);
  for (std::uint32_t i = 0; i < partner.size(); ++i) ASSERT_EQ(partner[partner[i]], i);
}

// Runs that do not show beside the ink of other lines, against a plain search for them.

constexpr auto kCrease = LineClass::crease, kOutline = LineClass::outline;

std::size_t remove_overdrawn(StrokeModel& m, const OverdrawLimits& limits) {
  return apply_rule(m, 0, [&](LineMap& map) { return remove_overdrawn_runs(map, limits); });
}

TEST(AddedRuns, AreNotOverdrawn) {
  for (const bool is_added : {false, true}) {
    StrokeModel m = sketch("0,0 600,0; crease 300,0 300,20", kOutline);
    m.strokes.back().is_joint = is_added;  // the rule that added it would add it again
    EXPECT_EQ(remove_overdrawn(m, {50, 17, 17}), is_added ? 0u : 1u);
  }
}

/// A plain search for the same: every bit against every line.
std::vector<Stroke> left_by_all_pairs(StrokeModel m, const OverdrawLimits& limits) {
  const LineMap map(m, is_no_mesh, {}, 100);  // a piece has the number of its stroke
  const Runs runs(map);
  const auto is_short = [&](std::uint32_t i) { return runs[runs.of(i)].length < limits.longest_mm; };
  std::vector<double> shown(m.strokes.size(), 0);
  std::vector<bool> touches(m.strokes.size(), false);
  for (std::uint32_t i = 0; i < m.strokes.size(); ++i) {
    if (!is_short(i)) continue;
    constexpr int kPlaces = 4096;  // along the bit
    std::vector<bool> inked(kPlaces, false);
    for (std::uint32_t k = 0; k < m.strokes.size(); ++k) {
      if (is_short(k)) continue;
      const StrokePart part = part_near(m.strokes[i], m.strokes[k], limits.ink_mm);
      for (int place = 0; place < kPlaces; ++place) {
        const double at = (place + 0.5) / kPlaces;
        if (part.from <= at && at <= part.to) inked[place] = true;
      }
      if (!part.empty()) touches[runs.of(i)] = true;
    }
    shown[runs.of(i)] += page_length(m.strokes[i]) * double(std::count(inked.begin(), inked.end(), false)) / kPlaces;
  }
  std::vector<Stroke> left;
  for (std::uint32_t i = 0; i < m.strokes.size(); ++i) {
    const std::uint32_t run = runs.of(i);
    if (!is_short(i) || !touches[run] || shown[run] >= limits.shown_mm) left.push_back(m.strokes[i]);
  }
  return left;
}

TEST(OverdrawnRunsRandom, AreThoseOfAllPairs) {
  std::mt19937 random(7);
  std::size_t dropped = 0, kept = 0;
  // A pen that is narrow, and wide, against the lines.
  for (const double ink : {5.0, 17.0, 60.0}) {
    for (int scene = 0; scene < 20; ++scene) {
      const auto number = [&](int from, int to) { return std::uniform_int_distribution(from, to)(random); };
      std::vector<Stroke> strokes;
      for (int i = 0; i < 60; ++i) {
        const LatticePoint p{number(0, 900), number(0, 900)};
        const int reach = i % 6 == 0 ? 500 : 30;
        const LatticePoint q{p.x + number(-reach, reach), p.y + number(-reach, reach)};
        if (p != q) strokes.push_back(stroke(p, q, i % 2 == 0 ? kOutline : kCrease));
      }
      StrokeModel m = model(strokes);
      const OverdrawLimits limits{50, ink, 17};
      const std::vector<Stroke> left = left_by_all_pairs(m, limits);
      remove_overdrawn(m, limits);
      ASSERT_EQ(m.strokes.size(), left.size()) << "ink " << ink << ", scene " << scene;
      for (std::size_t i = 0; i < left.size(); ++i) EXPECT_EQ(m.strokes[i].from, left[i].from);
      dropped += strokes.size() - left.size();
      kept += left.size();
    }
  }
  EXPECT_GT(dropped, 100u);
  EXPECT_GT(kept, 1000u);
}

// The line map: its nodes, its contacts, the ways to follow a line, and its edits.

StrokeModel lines_of_outlines(const std::string& text) { return sketch(text, LineClass::outline); }

/// The map of all strokes but the mesh, with contacts within two millimetres.
struct Mapped {
  explicit Mapped(StrokeModel strokes) : model(std::move(strokes)), map(model, is_no_mesh, {.reach = 2}, 50) {}
  StrokeModel model;
  LineMap map;
};

/// The invariants at the head of line_map.hpp.
void expect_valid(const LineMap& map) {
  std::vector<std::uint32_t> met(2 * map.piece_count(), 0), count(2 * map.piece_count(), 0);
  for (std::uint32_t end = 0; end < 2 * map.piece_count(); ++end) {
    const std::uint32_t node = map.nodes().of(end);
    if (!map.is_alive(end / 2)) continue;
    ++count[node];
    if (map.nodes().first(node) != end) continue;
    std::uint32_t before = kNone;
    map.nodes().for_each_end(node, [&](std::uint32_t e) {
      EXPECT_TRUE(map.is_alive(e / 2));
      EXPECT_EQ(map.nodes().of(e), node);
      EXPECT_EQ(map.point(e), map.point(end));
      EXPECT_TRUE(before == kNone || before < e);
      before = e;
      ++met[node];
    });
  }
  for (std::uint32_t node = 0; node < count.size(); ++node) {
    EXPECT_EQ(met[node], count[node]);
    EXPECT_EQ(map.nodes().degree(node), count[node]);
  }
}

TEST(LineMapTest, ContactsEndWhenTheirLineGoes) {
  Mapped m(lines_of_outlines("0,0 300,0; 100,0 100,90"));
  EXPECT_EQ(Arcs(m.map, 0).find().size(), 3u);
  m.map.remove(0);
  EXPECT_EQ(Arcs(m.map, 0).find().size(), 1u) << "round a corner";
  EXPECT_TRUE(m.map.is_free(2));
  expect_valid(m.map);
}

TEST(LineMapTest, ContactsEndWhenTheirEndIsJoined) {
  Mapped m(lines_of_outlines("0,0 300,0; 100,1 100,90"));
  EXPECT_EQ(Arcs(m.map, 2).find().size(), 3u);
  Stroke on = m.map.piece(1);
  on.from = {100, 1}, on.to = {100, -50};
  m.map.add(on, 2 * 1, kNone, no_source);
  EXPECT_EQ(Arcs(m.map, 2).find().size(), 2u) << "the line goes on across the other";
  expect_valid(m.map);
}

TEST(LineMapTest, RunsAreOfOneClassAndStraight) {
  const Mapped m(lines_of_outlines("0,0 100,0; 100,0 200,0; 100,0 100,90; crease 200,0 250,0"));
  const Runs runs(m.map);
  EXPECT_EQ(runs.of(1), runs.of(0));
  EXPECT_NE(runs.of(2), runs.of(0));
  EXPECT_EQ(runs[runs.of(0)].length, 200);
  EXPECT_EQ(runs[runs.of(3)].longest_continuation, runs.of(0));
}

TEST(LineMapTest, EditsAreWrittenBack) {
  Mapped m(lines_of_outlines("#1 0,0 300,0; #2 100,0 100,90; #3 400,0 500,0; hidden #4 310,0 390,0"));
  const std::uint32_t right = m.map.piece_count() - 1;  // the second part of the first stroke
  m.map.remove(0);
  Stroke bridge = m.map.piece(right);
  bridge.from = {300, 0}, bridge.to = {400, 0};
  m.map.add(bridge, 2 * right + 1, 2 * 2, no_source);
  EXPECT_FALSE(m.map.is_free(2 * 2));
  expect_valid(m.map);
  const std::vector<Stroke> added(m.map.added().begin(), m.map.added().end());
  m.map.commit();
  clear_hidden(m.model.strokes, added, 1);
  ASSERT_EQ(m.model.strokes.size(), 5u) << "the hidden line under the bridge has gone";
  EXPECT_FALSE(m.model.strokes[0].visible);
  EXPECT_EQ(m.model.strokes[0].to, (LatticePoint{100, 0}));
  EXPECT_TRUE(m.model.strokes[1].visible);
  EXPECT_EQ(m.model.strokes[1].to, (LatticePoint{300, 0}));
  EXPECT_EQ(m.model.strokes[4].source, m.model.edge_count) << "a source of its own";
}

/// Its pieces, where they end on others, and the numbers of lines at its nodes.
std::string map_of(const std::string& text) {
  const Mapped m(lines_of_outlines(text));
  expect_valid(m.map);
  std::vector<std::size_t> degrees;
  for (std::uint32_t end = 0; end < 2 * m.map.piece_count(); ++end) {
    const std::uint32_t node = m.map.nodes().of(end);
    if (m.map.nodes().first(node) == end) degrees.push_back(m.map.nodes().degree(node));
  }
  std::ranges::sort(degrees);
  std::string all =
      std::to_string(m.map.piece_count()) + " pieces, " + std::to_string(m.map.contacts().size()) + " contacts, degrees";
  for (const std::size_t degree : degrees) all += " " + std::to_string(degree);
  return all;
}

/// "REACH: LINES": their numbers of points, least first. Where the reach is "corners", corners beside lines meet them too.
std::string arcs_of(const std::string& text) {
  const std::size_t colon = text.find(": ");
  const bool any_node = text.starts_with("corners");
  StrokeModel m = lines_of_outlines(text.substr(colon + 2));
  const LineMap map(m, is_no_mesh, {.reach = 2, .any_node = any_node}, 50);
  expect_valid(map);
  std::vector<std::string> arcs;
  const Arcs found(map, any_node ? 2 : test::value_of(text.substr(0, colon)));
  for (const Arcs::Arc& arc : found.find()) {
    EXPECT_EQ(arc.ends.size(), arc.pieces.size());
    const LatticePoint first = map.point(arc.ends.front()), last = map.point(arc.ends.back() ^ 1);
    arcs.push_back((first == last ? "ring of " : "") + std::to_string(arc.ends.size() + 1));
  }
  std::ranges::sort(arcs);
  std::string all;
  for (const std::string& arc : arcs) all += (all.empty() ? "" : ", ") + arc;
  return all;
}

[[maybe_unused]] const bool maps_are_added = test::add_function_scripts(
    LIGNE_SOURCE_DIR "/tests/linework/maps", {{"map", map_of}, {"arcs", arcs_of}, {"pairs", pairs_of}});

TEST(LineMapTest, ACrowdAtOnePointCostsLittle) {
  constexpr std::int32_t kArms = 20'000;
  StrokeModel star = model({});
  for (std::int32_t i = 0; i < kArms; ++i) star.strokes.push_back(stroke({0, 0}, {100'000, i}, LineClass::outline));
  LineMap map(star, is_no_mesh, {.reach = 2}, 50);
  EXPECT_EQ(map.nodes().degree(map.nodes().of(0)), std::uint32_t(kArms));
  EXPECT_EQ(Arcs(map, 0).find().size(), std::size_t(kArms));
  for (std::uint32_t p = 0; p < map.piece_count(); ++p) map.remove(p);
  expect_valid(map);
}

}  // namespace
}  // namespace ligne
