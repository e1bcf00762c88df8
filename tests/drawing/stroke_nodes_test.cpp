/// The places where strokes end, against a map of all of them.

#include "drawing/stroke_nodes.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <random>

#include <gtest/gtest.h>

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
  for (std::uint32_t i = 0; i < count; ++i) {
    if (i % 3 != 0) members.push_back(i);
  }
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

TEST(StrokeNodes, ArmsLeadAwayFromThePlace) {
  std::vector<Stroke> strokes(20);
  for (std::int32_t i = 0; i < 20; ++i) strokes[static_cast<std::size_t>(i)].to = {i, 2 * i};
  std::vector<std::uint32_t> members(strokes.size());
  std::iota(members.begin(), members.end(), 0u);
  std::vector<StrokeEnd> ends;
  for (std::uint32_t i = 0; i < 20; ++i) ends.push_back({{0, 0}, 2 * i});
  const NodeArms arms(strokes, members, ends);
  ASSERT_EQ(arms.all().size(), 20u);
  for (std::size_t i = 0; i < 20; ++i) {
    EXPECT_EQ(arms.all()[i].end, 2 * i);
    EXPECT_EQ(arms.all()[i].direction, strokes[i].to);
  }
  NodeArms again = arms;
  again.clear();
  again.add(arms.all()[3]);
  ASSERT_EQ(again.all().size(), 1u);
  EXPECT_EQ(again.all()[0].end, 6u);
}

}  // namespace
}  // namespace ligne
