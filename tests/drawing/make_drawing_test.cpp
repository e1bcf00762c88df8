#include "base/parallel.hpp"
#include "drawing/drawing.hpp"
#include "drawing/text_item.hpp"
#include "linework/stroke_builder.hpp"
#include "main/script.hpp"
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

double total_length(const Lines& lines) {
  double sum = 0;
  for (const Line& line : lines)
    for (std::size_t i = 1; i < line.size(); ++i) sum += std::hypot(line[i].x - line[i - 1].x, line[i].y - line[i - 1].y);
  return sum;
}

/// The lines of each layer: "mesh 0,0 5,0; crease 5,0 9,0 9,5".
std::string as_words(const Drawing& drawing) {
  std::string text;
  for (const Layer& layer : drawing.layers)
    for (const Line& line : lines_of(drawing, layer.name)) {
      text += (text.empty() ? "" : "; ") + layer.name;
      for (const Point2 p : line) text += " " + test::as_text(p.x) + "," + test::as_text(p.y);
    }
  return text;
}

/// "STEP X,Y: STROKES": of a lattice with this step and origin in mm.
std::string placed(const std::string& text) {
  std::string_view rest = text;
  const double step = test::value_of(test::take_word(rest));
  const std::size_t comma = rest.find(','), colon = rest.find(':');
  StrokeModel m = sketch(std::string(rest.substr(colon + 1)));
  m.lattice.step_mm = step;
  m.lattice.origin_mm = {test::value_of(rest.substr(0, comma)), test::value_of(rest.substr(comma + 1, colon - comma - 1))};
  return as_words(make_drawing(m));
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

/// "ACROSS UP DEGREES": where the base line of a text at 100, 50 begins, and the middle of its box.
std::string text_at(const std::string& text) {
  const std::vector<std::string> words = test::words_of(text);
  const TextAcross across = words.at(0) == "left" ? TextAcross::left
                            : words[0] == "right" ? TextAcross::right
                                                  : TextAcross::center;
  const TextUp up = words.at(1) == "base" ? TextUp::base : words[1] == "top" ? TextUp::top : TextUp::middle;
  const TextItem item{"x", {100, 50}, 2, across, up, std::stod(words.at(2))};
  const auto point = [](Point2 p) {
    return test::as_text(std::round(p.x * 1e12) / 1e12) + "," + test::as_text(std::round(p.y * 1e12) / 1e12);
  };
  return point(base_point(item)) + " box " + point(text_box(item, {10, 2, 1}).center);
}

/// "X Y DEGREES GAP", a box of 10 by 2 mm there against one about 0, 0.
std::string overlaps(const std::string& text) {
  const std::vector<std::string> words = test::words_of(text);
  const TextBox a{{0, 0}, {5, 1}, 0}, b{{std::stod(words.at(0)), std::stod(words.at(1))}, {5, 1}, std::stod(words.at(2))};
  const double gap = std::stod(words.at(3));
  EXPECT_EQ(overlap(a, b, gap), overlap(b, a, gap));
  return overlap(a, b, gap) ? "yes" : "no";
}

[[maybe_unused]] const bool values_are_added = test::add_function_scripts(
    LIGNE_SOURCE_DIR "/tests/drawing/values", {{"lines", [](auto& t) { return as_words(make_drawing(sketch(t))); }},
                                               {"placed", placed},
                                               {"text-at", text_at},
                                               {"overlaps", overlaps}});

}  // namespace
}  // namespace ligne
