/// Areas that abut, coincide and overlap, held against a sampled picture: who is on top is told point by point, from the
/// shapes as they were meant, without anything of the code under test.

#include "main/tier.hpp"
#include "plotting/meant_areas.hpp"
#include "svg_text.hpp"

namespace ligne {
namespace {

using namespace test;

void expect_right(MeantScene (*make)(Dice&), unsigned seed, int all = 10'000) {
  SeededDice dice(seed);
  const int count = runs_all() ? all : all / 33;
  int wrong = 0;
  for (int i = 0; i < count; ++i) {
    const MeantScene scene = make(dice);
    if (wrong_places(scene, dice) == 0) continue;
    if (++wrong == 1) ADD_FAILURE() << "the first that is wrong: " << svg_of(scene);
  }
  EXPECT_EQ(wrong, 0) << "of " << count;
}

TEST(SvgAreas, AbuttingRectanglesAgreeWithAPicture) { expect_right(abutting_rectangles, 1); }
TEST(SvgAreas, PolygonsOfSharedCornersAgreeWithAPicture) { expect_right(polygons_of_shared_corners, 2); }

TEST(SvgAreas, ScribblesAgreeWithAPicture) { expect_right(scribbles, 4, 1'000); }

double length_of_borders(const std::string& body) {
  double length = 0;
  for (const Layer& layer :
       read_svg_drawing(page(body), "a.svg", {}, {FillReading::How::outline, 0.35, true}).drawing.layers)
    length += length_of(layer.lines);
  return length;
}

TEST(SvgAreas, BordersOfOneAreaAreDrawnOnce) {
  const std::string clip = "<clipPath id='c'><path d='M0 30H30V60H0z'/></clipPath>", clipped = "clip-path='url(#c)' ";
  const auto path = [](const std::string& attributes) { return "<path stroke='none' fill='blue' " + attributes + "/>"; };
  EXPECT_NEAR(length_of_borders(path("d='M10 10H30V30H10zM10 10H30V20H10z'")), 80, 1e-3) << "contours run along each other";
  EXPECT_NEAR(length_of_borders(clip + path(clipped + "d='M10 10H50V30H10zM10 10H40V50H10z'")), 80, 1e-3)
      << "an inner edge lies on the clip path";
  EXPECT_NEAR(length_of_borders(clip + path(clipped + "fill-rule='evenodd' d='M20 0H50V50H20zM10 20H20V40H10z'")), 80, 1e-3)
      << "a clip path cuts the edge between two parts";
  const std::string both = "<g clip-path='url(#c)'>" + path(clipped + "d='M10 10H50V50H10z'") + "</g>";
  EXPECT_NEAR(length_of_borders(clip + both), 80, 1e-3) << "two clip paths have the edge";
}

/// Edges on one line, a thousand areas in one place, and corners in one point take no time that grows with their square.
TEST(SvgAreas, CrowdsInOnePlaceAreRight) {
  std::string body = "<line y1='50' x2='100' y2='50'/>", star = "M";
  for (int i = 0; i < 20'000; ++i) body += "<path d='M20 20H80V80H20z' fill='white' stroke='none'/>";
  EXPECT_EQ(lines_of(read(body)), (Lines{"0,5000 2000,5000 ", "8000,5000 10000,5000 "}));
  for (int i = 0; i < 10'000; ++i) {
    const double a = 2 * std::numbers::pi * i / 10'000;
    star += "50 50L" + std::to_string(50 + 30 * std::cos(a)) + " " + std::to_string(50 + 30 * std::sin(a)) + "L";
  }
  EXPECT_EQ(lines_of(read("<line y1='50' x2='100' y2='50'/><path d='" + star + "50 50z' fill='white' stroke='none'/>")),
            Lines{"0,5000 10000,5000 "})
      << "spikes have no area";
}

}  // namespace
}  // namespace ligne
