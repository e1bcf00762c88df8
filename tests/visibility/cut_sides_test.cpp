#include <gtest/gtest.h>

#include <vector>

#include "visibility/common/penetration.hpp"

namespace ligne {
namespace {

Facet triangle_of(std::uint32_t face, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  return {{a, b, c}, face, 0, 0, 0, 1};
}

TEST(CutSides, AreThoseOfTwoFacetsOfOneFace) {
  // A square of two facets, a triangle of another face on its side 0-1, and a square cut into four.
  const std::vector<Facet> facets{triangle_of(3, 0, 1, 2), triangle_of(5, 1, 0, 4), triangle_of(3, 2, 3, 0),
                                  triangle_of(7, 5, 6, 9), triangle_of(7, 6, 7, 9), triangle_of(7, 7, 8, 9),
                                  triangle_of(7, 8, 5, 9)};
  const CutSides sides(facets);
  EXPECT_TRUE(sides.has(3, 0, 2));
  EXPECT_TRUE(sides.has(3, 2, 0));
  EXPECT_FALSE(sides.has(3, 0, 1));
  EXPECT_FALSE(sides.has(5, 0, 1));
  EXPECT_FALSE(sides.has(5, 0, 2));
  for (std::uint32_t v = 5; v < 9; ++v) EXPECT_TRUE(sides.has(7, 9, v)) << v;
  EXPECT_FALSE(sides.has(7, 5, 6));
}

}  // namespace
}  // namespace ligne
