/// The places where strokes end, against a map of all of them.

#include "base/no_index.hpp"
#include "linework/map/continuations.hpp"
#include "stroke_builder.hpp"
#include "support/test.hpp"

namespace ligne {
namespace {

using Ends = std::vector<std::uint32_t>;

/// Random strokes between places of a square, so many to a side.
std::vector<Stroke> random_strokes(std::size_t count, std::uint32_t side) {
  std::mt19937 random(7);
  const auto coordinate = [&] { return static_cast<std::int32_t>(random() % side); };
  std::vector<Stroke> strokes(count);
  for (Stroke& s : strokes) s.from = {coordinate(), coordinate()}, s.to = {coordinate(), coordinate()};
  return strokes;
}

/// By place, every third stroke left out.
void expect_all_places(std::size_t count, std::uint32_t side) {
  const std::vector<Stroke> strokes = random_strokes(count, side);
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
  expect_all_places(0, 1);
  expect_all_places(20, 3);
  expect_all_places(30'000, 100);
  expect_all_places(300'000, 400);
}

std::vector<std::uint32_t> paired(const std::vector<LatticePoint>& directions,
                                  void (*pair)(std::span<const NodeArm>, std::span<std::uint32_t>) = pair_arms) {
  std::vector<NodeArm> arms;
  for (const LatticePoint d : directions) arms.push_back({d, static_cast<std::uint32_t>(arms.size())});
  std::vector<std::uint32_t> partner(arms.size(), kNone);
  pair(arms, partner);
  return partner;
}

using ArmPartners = std::vector<std::uint32_t>;
constexpr std::uint32_t none = kNone;

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
  const auto pair = [&](std::uint32_t a, std::uint32_t b) { partner[a] = b, partner[b] = a; };
  pair(1, 6), pair(7, 0), pair(8, 2), pair(3, 5);
  EXPECT_EQ(lines_of(partner, LineOrder::loose_ends), (std::vector<Ends>{{4, 3, 8}, {0, 6, kNone}}));
  EXPECT_EQ(lines_of(partner, LineOrder::strokes), (std::vector<Ends>{{0, 6, kNone}, {9, 2, 5}}));
  EXPECT_TRUE(lines_of({}, LineOrder::strokes).empty());
}

TEST(NodePairs, KnownAnswers) {
  EXPECT_EQ(paired({{1, 0}}), (ArmPartners{none}));
  EXPECT_EQ(paired({{1, 0}, {1, 1}}), (ArmPartners{1, 0})) << "two arms are paired at any angle";
  EXPECT_EQ(paired({{1, 0}, {0, 1}, {-1, 0}, {0, -1}}), (ArmPartners{2, 3, 0, 1}));
  EXPECT_EQ(paired({{1, 0}, {1, 1}, {1, -1}}), (ArmPartners{none, 2, 1})) << "a turn of exactly 90 degrees is allowed";
  EXPECT_EQ(paired({{2, 0}, {2, 1}, {2, -1}}), (ArmPartners{none, none, none})) << "all turns are sharper than 90 degrees";
  EXPECT_EQ(paired({{9, 0}, {-9, 1}, {-9, 0}}), (ArmPartners{2, none, 0})) << "the straighter of two";
  EXPECT_EQ(paired({{1, 0}, {-1, 0}, {1, 0}, {-1, 0}}), (ArmPartners{1, 0, 3, 2})) << "equal turns go by number";
}

TEST(NodePairs, TurnsAreToldApartToTheLastStep) {
  constexpr std::int32_t far = 1 << 26;
  EXPECT_EQ(paired({{far, 0}, {-far, 1}, {-far + 1, 1}}), (ArmPartners{1, 0, none}));
  EXPECT_EQ(paired({{far, 0}, {-far + 1, 1}, {-far, 1}}), (ArmPartners{2, none, 0}));
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
  const ArmPartners partner = paired(directions);
  for (std::uint32_t i = 0; i < partner.size(); ++i) ASSERT_EQ(partner[partner[i]], i);
}

}  // namespace
}  // namespace ligne
