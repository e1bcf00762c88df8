/// The search for overlaps against all pairs.

#include "linework/overlaps/overlapping_strokes.hpp"
#include "linework/overlaps/stroke_difference.hpp"
#include "linework/overlaps/stroke_directions.hpp"
#include "linework/overlaps/stroke_overlap.hpp"
#include "main/tier.hpp"
#include "stroke_builder.hpp"
#include "support/test.hpp"

namespace ligne {
namespace {

constexpr double kTolerance = 3;

std::vector<OverlapState> by_all_pairs(const std::vector<Stroke>& strokes) {
  std::vector<bool> some(strokes.size());
  for (std::size_t i = 0; i < strokes.size(); ++i)
    for (std::size_t k = i + 1; k < strokes.size(); ++k) {
      const Stroke &a = strokes[i], &b = strokes[k];
      if (!a.needs_overlap_check && !b.needs_overlap_check) continue;
      if (overlap(a.from, a.to, b.from, b.to, kTolerance)) some[i] = some[k] = true;
    }
  std::vector<OverlapState> result;
  for (const bool s : some) result.push_back(s ? OverlapState::overlapping : OverlapState::alone);
  return result;
}

/// Those that can have none count as those that have none.
void expect_found(const std::vector<Stroke>& strokes, std::uint32_t seed) {
  const std::vector<OverlapState> expected = by_all_pairs(strokes), found = find_overlapping_strokes(strokes, kTolerance);
  ASSERT_EQ(found.size(), expected.size());
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < found.size(); ++i)
    wrong += (found[i] == OverlapState::overlapping) != (expected[i] == OverlapState::overlapping);
  EXPECT_EQ(wrong, 0u) << "seed " << seed;
}

class Dice {
 public:
  explicit Dice(std::uint32_t seed) : random_(seed) {}
  int below(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }
  int within(int n) { return below(2 * n + 1) - n; }

