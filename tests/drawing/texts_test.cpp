/// Texts: where they stand, and the space that they take.

#include "drawing/text_item.hpp"
#include "support/test.hpp"

namespace ligne {
namespace {

void expect_point(Point2 p, Point2 wanted) {
  EXPECT_NEAR(p.x, wanted.x, 1e-12);
  EXPECT_NEAR(p.y, wanted.y, 1e-12);
}

TEST(TextBox, StandsWhereItsAnchorSays) {
  const TextExtent extent{10, 2, 1};
  TextItem item{"x", {100, 50}, 2, TextAcross::left, TextUp::base, 0};
  expect_point(text_box(item, extent).center, {105, 49.5});
  item.across = TextAcross::right;
  expect_point(text_box(item, extent).center, {95, 49.5});
  item.across = TextAcross::center;
  item.up = TextUp::middle;
  expect_point(base_point(item), {100, 51});
  item.up = TextUp::top;
  expect_point(base_point(item), {100, 52});
  item.rotation_degrees = 90;  // reads upwards: its top is at the left
  expect_point(base_point(item), {102, 50});
  item.across = TextAcross::left;
  expect_point(text_box(item, extent).center, {101.5, 45});
  item.rotation_degrees = 180;
  expect_point(base_point(item), {100, 48});
  item.rotation_degrees = -90;
  expect_point(base_point(item), {98, 50});
}

TEST(TextBox, Overlaps) {
  const TextBox a{{0, 0}, {5, 1}, 0};
  const auto beside = [&](Point2 center, double rotation, double gap) {
    const TextBox b{center, {5, 1}, rotation};
    EXPECT_EQ(overlap(a, b, gap), overlap(b, a, gap));
    return overlap(a, b, gap);
  };
  EXPECT_TRUE(beside({9.9, 0}, 0, 0));
  EXPECT_FALSE(beside({10, 0}, 0, 0)) << "touching is no overlap";
  EXPECT_FALSE(beside({10.5, 0}, 0, 0.4));
  EXPECT_TRUE(beside({10.5, 0}, 0, 0.6));
  EXPECT_FALSE(beside({0, 2}, 0, 0));
  EXPECT_TRUE(beside({5.9, 5.9}, 90, 0));
  EXPECT_FALSE(beside({6.1, 5.9}, 90, 0));
  // Their upright rectangles overlap, they do not: a slanted box past the corner.
  EXPECT_FALSE(beside({7.5, 3}, 45, 0));
  EXPECT_TRUE(beside({7.5, 3}, -45, 0));
}

}  // namespace
}  // namespace ligne
