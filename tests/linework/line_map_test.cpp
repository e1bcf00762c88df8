/// The line map: its nodes, its contacts, the ways to follow a line, and its edits.

#include "linework/map/line_groups.hpp"
#include "main/script.hpp"
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

[[maybe_unused]] const bool maps_are_added =
    test::add_function_scripts(LIGNE_SOURCE_DIR "/tests/linework/maps", {{"map", map_of}, {"arcs", arcs_of}});

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
