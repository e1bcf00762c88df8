#include "base/parallel.hpp"
#include "drawing/drawing.hpp"
#include "drawing/text_item.hpp"
#include "linework/stroke_builder.hpp"
#include "support/test.hpp"

namespace ligne {
namespace {

using Line = std::vector<Point2>;
using Lines = std::vector<Line>;

Lines lines_of(const Drawing& drawing, std::string_view layer) {
  Lines lines;
  for (const Layer& l : drawing.layers) {
    if (l.name != layer) continue;
    for (std::size_t i = 0; i < l.lines.size(); ++i) lines.emplace_back(l.lines[i].begin(), l.lines[i].end());
  }
  return lines;
}

Lines mesh_lines(const StrokeModel& m) { return lines_of(make_drawing(m), "mesh"); }
Lines mesh_lines(const std::string& text) { return mesh_lines(sketch(text)); }

double total_length(const Lines& lines) {
  double sum = 0;
  for (const Line& line : lines)
    for (std::size_t i = 1; i < line.size(); ++i) sum += std::hypot(line[i].x - line[i - 1].x, line[i].y - line[i - 1].y);
  return sum;
}

TEST(MakeDrawing, NothingGivesNothing) { EXPECT_TRUE(make_drawing(model({})).layers.empty()); }

TEST(MakeDrawing, JoinsStrokesToLines) {
  const struct {
    const char *name, *strokes, *lines;
  } cases[] = {
      {"no length", "3,4 3,4", ""},
      {"a stroke without length", "0,0 5,0 5,0", "0,0 5,0"},
      {"whatever the direction of the strokes", "0,0 5,1; 9,0 5,1; 9,0 12,7", "0,0 5,1 9,0 12,7"},
      {"two at any angle", "0,0 5,0 0,1", "0,0 5,0 0,1"},
      {"closed lines repeat their first point", "0,0 5,0 5,5; 0,0 5,5", "0,0 5,0 5,5 0,0"},
      {"points that lie exactly on the line go", "0,0 3,1 9,3 12,4", "0,0 12,4"},
      {"one step off the line is off it, even at the far side of the lattice", "-33554432,0 0,1 33554432,1",
       "-33554432,0 0,1 33554432,1"},
      {"the point stays where a line turns back", "0,0 9,0 4,0", "0,0 9,0 4,0"},
      {"a seam in the middle of a side goes", "3,0 6,0 6,6 0,6 0,0 3,0", "6,0 6,6 0,6 0,0 6,0"},
      {"the straightest continue each other at a crossing", "-9,-1 0,0; -9,1 0,0 9,-1; 0,0 9,1", "-9,-1 9,1; -9,1 9,-1"},
      {"a third one ends at a T-junction", "0,0 5,0 5,5; 5,0 9,1", "0,0 5,0 9,1; 5,0 5,5"},
      {"doubled strokes make a ring", "0,0 5,0; 0,0 5,0", "0,0 5,0 0,0"},
  };
  for (const auto& c : cases) {
    std::ostringstream text;
    text.precision(17);
    for (const Line& line : mesh_lines(c.strokes)) {
      for (const Point2& p : line) text << (&p == &line[0] ? "" : " ") << p.x << ',' << p.y;
      text << "; ";
    }
    EXPECT_EQ(text.str(), *c.lines == 0 ? "" : c.lines + std::string("; ")) << c.name << ": " << c.strokes;
  }
}

TEST(MakeDrawing, LayersArePaintedWeakestFirst) {
  const LatticePoint a{0, 0}, b{9, 9};
  const Drawing drawing = make_drawing(
      model({stroke(a, b, LineClass::outline), stroke(a, b, LineClass::border), stroke(a, b, LineClass::intersection),
             stroke(a, b, LineClass::crease), stroke(a, b, LineClass::mesh), hidden(stroke(a, b, LineClass::outline)),
             hidden(stroke(b, {20, 9}, LineClass::crease))}));
  std::vector<std::string> names;
  for (const Layer& layer : drawing.layers) names.push_back(layer.name);
  EXPECT_EQ(names, (std::vector<std::string>{"hidden", "mesh", "crease", "intersection", "border", "outline"}));
  EXPECT_EQ(lines_of(drawing, "hidden"), (Lines{{{0, 0}, {9, 9}, {20, 9}}}));
}

TEST(MakeDrawing, PointsAreInPageMillimetres) {
  StrokeModel m = model({stroke({2, 4}, {6, 8})});
  m.lattice.origin_mm = {10, 20};
  m.lattice.step_mm = 0.5;
  EXPECT_EQ(lines_of(make_drawing(m), "mesh"), (Lines{{{11, 22}, {13, 24}}}));
}

TEST(MakeDrawing, DoesNotJoinAcrossLayersOrAcrossTheSmallestGap) {
  const Drawing drawing =
      make_drawing(model({stroke({0, 0}, {5, 0}), stroke({5, 0}, {9, 0}, LineClass::crease), stroke({5, 1}, {5, 9})}));
  EXPECT_EQ(lines_of(drawing, "mesh"), (Lines{{{0, 0}, {5, 0}}, {{5, 1}, {5, 9}}}));
  EXPECT_EQ(lines_of(drawing, "crease"), (Lines{{{5, 0}, {9, 0}}}));
}

/// A triangle mesh of n x n jittered squares: `strokes`, shuffled and turned at random.
std::vector<Stroke> random_mesh(int n, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::map<std::pair<int, int>, LatticePoint> vertex;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j) vertex[{i, j}] = {i * 1000 + int(random() % 300), j * 1000 + int(random() % 300)};
  std::vector<Stroke> strokes;
  const auto add = [&](int i, int j, int k, int l) {
    LatticePoint a = vertex[{i, j}], b = vertex[{k, l}];
    if (random() % 2) std::swap(a, b);
    strokes.push_back(stroke(a, b));
  };
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      add(i, j, i + 1, j);
      add(i, j, i, j + 1);
      add(i, j, i + 1, j + 1);
    }
  std::shuffle(strokes.begin(), strokes.end(), random);
  return strokes;
}

