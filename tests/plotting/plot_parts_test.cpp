/// Long plots: what is cut off, split and done between strokes; sheets of large drawings.

#include "plotting/plot_parts.hpp"
#include "drawing/measures.hpp"
#include "plotting/tiles.hpp"
#include "plotting/writers/plot_writers.hpp"
#include "support/test.hpp"

namespace ligne {
namespace {

double length(const Plot& plot) {
  double sum = 0;
  for (const PenLines& pen : plot.pens) sum += test::length_of(pen.lines);
  return sum;
}

std::size_t strokes(const Plot& plot) {
  std::size_t n = 0;
  for (const PenLines& pen : plot.pens) n += pen.lines.size();
  return n;
}

/// Two pens; strokes of random length, a dot among them.
Plot random_plot(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(20, 180);
  Plot plot;
  for (const unsigned number : {1u, 3u}) {
    PenLines pen;
    pen.pen.number = number;
    for (int i = 0; i < 20; ++i) {
      std::vector<Point2> line;
      for (int k = 0; k < 1 + i % 5; ++k) line.push_back({place(random), place(random)});
      pen.lines.add(line);
    }
    plot.pens.push_back(std::move(pen));
  }
  return plot;
}

TEST(PlotParts, PartsAreTheWholeAndNoneIsTooLarge) {
  const Device& device = *find_device("grbl-servo");
  for (unsigned seed = 0; seed < 50; ++seed) {
    const Plot plot = random_plot(seed);
    for (const PlotSplit split :
         {PlotSplit{SplitBy::lifts, 7}, PlotSplit{SplitBy::distance, 900}, PlotSplit{SplitBy::time, 45}}) {
      const std::vector<Plot> parts = split_plot(plot, split, &device, {0, 0});
      EXPECT_GT(parts.size(), 2u);
      std::size_t count = 0;
      double way = 0;
      for (const Plot& part : parts) {
        count += strokes(part);
        way += length(part);
        if (strokes(part) == 1) continue;
        if (split.by == SplitBy::lifts) {
          EXPECT_LE(strokes(part), 7u);
        } else if (split.by == SplitBy::distance) {
          EXPECT_LE(length(part), 900 + 1e-9);
        }
      }
      EXPECT_EQ(count, strokes(plot));
      EXPECT_NEAR(way, length(plot), 1e-9);
    }
  }
}

TEST(PlotParts, TheWholeTimeIsThatOfTheReport) {
  const Device& device = *find_device("hp7475a");
  const Plot plot = random_plot(1);
  const double seconds = plot_seconds(device, measure(plot, {0, 0}, false), pen_changes(plot));
  EXPECT_EQ(strokes_within(plot, device, {0, 0}, seconds + 1e-6), strokes(plot));
  EXPECT_EQ(strokes_within(plot, device, {0, 0}, seconds - 1e-6), strokes(plot) - 1);
  EXPECT_EQ(strokes_within(plot, device, {0, 0}, 0), 0u);
}

TEST(PlotParts, ABrushNeverDrawsMoreThanItHolds) {
  for (unsigned seed = 0; seed < 50; ++seed) {
    const Plot plot = random_plot(seed);
    const Plot dipped = with_actions(plot, 250);
    EXPECT_NEAR(length(dipped), length(plot), 1e-6);
    double since = 0;
    for (const PenLines& pen : dipped.pens) {
      for (std::uint32_t i = 0; i < pen.lines.size(); ++i) {
        if (std::ranges::binary_search(pen.actions, i)) since = 0;
        Polylines one;
        one.add(pen.lines[i]);
        since += test::length_of(one);
        EXPECT_LE(since, 250 + 1e-9);
      }
    }
    EXPECT_EQ(dipped.pens[0].actions.front(), 0u) << "it is dipped before the first stroke";
  }
}

TEST(Tiles, SheetsTogetherAreTheDrawing) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> x(0, 500), y(0, 330);
  Drawing drawing;
  drawing.layers.push_back({"mesh", {}});
  for (int i = 0; i < 60; ++i)
    drawing.layers[0].lines.add(std::array{Point2{x(random), y(random)}, Point2{x(random), y(random)}});
  const Page whole{500, 330}, paper{210, 297, 10};
  // Without an overlap every bit of line is on one sheet.
  double sum = 0;
  const std::vector<Tile> tiles = cut_into_tiles(drawing, whole, paper, 0);
  ASSERT_EQ(tiles.size(), 6u);
  for (const Tile& tile : tiles) {
    for (const Layer& layer : tile.drawing.layers) {
      if (layer.name != "mesh") continue;
      sum += test::length_of(layer.lines);
      for (const Point2 p : layer.lines.points)
        EXPECT_TRUE(std::abs(p.x - 105) <= 95 + 1e-9 && std::abs(p.y - 148.5) <= 138.5 + 1e-9) << p.x << " " << p.y;
    }
    EXPECT_EQ(tile.drawing.layers.back().name, "register");
  }
  EXPECT_NEAR(sum, test::length_of(drawing.layers[0].lines), 1e-6);
}

TEST(Tiles, MarksOfNeighboursAreOnePointOfTheDrawing) {
  Drawing drawing;
  drawing.layers.push_back({"mesh", {}});
  drawing.layers[0].lines.add(std::array{Point2{1, 50}, Point2{299, 50}});
  const std::vector<Tile> tiles = cut_into_tiles(drawing, {300, 100}, {160, 120, 10}, 8);
  ASSERT_EQ(tiles.size(), 3u);
  // Marks begin with the upper left cross, across and down; the upper right one follows two crosses later.
  const auto middle = [](const Polylines& lines, std::size_t i) { return (lines[i].front() + lines[i].back()) * 0.5; };
  const Polylines &left = tiles[0].drawing.layers.back().lines, &right = tiles[1].drawing.layers.back().lines;
  const double step = 140 - 8;
  EXPECT_NEAR(middle(left, 4).x - 10, middle(right, 0).x - 10 + step, 1e-9);
  EXPECT_EQ(middle(left, 4).y, middle(right, 0).y);
}

}  // namespace
}  // namespace ligne