 private:
  std::mt19937 random_;
};

/// Strokes of about `length`, most of which begin on a line of another, near it, or near an end of it, at angles down to
/// none.
std::vector<Stroke> clustered(std::uint32_t seed, int count, int page, int shortest, int longest) {
  Dice dice(seed);
  std::vector<Stroke> strokes;
  for (int i = 0; i < count; ++i) {
    LatticePoint from{dice.within(page), dice.within(page)};
    double angle = dice.below(6283) / 1000.0;
    const double ratio = dice.below(1001) / 1000.0;
    const double l = shortest * std::pow(double(longest) / shortest, ratio);
    if (i > 0 && dice.below(4) > 0) {
      const Stroke& other = strokes[static_cast<std::size_t>(dice.below(i))];
      const double dx = double(other.to.x) - other.from.x, dy = double(other.to.y) - other.from.y;
      const double at = dice.below(3) == 0 ? dice.below(2) : dice.below(1001) / 1000.0;
      const int off = dice.below(2) == 0 ? 0 : dice.below(2) == 0 ? 4 : 300;
      from = {other.from.x + static_cast<int>(std::lround(at * dx)) + dice.within(off),
              other.from.y + static_cast<int>(std::lround(at * dy)) + dice.within(off)};
      angle =
          std::atan2(dy, dx) + 3.14159265358979 * dice.below(2) + dice.within(100) / 100.0 * 5 / l * (1 << dice.below(8));
    }
    const LatticePoint to{from.x + static_cast<int>(std::lround(l * std::cos(angle))),
                          from.y + static_cast<int>(std::lround(l * std::sin(angle)))};
    Stroke s = stroke(from, to, LineClass::mesh, std::uint32_t(i));
    s.needs_overlap_check = dice.below(3) > 0;
    strokes.push_back(s);
  }
  return strokes;
}

const std::uint32_t kSeeds = test::runs_all() ? 10 : 4;

TEST(OverlappingStrokes, AreThoseOfAllPairs) {
  const struct {
    const char* name;
    std::array<int, 2> counts;  ///< numbers of strokes, for even seeds and for odd ones
    int page, shortest, longest;
    std::uint32_t seeds;
  } rows[] = {{"all lengths", {700, 3000}, 5'000, 50, 60'000, kSeeds},
              {"long strokes", {2000, 2000}, 1'000'000, 20'000, 1'000'000, kSeeds},
              {"about as long as the short ones", {2000, 2000}, 1000, 150, 250, kSeeds},
              {"a crowd", {3000, 3000}, 300, 20, 2000, 2}};
  for (const auto& [name, counts, page, shortest, longest, seeds] : rows) {
    SCOPED_TRACE(name);
    for (std::uint32_t seed = 1; seed <= seeds; ++seed)
      expect_found(clustered(seed, counts[seed % 2], page, shortest, longest), seed);
  }
}

/// All in the middle of a large page but for four: their mean distance on the page says nothing of the crowd.
std::vector<Stroke> crowded_on_a_large_page(std::uint32_t seed) {
  std::vector<Stroke> strokes = clustered(seed, 3000, 10'000, 3000, 12'000);
  constexpr int kFar = kLatticeLimit - 1000;
  for (const LatticePoint corner : {LatticePoint{kFar, kFar}, {kFar, -kFar}, {-kFar, kFar}, {-kFar, -kFar}}) {
    strokes.push_back(stroke(corner, {corner.x + 500, corner.y}, LineClass::mesh, 0));
    strokes.back().needs_overlap_check = true;
  }
  return strokes;
}

TEST(OverlappingStrokes, InACrowdOnALargePage) {
  for (std::uint32_t seed = 1; seed <= kSeeds / 2; ++seed) expect_found(crowded_on_a_large_page(seed), seed);
}

TEST(OverlappingStrokes, ACrowdOnALargePageIsCrossing) {
  const auto are_crossing = [](const std::vector<Stroke>& strokes) {
    std::vector<std::uint32_t> all(strokes.size());
    std::iota(all.begin(), all.end(), 0u);
    return stroke_directions::are_crossing(strokes, all);
  };
  EXPECT_TRUE(are_crossing(crowded_on_a_large_page(1)));
  std::vector<Stroke> mesh;  // of squares, on the same page
  for (int i = 0; i < 100; ++i)
    for (int k = 0; k < 100; ++k) {
      const LatticePoint p{100 * i, 100 * k};
      mesh.push_back(stroke(p, {p.x + 100, p.y}, LineClass::mesh, 0));
      mesh.push_back(stroke(p, {p.x, p.y + 100}, LineClass::mesh, 0));
    }
  mesh.push_back(stroke({kLatticeLimit - 1, kLatticeLimit - 1}, {kLatticeLimit - 500, 0}, LineClass::mesh, 0));
  EXPECT_FALSE(are_crossing(mesh));
}

TEST(OverlappingStrokes, AmongFarStrokesOfWhichFewMayCoincide) {
  for (std::uint32_t seed = 1; seed <= kSeeds; ++seed) {
    std::vector<Stroke> strokes = clustered(seed, 700, 20'000'000, 1000, 10'000'000);
    for (std::size_t i = 0; i < strokes.size(); ++i) strokes[i].needs_overlap_check = i % 50 == 0;
    expect_found(strokes, seed);
  }
}

/// A tolerance of half a step of these lattices, which are a millimetre wide.
constexpr double kHalf = 0.5;

TEST(StrokeDifference, IsTheLengthThatOneOfThemLacks) {
  const struct {
    const char *name, *first, *second;
    double length;
  } cases[] = {{"one line in other pieces", "0,0 90,30", "30,10 0,0; 30,10 90,30", 0},
               {"hidden strokes are not drawn", "0,0 100,0", "hidden 0,0 100,0", 100},
               {"hidden strokes are not missing", "hidden 0,0 100,0", "hidden 0,0 100,0", 0},
               {"back to front", "0,0 100,30; 20,0 20,50", "20,50 20,0; 100,30 0,0", 0}};
  for (const auto& c : cases)
    EXPECT_NEAR(difference_of(sketch(c.first), sketch(c.second), kHalf).length_mm, c.length, 1e-9 * c.length) << c.name;
}

TEST(StrokeDifference, IsWhatOneOfThemLacks) {
  const StrokeDifference d =
      difference_of(sketch("0,0 100,0; 0,50 100,50"), sketch("0,0 40,0; 70,0 100,0; 0,50 120,50"), kHalf);
  ASSERT_EQ(d.only_first.size(), 1u);
  EXPECT_NEAR(d.only_first[0].from.x, 40, 1e-9);
  EXPECT_NEAR(d.only_first[0].to.x, 70, 1e-9);
  ASSERT_EQ(d.only_second.size(), 1u);
  EXPECT_NEAR(d.length_mm, 50, 1e-9);
  EXPECT_NEAR(d.longest_mm, 30, 1e-9);
}

TEST(StrokeDifference, LevelsCountWhereTheyAreAskedFor) {
  StrokeModel direct = sketch("0,0 100,0"), through = direct;
  through.strokes[0].level = 1;
  EXPECT_TRUE(parts_missing(direct, through, kHalf).empty());
  EXPECT_EQ(parts_missing(direct, through, kHalf, true).size(), 1u);
}

TEST(StrokeDifference, TheSamePointsOfAnotherLatticeAreElsewhere) {
  const StrokeModel here = sketch("0,0 100,0");
  StrokeModel elsewhere = here;
  elsewhere.lattice.origin_mm.y += 10;
  EXPECT_NEAR(difference_of(here, elsewhere, kHalf).length_mm, 200, 1e-9);
}

}  // namespace
}  // namespace ligne
