// Spans put together to areas.

#include "base/parallel.hpp"
#include "drawing/drawing.hpp"
#include "drawing/text_item.hpp"
#include "linework/stroke_builder.hpp"
#include "main/script.hpp"
#include "measures.hpp"
#include "picture/raster/shading.hpp"
#include "picture/raster/span_areas.hpp"
#include "support/mesh_text.hpp"

namespace ligne {
namespace {

/// "FACE LOW HIGH LEFT RIGHT; ...": the areas of spans between two heights, whose ends are formulas of y, on lines half a
/// millimetre apart. Of each area the face, the size, and the corners of its contours to a hundredth.
std::string areas_of_text(const std::string& text) {
  constexpr std::array<std::string_view, 1> kVariables{"y"};
  SpanModel model{{0.25, 0.5, 100}, {}};
  std::vector<std::pair<std::vector<std::string>, std::function<Point3(std::initializer_list<double>)>>> strips;
  for (const std::string& part : test::parts_of(text, ';')) {
    const std::vector<std::string> words = test::words_of(part);
    strips.emplace_back(words, test::place_formula(words.at(3) + ";" + words.at(4) + ";0", kVariables));
  }
  for (std::uint32_t line = 0; line < model.lines.count; ++line) {
    const double y = model.lines.y_mm(line);
    for (const auto& [words, ends] : strips) {
      const Point3 x = ends({y});
      if (y < std::stod(words[1]) || y > std::stod(words[2]) || x.x >= x.y) continue;
      model.spans.push_back({line, x.x, x.y, static_cast<std::uint32_t>(std::stoul(words[0]))});
    }
  }
  std::string all;
  for (const Region& region : areas_of_spans(model)) {
    all += (all.empty() ? "" : "; ") + std::to_string(region.face) + ":";
    for (const auto& contour : region.contours)
      for (const Point2 p : contour)
        all += " " + test::as_text(std::round(p.x * 100) / 100) + "," + test::as_text(std::round(p.y * 100) / 100);
  }
  return all;
}

[[maybe_unused]] const bool areas_are_added =
    test::add_function_scripts(LIGNE_SOURCE_DIR "/tests/drawing/areas", {{"areas", areas_of_text}});

TEST(SpanAreas, OfNothing) { EXPECT_TRUE(areas_of_spans({}).empty()); }

// Spans as gray pixels.

SpanModel spans() {
  SpanModel m;
  m.lines = {0.5, 1, 16};
  for (std::uint32_t line = 0; line < 16; ++line) {
    m.spans.push_back({line, 2, 6, 0});
    m.spans.push_back({line, 6, 9.5, 1});
    m.spans.push_back({line, 12, 14, 2});
  }
  return m;
}

/// Three faces: black, gray and white.
const auto kTone = [](SeenFace seen, Point2) { return std::array{std::array{0.0, 0.6, 1.0}.at(seen.face)}; };
using Gray = std::vector<std::uint8_t>;

/// These pixels, each by its number and what it has.
void expect_pixels(const FacePicture& picture, std::initializer_list<std::pair<std::size_t, int>> pixels) {
  for (const auto& [number, gray] : pixels) EXPECT_EQ(picture.gray.at(number), gray) << "pixel " << number;
}

TEST(Shading, PixelsAreMixedAtTheEndsOfSpans) {
  const FacePicture p = paint<1>(spans(), kTone, 16, 16, 1);
  ASSERT_EQ(p.gray.size(), 256u);
  // The span covers half of pixel 9.
  expect_pixels(p, {{0, 255}, {2, 0}, {5, 0}, {6, 153}, {9, 204}, {10, 255}, {12, 255}});
}

TEST(Shading, SpansBesideThePictureAreCut) {
  SpanModel m;
  m.lines = {0, 1, 9};
  m.spans = {{0, -5, 100, 0}, {7, 0, 1, 0}};
  const FacePicture p = paint<1>(m, kTone, 3, 2, 1);
  EXPECT_EQ(p.gray, (Gray{0, 0, 0, 255, 255, 255}));
}

TEST(Shading, NothingSeenIsWhite) { EXPECT_EQ(paint<1>(SpanModel{}, kTone, 2, 1, 1).gray, (Gray{255, 255})); }

/// Two by two pixels of a millimetre, the first at (1, 1) of the page; nothing is seen in the last.
PixelModel pixels() { return {2, 2, {1, 1}, 1, {0, 1, 2, 0xffffffffu}, {0, 0, 0, 0}}; }

TEST(Shading, PixelsOfTheSameSizeAreCopied) {
  EXPECT_EQ(paint<1>(pixels(), kTone, 4, 3, 1).gray, (Gray{255, 255, 255, 255, 255, 0, 153, 255, 255, 255, 255, 255}));
}

TEST(Shading, PixelsOfAnotherSizeAreMixed) {
  // The one pixel of 4 mm covers all four: 1 - (1 + 0.4) / 16.
  EXPECT_EQ(paint<1>(pixels(), kTone, 1, 1, 0.25).gray, (Gray{233}));
  expect_pixels(paint<1>(pixels(), kTone, 8, 6, 2),
                {{2 * 8 + 1, 255}, {2 * 8 + 2, 0}, {3 * 8 + 3, 0}, {3 * 8 + 4, 153}, {3 * 8 + 6, 255}});
}

TEST(Shading, PixelsThatStayWhereTheyLie) {
  PixelModel model = pixels();
  model.pixel_mm = 0.5;
  const FacePicture p = paint_each<1>(model, kTone);
  EXPECT_EQ(p.gray, (Gray{0, 153, 255, 255}));
  EXPECT_EQ(p.width, 2u);
  EXPECT_EQ(p.corner_mm, (Point2{1, 1}));
  EXPECT_EQ(p.pixel_mm, 0.5);
}

/// Lists with the same faces have one number, in one set of layers and in those merged from several.
TEST(TransparentLayers, EqualListsHaveOneNumber) {
  TransparentLayers layers;
  EXPECT_TRUE(layers.empty());
  const std::uint32_t back = layers.over(7, TransparentLayers::kEmptyList), both = layers.over(3, back);
  EXPECT_EQ(layers.over(7, TransparentLayers::kEmptyList), back);
  EXPECT_EQ(layers.over(3, back), both);
  EXPECT_NE(layers.over(3, TransparentLayers::kEmptyList), both);
  std::vector<std::uint32_t> faces;
  layers.for_each(both, [&](std::uint32_t face) { faces.push_back(face); });
  EXPECT_EQ(faces, (std::vector<std::uint32_t>{3, 7}));
  TransparentLayers other;
  const std::uint32_t same = other.over(3, other.over(7, TransparentLayers::kEmptyList));
  const std::vector<std::uint32_t> numbers = layers.merge(other);
  EXPECT_EQ(numbers[same], both);
  EXPECT_EQ(numbers[TransparentLayers::kEmptyList], TransparentLayers::kEmptyList);
}

/// Two panes of opacity 0.4 and 0.5 before black, and before paper.
TEST(TransparentLayers, ColoursAreComposedFromFrontToBack) {
  TransparentLayers layers;
  const std::uint32_t list = layers.over(1, layers.over(2, TransparentLayers::kEmptyList));
  const std::array<std::array<double, 3>, 3> colors = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0.5}}};
  const std::array<double, 3> opacities = {1, 0.4, 0.5};
  const auto seen = [&](std::uint32_t face) {
    return seen_color<3>(
        layers, {face, list}, [&](auto f) { return colors[f]; }, [&](auto f) { return opacities[f]; });
  };
  const std::array<double, 3> expected = {0.4, 0.3, 0.15};
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_NEAR(seen(0)[c], expected[c], 1e-15);
    EXPECT_NEAR(seen(kNone)[c], expected[c] + 0.3, 1e-15);
  }
}

