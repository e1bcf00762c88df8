/// The line map: its nodes, its contacts, the ways to follow a line, and its edits.

#include "linework/map/line_groups.hpp"
#include "rule_runner.hpp"
#include "stroke_builder.hpp"
#include "support/test.hpp"

namespace ligne {
namespace {

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

TEST(LineMapTest, NodesAreWhereEndsMeet) {
  const Mapped m(lines_of_outlines("0,0 100,0 200,50; 100,0 100,90; mesh 0,0 0,90; hidden 200,50 300,50; 400,0 400,0"));
  EXPECT_EQ(m.map.piece_count(), 3u) << "neither the mesh, nor hidden strokes, nor those without length";
  EXPECT_EQ(m.map.nodes().degree(m.map.nodes().of(1)), 3u);
  EXPECT_TRUE(m.map.is_free(0));
  EXPECT_EQ(m.map.next(1), kNone) << "three lines meet";
  expect_valid(m.map);
}

TEST(LineMapTest, ALineIsCutWhereOthersEndOnIt) {
  // Two lines end beside the first one at one place, and one at another; the last is too far away.
  const Mapped m(lines_of_outlines("0,0 300,0; 100,1 100,90; 100,-1 100,-90; 200,2 200,90; 250,3 250,90"));
  EXPECT_EQ(m.map.piece_count(), 7u);
  ASSERT_EQ(m.map.contacts().size(), 3u);
  EXPECT_EQ(m.map.contacts()[0].other, m.map.contacts()[1].other);
  EXPECT_EQ(Arcs(m.map, Arcs::kNoContacts).find()[0].length, 300) << "a chain goes on through its own cuts";
  EXPECT_EQ(Arcs(m.map, 2).find().size(), 7u);
  EXPECT_EQ(Arcs(m.map, 1).find().size(), 6u) << "two millimetres count no more";
  EXPECT_EQ(Arcs(m.map, 0.5).find().size(), 5u);
  expect_valid(m.map);
}

TEST(LineMapTest, ALineDoesNotMeetItsOwnEnd) {
  const Mapped hook(lines_of_outlines("0,0 300,0 300,2 295,2 295,1"));
  EXPECT_TRUE(hook.map.contacts().empty());
  const Mapped loop(lines_of_outlines("0,0 300,0 300,90 100,90 100,1"));
  EXPECT_EQ(loop.map.contacts().size(), 1u);
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
  EXPECT_EQ(runs[runs.of(3)].longest_beside, runs.of(0));
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
  m.map.commit(1);
  ASSERT_EQ(m.model.strokes.size(), 5u) << "the hidden line under the bridge has gone";
  EXPECT_FALSE(m.model.strokes[0].visible);
  EXPECT_EQ(m.model.strokes[0].to, (LatticePoint{100, 0}));
  EXPECT_TRUE(m.model.strokes[1].visible);
  EXPECT_EQ(m.model.strokes[1].to, (LatticePoint{300, 0}));
  EXPECT_EQ(m.model.strokes[4].source, m.model.edge_count) << "a source of its own";
}

/// The arcs of lines, which also meet where corners lie beside lines, as the points that they run through.
std::vector<std::vector<LatticePoint>> arcs_of(const std::string& text) {
  StrokeModel m = lines_of_outlines(text);
  const LineMap map(m, is_no_mesh, {.reach = 2, .any_node = true}, 50);
  expect_valid(map);
  const Arcs arcs(map, 2);
  std::vector<std::vector<LatticePoint>> found;
  for (const Arcs::Arc& arc : arcs.find()) {
    found.emplace_back();
    EXPECT_EQ(arc.ends.size(), arc.pieces.size());
    for (const std::uint32_t end : arc.ends) found.back().push_back(map.point(end));
    found.back().push_back(map.point(arc.ends.back() ^ 1));
  }
  return found;
}

TEST(ArcsTest, RunFromJunctionToJunction) {
  const auto line = arcs_of("200,0 100,50; 0,0 100,50; 200,0 300,0");
  ASSERT_EQ(line.size(), 1u);
  EXPECT_EQ(line[0].size(), 4u);
  EXPECT_EQ(std::min(line[0].front(), line[0].back()), (LatticePoint{0, 0}));
  const auto ring = arcs_of("0,0 100,0; 100,100 100,0; 0,0 100,100");
  ASSERT_EQ(ring.size(), 1u);
  EXPECT_EQ(ring[0].front(), ring[0].back());
  EXPECT_EQ(arcs_of("0,0 1000,0 1500,500; 1000,0 1500,-500; 400,1 400,600").size(), 5u);
  EXPECT_EQ(arcs_of("0,0 1000,0; 250,-500 250,500").size(), 2u) << "lines that cross do not end there";
}

TEST(ArcsTest, MeetBesideEachOther) {
  EXPECT_EQ(arcs_of("0,0 1000,0; 500,10 500,500").size(), 2u) << "an end beside it";
  EXPECT_EQ(arcs_of("0,0 1000,0 2000,300; 1001,-1 1400,-700").size(), 3u) << "an end beside a corner is one";
  EXPECT_EQ(arcs_of("0,0 1000,0; 400,500 500,1 600,500").size(), 4u) << "a corner beside a line";
}

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
