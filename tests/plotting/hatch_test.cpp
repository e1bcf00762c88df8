/// Regions filled with strokes.

#include "plotting/hatching/hatch.hpp"
#include "drawing/measures.hpp"
#include "main/tier.hpp"
#include "plotting/paths/optimize.hpp"
#include "support/test.hpp"

namespace ligne {
namespace {

using Contours = std::vector<std::vector<Point2>>;

const std::vector<Point2> kSquare{{0, 0}, {20, 0}, {20, 20}, {0, 20}};

std::vector<Point2> circle(Point2 c, double r, int n = 90) {
  std::vector<Point2> points;
  for (int i = 0; i < n; ++i) points.push_back({c.x + r * std::cos(2 * M_PI * i / n), c.y + r * std::sin(2 * M_PI * i / n)});
  return points;
}

double border_distance(Point2 p, const Contours& contours) {
  double least = 1e300;
  for (const auto& contour : contours) {
    Point2 before = contour.back();
    for (const Point2 q : contour) least = std::min(least, test::distance_to_segment(p, std::exchange(before, q), q));
  }
  return least;
}

/// A corner that points along the strokes between two lines of the runs is not seen: one of a right angle comes nearer by
/// half the distance of the lines at most.
constexpr double kUnseenPens = 0.5 / 6;

/// Every point of every stroke is inside and half a pen from the border.
void expect_inside(const Polylines& lines, const Contours& contours, double pen) {
  test::for_segments(lines, [&](Point2 a, Point2 b) {
    for (int s = 0; s <= 20; ++s) {
      const Point2 p = a + (b - a) * (s / 20.0);
      EXPECT_TRUE(test::holds(contours, p)) << p.x << " " << p.y;
      EXPECT_GE(border_distance(p, contours), (0.5 - kUnseenPens) * pen) << p.x << " " << p.y;
    }
  });
}

TEST(Hatch, ASquareIsOneStrokeOfRows) {
  HatchOptions options{.angle_degrees = 0, .pen_width_mm = 0.5};
  const Polylines lines = hatch(Contours{kSquare}, options);
  ASSERT_EQ(lines.size(), 1u);
  // Rows at 1, 2 ... 19, each from 0.25 to 19.75, neighbours the other way round.
  ASSERT_EQ(lines[0].size(), 2u * 19);
  for (std::size_t row = 0; row < 19; ++row) {
    const Point2 a = lines[0][2 * row], b = lines[0][2 * row + 1];
    EXPECT_NEAR(a.y, b.y, 1e-12);
    EXPECT_NEAR(std::abs(a.x - b.x), 19.5, 1e-12);
    if (row > 0) {
      EXPECT_NEAR(std::abs(a.y - lines[0][2 * row - 1].y), 1, 1e-12);
      EXPECT_NEAR(a.x, lines[0][2 * row - 1].x, 1e-12);
    }
  }
}

TEST(Hatch, HolesAndCornersStayFree) {
  const Contours contours{{{0, 0}, {40, 5}, {35, 30}, {20, 12}, {5, 35}}, circle({12, 14}, 4), circle({29, 12}, 3)};
  for (const double angle : {0.0, 30.0, 45.0, 90.0, 137.0}) {
    HatchOptions options{.spacing_mm = 0.7, .angle_degrees = angle, .pen_width_mm = 0.5};
    const Polylines lines = hatch(contours, options);
    expect_inside(lines, contours, options.pen_width_mm);
    const PathLengths lengths = measure(lines, {0, 0}, false);
    // The strokes ink about as much as the region has area, less the rim.
    const double area = test::area_within(contours);
    EXPECT_NEAR(lengths.down_mm * options.spacing_mm, area, 0.15 * area) << angle;
    // About a hundred spans; beside a round hole the straight way to the next row would come nearer than half a pen, so the
    // pen is lifted there.
    EXPECT_LT(lines.size(), 30u) << "rows are tied together";
  }
}

TEST(Hatch, CrossIsBothFamilies) {
  HatchOptions options;
  const double one = measure(hatch(Contours{kSquare}, options), {0, 0}, false).down_mm;
  options.cross = true;
  EXPECT_NEAR(measure(hatch(Contours{kSquare}, options), {0, 0}, false).down_mm, 2 * one, 0.02 * one);
}

TEST(Hatch, NeighboursShareTheirRows) {
  HatchOptions options{.angle_degrees = 0};
  const Contours right{{{20, 0.4}, {40, 0.4}, {40, 19}, {20, 19}}};
  const Polylines a = hatch(Contours{kSquare}, options), b = hatch(right, options);
  for (const Polylines* lines : {&a, &b})
    for (const Point2 p : lines->points) EXPECT_NEAR(p.y, std::round(p.y), 1e-12);
}

/// Side by side: the left half with all rows, the right half with some of them.
struct TwoSurfaces {
  HatchFrame frame{{0, 0}, 0};
  double line_mm = hatch_line_mm(1, 0.4);
  std::vector<SurfaceRun> runs;
  std::vector<SurfaceHatch> surfaces{{static_cast<std::uint32_t>(std::lround(1 / hatch_line_mm(1, 0.4))), kRowCycle, 0, 0},
                                     {static_cast<std::uint32_t>(std::lround(1 / hatch_line_mm(1, 0.4))), kRowCycle, 0, 0}};
  std::vector<double> pens{0.4};
  std::vector<Polylines> layers{1};