/// Spans of one face behind different lists make different areas; pixels make spans likewise.
TEST(SpanAreas, EndWhereTheTransparentFacesInFrontDo) {
  SpanModel model{{0.5, 1, 10}, {}};
  const std::uint32_t pane = model.layers.over(4, TransparentLayers::kEmptyList);
  for (std::uint32_t line = 0; line < 10; ++line) {
    model.spans.push_back({line, 0, 3, 1});
    model.spans.push_back({line, 3, 5, 1, pane});
    model.spans.push_back({line, 5, 8, kNone, pane});
  }
  const std::vector<Region> areas = areas_of_spans(model);
  ASSERT_EQ(areas.size(), 3u);
  for (const Region& area : areas) {
    const double left = area.contours[0][0].x;
    EXPECT_EQ(area.in_front, left < 3 ? TransparentLayers::kEmptyList : pane);
    EXPECT_EQ(area.face, left < 5 ? 1 : kNone);
  }
  PixelModel pixels{4, 1, {0, 0}, 1, {1, 1, kNone, kNone}, {0, 0, 0, 0}};
  pixels.layers = model.layers;
  pixels.in_front = {0, pane, pane, 0};
  const SpanModel spans = spans_of_pixels(pixels);
  ASSERT_EQ(spans.spans.size(), 3u);
  EXPECT_EQ(spans.spans[0].in_front, TransparentLayers::kEmptyList);
  EXPECT_EQ(spans.spans[1].in_front, pane);
  EXPECT_EQ(spans.spans[2].face, kNone);
}

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
