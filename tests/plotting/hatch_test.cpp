/// Regions filled with strokes.

#include "plotting/hatching/hatch.hpp"
#include "drawing/measures.hpp"
#include "main/script.hpp"
#include "plotting/paths/optimize.hpp"
#include "sample_drawing.hpp"

namespace ligne {
namespace {

using Contours = std::vector<std::vector<Point2>>;

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

/// "SPACING ANGLE PEN: AREA", also "cross" behind them.
Polylines hatched(const std::string& text) {
  const std::vector<std::string> words = test::words_of(text.substr(0, text.find(": ")));
  const Contours area = test::contours_of_text(text.substr(text.find(": ") + 2));
  const HatchOptions options{.spacing_mm = std::stod(words.at(0)),
                             .angle_degrees = std::stod(words.at(1)),
                             .pen_width_mm = std::stod(words.at(2)),
                             .cross = words.back() == "cross"};
  const Polylines lines = hatch(area, options);
  expect_inside(lines, area, options.pen_width_mm);
  return lines;
}

/// How much is drawn, in whole millimetres, and in how many strokes.
std::string drawn_length(const std::string& text) {
  const Polylines lines = hatched(text);
  return as_decimal(measure(lines, {0, 0}, false).down_mm, 0) + " in " + std::to_string(lines.size());
}

/// Side by side: the left half with all rows, the right half with some of them.
struct TwoSurfaces {
  HatchFrame frame{{0, 0}, 0};
  double line_mm = hatch_line_mm(1, 0.4);
  std::vector<SurfaceRun> runs;
  std::vector<SurfaceHatch> surfaces{2,
                                     {static_cast<std::uint32_t>(std::lround(1 / hatch_line_mm(1, 0.4))), kRowCycle, 0, 0}};
  std::vector<double> pens{0.4};
  std::vector<Polylines> layers{1};

  TwoSurfaces() {
    add_runs(test::contours_of_text("0,0 20,0 20,32.5 0,32.5"), 0, frame, line_mm, runs);
    add_runs(test::contours_of_text("20,0 40,0 40,32.5 20,32.5"), 1, frame, line_mm, runs);
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
    expect_inside(two.layers[0], test::contours_of_text("0,0 40,0 40,32.5 0,32.5"), 0.4);
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
  const Contours tower = test::contours_of_text("0,0 10,0 14,12.5 10,16 0,16;0..89:2+1.5*cos(k*pi/45),8+1.5*sin(k*pi/45)");
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
  const std::vector<Point2> rim = test::line_of_text("0..36:20.1+15.3*cos(2*pi*k/37),19.7+15.3*sin(2*pi*k/37)");
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

/// "PEN: AREA", filled.
std::string white_of(const std::string& text) {
  const double pen = std::stod(text);
  const Contours area = test::contours_of_text(text.substr(text.find(": ") + 2));
  Polylines strokes = hatch(area, {.spacing_mm = 0.8 * pen, .pen_width_mm = pen, .rim = true});
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
  const Cover cover = cover_of(strokes, area, pen);
  EXPECT_LE(cover.beyond, 1e-9);
  return cover.white <= 0.05 - 0.035 ? "none" : test::as_text(cover.white);
}

[[maybe_unused]] const bool hatches_are_added = test::add_function_scripts(
    LIGNE_SOURCE_DIR "/tests/plotting/hatches",
    {{"strokes", [](auto& t) { return text_of_lines(hatched(t)); }}, {"length", drawn_length}, {"white", white_of}});

}  // namespace
}  // namespace ligne