  TwoSurfaces() {
    add_runs(Contours{{{0, 0}, {20, 0}, {20, 32.5}, {0, 32.5}}}, 0, frame, line_mm, runs);
    add_runs(Contours{{{20, 0}, {40, 0}, {40, 32.5}, {20, 32.5}}}, 1, frame, line_mm, runs);
  }
  void run() { hatch_runs(frame, line_mm, runs, surfaces, pens, layers); }
  /// How many strokes run through (x, y), pieces of ties left out.
  int rows_at(double x, std::size_t layer = 0) const {
    int count = 0;
    test::for_segments(layers[layer],
                       [&](Point2 a, Point2 b) { count += std::abs(b.y - a.y) < 1e-9 && (b.x < x) != (a.x < x); });
    return count;
  }
};

TEST(Hatch, SurfacesOfOneGroupAreOneArea) {
  TwoSurfaces two;
  two.run();
  ASSERT_EQ(two.layers[0].size(), 1u) << "no pen is lifted at the border between them";
  EXPECT_EQ(two.rows_at(20), 32);
}

TEST(Hatch, FewerRowsAreSomeOfTheMore) {
  for (std::uint32_t rows = 1; rows <= kRowCycle; ++rows) {
    TwoSurfaces two;
    two.surfaces[1].rows = rows;
    two.run();
    EXPECT_EQ(two.rows_at(10), 32);
    EXPECT_EQ(two.rows_at(30), static_cast<int>(2 * rows)) << "two cycles";
    EXPECT_EQ(two.rows_at(20), static_cast<int>(2 * rows)) << "the strokes run on";
    expect_inside(two.layers[0], Contours{{{0, 0}, {40, 0}, {40, 32.5}, {0, 32.5}}}, 0.4);
    // A piece that is not along a row is a tie, and those lie at the rim.
    test::for_segments(two.layers[0], [](Point2 a, Point2 b) {
      if (std::abs(b.y - a.y) > 1e-9) {
        EXPECT_GT(std::abs(b.x - 20), 19) << b.x;
      }
    });
  }
  TwoSurfaces white;
  white.surfaces[1].rows = 0;
  white.run();
  EXPECT_EQ(white.rows_at(10), 32);
  EXPECT_EQ(white.rows_at(21), 0);
}

TEST(Hatch, GroupsHaveARimAndLayersHaveTheirPens) {
  TwoSurfaces groups;
  groups.surfaces[1].group = 7;
  groups.run();
  EXPECT_EQ(groups.rows_at(20), 0) << "half a pen is kept free on both sides";
  EXPECT_EQ(groups.rows_at(19.7), 32);
  TwoSurfaces layers;
  layers.surfaces[1].layer = 1;
  layers.pens.push_back(0.8);
  layers.layers.emplace_back();
  layers.run();
  EXPECT_EQ(layers.rows_at(39.7, 0), 0);
  EXPECT_EQ(layers.rows_at(10, 1), 0);
  EXPECT_EQ(layers.rows_at(19.9, 0), 32) << "no rim between two pens on one surface";
  EXPECT_EQ(layers.rows_at(20.1, 1), 32);
  EXPECT_EQ(layers.rows_at(39.7, 1), 0) << "half of the wide pen";
  EXPECT_EQ(layers.rows_at(39.5, 1), 32);
}

/// Rows far apart beside a corner: what ties them follows the rim round it, and leaves no chord across.
TEST(Hatch, TiesFollowTheRim) {
  const Contours tower{{{0, 0}, {10, 0}, {14, 12.5}, {10, 16}, {0, 16}}, circle({2, 8}, 1.5)};
  HatchOptions options{.spacing_mm = 5, .angle_degrees = 0};
  const Polylines lines = hatch(tower, options);
  expect_inside(lines, tower, options.pen_width_mm);
  double corner = 0;
  std::size_t ties = 0;
  test::for_segments(lines, [&](Point2 a, Point2 b) {
    if (std::abs(b.y - a.y) < 1e-9) return;
    ++ties;
    for (const double t : {0.0, 0.5, 1.0}) EXPECT_LT(border_distance(a + (b - a) * t, tower), 0.8 * options.pen_width_mm);
    corner = std::max({corner, a.x, b.x});
  });
  EXPECT_GT(ties, 1u);
  EXPECT_GT(corner, 13) << "out to the corner";
}

TEST(Hatch, CornersBetweenNeighboursMakeNoGaps) {
  // A fan of triangles about a point, in coordinates that have no short binary form.
  const std::vector<Point2> rim = circle({20.1, 19.7}, 15.3, 37);
  const HatchFrame frame({0, 0}, 27);
  const double line_mm = hatch_line_mm(0.9, 0.3);
  std::vector<SurfaceRun> runs;
  for (std::size_t i = 0; i < rim.size(); ++i)
    add_runs(Contours{{{20.1, 19.7}, rim[i], rim[(i + 1) % rim.size()]}}, static_cast<std::uint32_t>(i), frame, line_mm,
             runs);
  const std::vector<SurfaceHatch> surfaces(rim.size(),
                                           {static_cast<std::uint32_t>(std::lround(0.9 / line_mm)), kRowCycle, 0, 0});
  std::vector<double> pens{0.3};
  std::vector<Polylines> layers(1);
  hatch_runs(frame, line_mm, runs, surfaces, pens, layers);
  HatchOptions whole{.spacing_mm = 0.9, .angle_degrees = 27, .pen_width_mm = 0.3};
  const Polylines disc = hatch(Contours{rim}, whole);
  ASSERT_EQ(layers[0].size(), disc.size());
  EXPECT_NEAR(measure(layers[0], {0, 0}, false).down_mm, measure(disc, {0, 0}, false).down_mm, 1e-3);
}

TEST(Hatch, NarrowAndEmptyRegionsGetNothing) {
  HatchOptions options{.angle_degrees = 0};
  EXPECT_EQ(hatch({}, options).size(), 0u);
  EXPECT_EQ(hatch(Contours{{{0, 0.9}, {20, 0.9}, {20, 1.1}, {0, 1.1}}}, options).size(), 0u);
  EXPECT_EQ(hatch(Contours{{{1, 1}}}, options).size(), 0u);
  options.spacing_mm = 0;
  EXPECT_THROW(hatch(Contours{kSquare}, options), std::invalid_argument);
  options.spacing_mm = 1e-9;
  EXPECT_THROW(hatch(Contours{kSquare}, options), std::invalid_argument);
}

/// The white that strokes of a pen leave of an area, and the ink beyond it, on a lattice of 0.05 mm.
struct Cover {
  double white = 0;  ///< radius of the largest disc inside the area that no ink touches
  double beyond = 0;
};
Cover cover_of(const Polylines& strokes, const Contours& area, double pen) {
  Rect box;
  for (const auto& contour : area)
    for (const Point2 p : contour) box.extend(p);
  Cover cover;
  constexpr double kStep = 0.05;
  for (double y = box.min.y; y <= box.max.y; y += kStep)
    for (double x = box.min.x; x <= box.max.x; x += kStep)
      if (test::holds(area, {x, y})) cover.white = std::max(cover.white, test::distance_to_lines({x, y}, strokes) - pen / 2);
  for (const Point2 p : strokes.points)
    if (!test::holds(area, p)) cover.beyond = std::max(cover.beyond, border_distance(p, area));
  return cover;
}

/// A letter S as a pen with a broad nib writes it: its stroke swells to 1.6 mm and thins out to 0.3 mm.
std::vector<Point2> letter_s() {
  std::vector<Point2> left, right;
  constexpr int kSteps = 60;
  for (int i = 0; i <= kSteps; ++i) {
    // The upper arc from the right over the top to the middle, and the same turned round for the lower one.
    const double t = 2.0 * i / kSteps, sign = t < 1 ? 1 : -1, part = t < 1 ? t : 2 - t;
    const double angle = -0.3 - part * (1.5 * M_PI - 0.3), width = 0.15 + 0.65 * std::sin(t * M_PI / 2);
    const Point2 out{std::cos(angle), std::sin(angle)}, middle{10, 10 - sign * 2.5};
    (t < 1 ? left : right).push_back(middle + out * (sign * (2.5 + width)));
    (t < 1 ? right : left).push_back(middle + out * (sign * (2.5 - width)));
  }
  left.insert(left.end(), right.rbegin(), right.rend());
  return left;
}

TEST(Hatch, FillsLeaveNothingWhite) {
  std::vector<Point2> star;
  for (int i = 0; i < 10; ++i) {
    const double r = i % 2 ? 1.6 : 5, a = 0.1 + i * M_PI / 5;
    star.push_back({10 + r * std::cos(a), 10 + r * std::sin(a)});
  }
  const Contours areas[] = {{circle({10, 10}, 5)},
                            {star},
                            {letter_s()},
                            {circle({10, 10}, 5), circle({11, 10}, 2.5)},
                            {{{2, 2}, {9, 2}, {9, 3.1}, {3.4, 3.1}, {3.4, 5}, {7, 5}, {7, 6}, {3.4, 6}, {3.4, 9}, {2, 9}}},
                            {{{0, 0}, {8, 8}, {8.3, 7.7}, {0.3, -0.3}}}};
  for (const Contours& area : areas) {
    for (const double pen : test::chosen("pens of fills", 2, {0.3, 0.5})) {
      HatchOptions options{.spacing_mm = 0.8 * pen, .pen_width_mm = pen, .rim = true};
      Polylines strokes = hatch(area, options);
      for (const Point2 p : strokes.points) {
        EXPECT_TRUE(test::holds(area, p));
        EXPECT_GE(border_distance(p, area), (0.5 - kUnseenPens) * pen);
      }
      // With the outline, as fills are drawn.
      for (std::vector<Point2> contour : area) {
        contour.push_back(contour.front());
        strokes.add(contour);
      }
      // The lattice can miss 0.035 mm.
      EXPECT_LE(cover_of(strokes, area, pen).white, 0.05 - 0.035) << pen << " mm, area " << (&area - areas);
      EXPECT_LE(cover_of(strokes, area, pen).beyond, 1e-9);
    }
  }
}

}  // namespace
}  // namespace ligne
