#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "drawing/node_pairs.hpp"

namespace ligne {
namespace {

std::vector<std::uint32_t> paired(const std::vector<LatticePoint>& directions,
                                  void (*pair)(std::span<const NodeArm>, std::span<std::uint32_t>) = pair_arms) {
  std::vector<NodeArm> arms;
  for (const LatticePoint d : directions) arms.push_back({d, static_cast<std::uint32_t>(arms.size())});
  std::vector<std::uint32_t> partner(arms.size(), kNoPartner);
  pair(arms, partner);
  return partner;
}

using ArmPartners = std::vector<std::uint32_t>;
constexpr std::uint32_t none = kNoPartner;

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

TEST(NodePairs, ManyArmsGoStraightAcross) {
  constexpr std::uint32_t half = 50000;
  std::vector<LatticePoint> directions(2 * half);
  for (std::uint32_t i = 0; i < half; ++i) {
    const double angle = M_PI * (i + 0.5) / half;
    const LatticePoint d{int(2e7 * std::cos(angle)), int(2e7 * std::sin(angle))};
    directions[i] = d;
    directions[half + i] = {-d.x, -d.y};
  }
  const ArmPartners partner = paired(directions);
  for (std::uint32_t i = 0; i < half; ++i) ASSERT_EQ(partner[i], half + i);
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