TEST(MakeDrawing, KeepsEveryStrokeOfAMeshOnce) {
  for (std::uint32_t seed = 1; seed <= 20; ++seed) {
    const std::vector<Stroke> strokes = random_mesh(12, seed);
    const auto key = [](Point2 a, Point2 b) {
      std::array<double, 4> k{a.x, a.y, b.x, b.y};
      if (std::tie(k[2], k[3]) < std::tie(k[0], k[1])) k = {b.x, b.y, a.x, a.y};
      return k;
    };
    std::map<std::array<double, 4>, int> balance;
    double length = 0;
    for (const Stroke& s : strokes) {
      ++balance[key({s.from.x, s.from.y}, {s.to.x, s.to.y})];
      length += std::hypot(s.to.x - s.from.x, s.to.y - s.from.y);
    }
    const Lines lines = mesh_lines(model(strokes));
    EXPECT_LT(lines.size(), strokes.size() / 6) << "hardly anything was joined";
    EXPECT_NEAR(total_length(lines), length, 1e-9 * length);
    for (const Line& line : lines)
      for (std::size_t i = 1; i < line.size(); ++i) --balance[key(line[i - 1], line[i])];
    // Jitter leaves no three points in line, but by chance; then a longer piece stands for two.
    int unmatched = 0;
    for (const auto& [segment, count] : balance) unmatched += count != 0;
    EXPECT_LE(unmatched, 6) << "seed " << seed;
  }
}

TEST(MakeDrawing, KeepsTheLengthOfCollinearChains) {
  std::mt19937 random(7);
  std::vector<Stroke> strokes;
  for (int line = 0; line < 50; ++line) {
    const int dx = int(random() % 9) - 4, dy = 1 + int(random() % 9);
    LatticePoint p{line * 10000, 0};
    for (int i = 0; i < 40; ++i) {
      const int step = 1 + int(random() % 5);
      const LatticePoint q{p.x + step * dx, p.y + step * dy};
      strokes.push_back(random() % 2 ? stroke(p, q) : stroke(q, p));
      p = q;
    }
  }
  std::shuffle(strokes.begin(), strokes.end(), random);
  double length = 0;
  for (const Stroke& s : strokes) length += std::hypot(s.to.x - s.from.x, s.to.y - s.from.y);
  const Lines lines = mesh_lines(model(strokes));
  EXPECT_EQ(lines.size(), 50u);
  for (const Line& line : lines) EXPECT_EQ(line.size(), 2u);
  EXPECT_NEAR(total_length(lines), length, 1e-9 * length);
}

TEST(MakeDrawing, DoesNotDependOnTheNumberOfThreads) {
  const std::vector<Stroke> strokes = random_mesh(60, 3);
  const auto with_threads = [&](std::size_t n) {
    decltype(mesh_lines(model(strokes))) lines;
    run_with_threads(n, [&] { lines = mesh_lines(model(strokes)); });
    return lines;
  };
  EXPECT_EQ(with_threads(1), with_threads(4));
}

// Texts: where they stand, and the space that they take.

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
