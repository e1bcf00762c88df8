/// Axes and their ticks.

#include "drawing/measures.hpp"
#include "main/script.hpp"
#include "plotting/stroke_text.hpp"
#include "support/scenes.hpp"
#include "view/axes/axes_layout.hpp"
#include "view/axes/axis_edges.hpp"
#include "view/axes/axis_lines.hpp"
#include "view/axes/ticks.hpp"
#include "view/brightness.hpp"

namespace ligne::test {
namespace {

// Axes of plots: the box as seen, and what stands round it.

constexpr double kCoincidenceMm = 0.00025;
constexpr double kHeight = 2.5;
const Rect kSheet{{0, 0}, {297, 210}};

TextExtent measure(std::string_view text, double height) { return text_extent(text, height, TextStyle::font); }

AxesRequest request(AxesStyle style = AxesStyle::back) {
  AxesRequest r;
  r.axes[0] = {-12, 12, 1, 0, "x", TickScale::linear};
  r.axes[1] = {-7, 20, 1, 0, "Distance from the coast (km)", TickScale::linear};
  r.axes[2] = {-0.217, 1, 10, 0, "Height", TickScale::linear};
  r.style = style;
  r.text_height_mm = kHeight;
  return r;
}

Point3 direction(double azimuth, double elevation) {
  const double degree = std::numbers::pi / 180, a = azimuth * degree, e = elevation * degree;
  return {-std::cos(a) * std::cos(e), -std::sin(a) * std::cos(e), -std::sin(e)};
}

View seen(const AxesBox& box, const CameraRequest& camera) {
  const Scene scene = box_scene(box);
  return make_view(scene, make_camera(camera, scene), {{{40, 40}, {257, 170}}}, kSheet);
}
View seen_from(const AxesBox& box, double azimuth, double elevation) {
  return seen(box, along(direction(azimuth, elevation)));
}
View seen_by(const AxesBox& box, const Point3& eye) {
  CameraRequest camera;
  camera.eye = eye;
  return seen(box, camera);
}

/// The box lies outside the convex hull of the picture of the axes' box: one of the hull's lines parts them.
bool beside_picture(const TextBox& text, const std::array<Point2, 8>& corners) {
  std::vector<Point2> normals;
  for (const Point2 a : corners)
    for (const Point2 b : corners) {
      const double length = glm::distance(a, b);
      if (length > 1e-3) normals.push_back(Point2(b.y - a.y, a.x - b.x) / length);
    }
  for (const Point2 n : normals) {
    double most = -1e300;
    for (const Point2 c : corners) most = std::max(most, glm::dot(c, n));
    if (glm::dot(text.center, n) - text.reach(n) > most) return true;
  }
  return false;
}

/// The picture of the axes, whose texts overlap neither each other nor the box as it is seen.
AxesPicture clear_picture(const AxesRequest& request, const View& view) {
  AxesPicture picture = lay_out_axes(request, view, measure);
  EXPECT_EQ(picture.boxes.size(), picture.texts.size());
  std::array<Point2, 8> corners;
  for (unsigned i = 0; i < 8; ++i) corners[i] = page_point(view, request.box().corner(i));
  for (std::size_t i = 0; i < picture.boxes.size(); ++i) {
    EXPECT_TRUE(beside_picture(picture.boxes[i], corners)) << picture.texts[i].text;
    for (std::size_t k = 0; k < i; ++k)
      EXPECT_FALSE(overlap(picture.boxes[i], picture.boxes[k])) << picture.texts[i].text << " on " << picture.texts[k].text;
  }
  return picture;
}

TEST(Axes, TextsNeverOverlapEachOtherNorThePicture) {
  for (const double height : {1.5, kHeight, 6.0}) {
    AxesRequest r = request();
    r.text_height_mm = height;
    for (int azimuth = 0; azimuth <= 360; azimuth += 15) {
      for (int elevation = -90; elevation <= 90; elevation += 15) {
        SCOPED_TRACE("azimuth " + std::to_string(azimuth) + " elevation " + std::to_string(elevation));
        const View view = seen_from(r.box(), azimuth, elevation);
        const AxesPicture picture = clear_picture(r, view);
        const AxisEdges edges = choose_axis_edges(r.box(), view, height);
        if (height <= kHeight || std::abs(elevation) != 75) {  // foreshortened that much, z has no room for the largest text
          EXPECT_EQ(picture.has_scale[2], std::abs(elevation) < 90) << "from straight above there is no z axis";
        }
        const bool x_end_on = elevation == 0 && azimuth % 180 == 0, y_end_on = elevation == 0 && azimuth % 180 == 90;
        EXPECT_EQ(picture.has_scale[0], !x_end_on);
        EXPECT_EQ(picture.has_scale[1], !y_end_on);
        for (unsigned k = 0; k < 3; ++k) {
          const bool named = std::any_of(picture.texts.begin(), picture.texts.end(),
                                         [&](const TextItem& t) { return t.text == r.axes[k].name; });
          EXPECT_EQ(named, edges[k].has_value()) << r.axes[k].name;
        }
      }
    }
  }
}

TEST(Axes, NearlyEdgeOnIsNoException) {
  const AxesRequest r = request();
  for (const double azimuth : {-90 + 1e-9, 1e-6, 0.01, 179.999, 44.0, 45.0, 269.5})
    for (const double elevation : {1e-9, 0.01, -0.3, 1.0, 89.0, 89.9999, -89.9}) {
      SCOPED_TRACE(std::to_string(azimuth) + " " + std::to_string(elevation));
      clear_picture(r, seen_from(r.box(), azimuth, elevation));
    }
}

TEST(Axes, Perspective) {
  const AxesRequest r = request();
  for (int azimuth = 0; azimuth < 360; azimuth += 15)
    for (int elevation = -85; elevation <= 85; elevation += 17) {
      SCOPED_TRACE("azimuth " + std::to_string(azimuth) + " elevation " + std::to_string(elevation));
      const AxesBox box = r.box();
      const Point3 eye = (box.low + box.high) * 0.5 - direction(azimuth, elevation) * 80.0;
      const AxesPicture picture = clear_picture(r, seen_by(box, eye));
      EXPECT_TRUE(picture.has_scale[0] || picture.has_scale[1]);
    }
}

TEST(Axes, ABoxThatReachesBehindTheViewerHasNoScale) {
  const AxesRequest r = request(AxesStyle::grid);
  for (const Point3 eye : {Point3{0, 0, 3}, Point3{12, 7, 3}, Point3{13, 7, 3}}) {
    const View view = seen_by(r.box(), eye);
    const AxesPicture picture = lay_out_axes(r, view, measure);
    EXPECT_TRUE(picture.texts.empty());
    axis_lines(picture.lines, view, {}, kCoincidenceMm);
  }
}

TEST(Axes, FlatBoxesAndPoints) {
  AxesRequest r = request(AxesStyle::grid);
  r.axes[2].from = r.axes[2].to = 3;
  for (const double elevation : {0.0, 30.0, 90.0}) {
    const AxesPicture picture = clear_picture(r, seen_from(r.box(), -60, elevation));
    EXPECT_FALSE(picture.has_scale[2]);
    EXPECT_TRUE(picture.has_scale[0]);
  }
  for (auto& axis : r.axes) axis.from = axis.to = 1;
  EXPECT_TRUE(lay_out_axes(r, seen_from(r.box(), -60, 30), measure).texts.empty());
}

TEST(Axes, TheUsualViewHasItsScalesWhereOneLooksForThem) {
  const AxesRequest r = request();
  const View view = seen_from(r.box(), -60, 30);
  const AxisEdges edges = choose_axis_edges(r.box(), view, kHeight);
  ASSERT_TRUE(edges[0] && edges[1] && edges[2]);
  EXPECT_EQ(edges[0]->corner, 0u) << "x on the ground in front, at low y";
  EXPECT_EQ(edges[1]->corner, 1u) << "y on the ground at the right, at high x";
  EXPECT_EQ(edges[2]->corner, 0u) << "z at the left";
  const AxisEdges from_above = choose_axis_edges(r.box(), seen_from(r.box(), -40, 80), kHeight);
  ASSERT_TRUE(from_above[0] && from_above[1] && from_above[2]);
  EXPECT_EQ(from_above[0]->corner, 0u) << "also beside a z axis that is short";
  EXPECT_EQ(from_above[1]->corner, 1u);
  const AxesPicture picture = lay_out_axes(r, view, measure);
  std::vector<std::string> texts;
  for (const TextItem& item : picture.texts) texts.push_back(item.text);
  const std::vector<std::string> x{"−10", "−5", "0", "5", "10"};
  ASSERT_GE(texts.size(), x.size());
  EXPECT_TRUE(std::equal(x.begin(), x.end(), texts.begin()));
  EXPECT_NE(std::find(texts.begin(), texts.end(), "0.8"), texts.end()) << "heights are told unscaled";
}

TEST(Axes, TicksStandAtTheirNumbers) {
  const AxesRequest r = request();
  const View view = seen_from(r.box(), -60, 30);
  const AxesPicture picture = lay_out_axes(r, view, measure);
  const auto has_mark = [&](const Point3& p) {
    const Point2 at = page_point(view, p);
    return std::any_of(picture.marks.begin(), picture.marks.end(),
                       [&](const auto& m) { return glm::distance(m[0], at) < 1e-9; });
  };
  EXPECT_TRUE(has_mark({-10, -7, -2.17}));
  EXPECT_TRUE(has_mark({10, -7, -2.17}));
  EXPECT_TRUE(has_mark({12, 15, -2.17}));
  EXPECT_TRUE(has_mark({-12, -7, 8})) << "0.8 times the factor 10";
  EXPECT_FALSE(has_mark({-9, -7, -2.17}));
}

TEST(Axes, SidesBehindThePicture) {
  const AxesBox box{{0, 0, 0}, {1, 2, 3}};
  Camera camera;
  camera.forward = glm::normalize(Point3{-1, 2, -0.5});
  EXPECT_EQ(back_sides(box, camera), (BoxSides{{{true, false}, {false, true}, {true, false}}}));
  camera.perspective = true;
  camera.eye = {0.5, -1, 5};
  EXPECT_EQ(back_sides(box, camera), (BoxSides{{{true, true}, {false, true}, {true, false}}}));
  camera.eye = {0.5, 1, 1};
  EXPECT_EQ(back_sides(box, camera), (BoxSides{{{true, true}, {true, true}, {true, true}}})) << "from within all are seen";
}

std::array<std::size_t, 2> line_count(AxesStyle style, double azimuth, double elevation) {
  const AxesPicture picture = lay_out_axes(request(style), seen_from(request().box(), azimuth, elevation), measure);
  return {picture.lines.size(), picture.front_lines.size()};
}

TEST(Axes, StylesHaveTheirEdges) {
  using Counts = std::array<std::size_t, 2>;  // behind and before
  EXPECT_EQ(line_count(AxesStyle::back, -60, 30), (Counts{9, 0})) << "all but the three that meet at the nearest corner";
  EXPECT_EQ(line_count(AxesStyle::box, -60, 30), (Counts{9, 3}));
  EXPECT_EQ(line_count(AxesStyle::base, -60, 30), (Counts{5, 0}));
  EXPECT_EQ(line_count(AxesStyle::base, -60, -30), (Counts{3, 2})) << "from below the ground's nearer edges are in front";
  EXPECT_EQ(line_count(AxesStyle::base, -60, 90)[0] + line_count(AxesStyle::base, -60, 90)[1], 4u);
  EXPECT_GT(line_count(AxesStyle::grid, -60, 30)[0], 9u + 3 * 4);
}

TEST(AxisLines, AreDrawnOnce) {
  // Straight from the front the box is a rectangle: 12 edges, 4 of them end on, the others in pairs.
  const AxesBox box = request().box();
  const View view = seen_from(box, -90, 0);
  const AxesPicture picture = lay_out_axes(request(AxesStyle::box), view, measure);
  std::vector<AxisLine> lines = picture.lines;
  lines.insert(lines.end(), picture.front_lines.begin(), picture.front_lines.end());
  ASSERT_EQ(lines.size(), 12u);
  const Point2 a = page_point(view, box.low), b = page_point(view, box.high);
  EXPECT_NEAR(length_of(axis_lines(lines, view, {}, kCoincidenceMm)), 2 * (std::abs(b.x - a.x) + std::abs(b.y - a.y)), 1e-3);
}

TEST(AxisLines, OnlyTheirVisibleParts) {
  const AxesBox box = request().box();
  const View view = seen_from(box, -60, 30);
  const std::vector<AxisLine> lines{{box.low, {box.high.x, box.low.y, box.low.z}},
                                    {box.low, {box.low.x, box.low.y, box.high.z}}};
  const double whole = length_of(axis_lines({lines.data(), 1}, view, {}, kCoincidenceMm));
  std::size_t asked = 0;
  const auto halves = [&](std::span<const AxisLine> given) {
    asked = given.size();
    return std::vector<std::vector<VisibleInterval>>{{{0.25, 0.5}, {0.75, 1}}, {}};
  };
  const auto part = axis_lines(lines, view, halves, kCoincidenceMm);
  EXPECT_EQ(asked, 2u);
  ASSERT_EQ(part.size(), 2u);
  EXPECT_NEAR(length_of(part), whole / 2, 1e-5);
}

TEST(AxisLines, IntervalsAreInSpaceAlsoInPerspective) {
  const AxesBox box = request().box();
  const View view = seen_by(box, {40, -60, 30});
  const AxisLine line{{box.high.x, box.low.y, 0}, {box.low.x, box.high.y, 0}};
  const std::vector<std::vector<VisibleInterval>> seen_half{{{0, 0.5}}};
  const auto half = axis_lines(
      {&line, 1}, view, [&](auto) { return seen_half; }, kCoincidenceMm);
  ASSERT_EQ(half.size(), 1u);
  const Point2 middle = page_point(view, (line.a + line.b) * 0.5);
  EXPECT_LT(std::min(glm::distance(half[0].front(), middle), glm::distance(half[0].back(), middle)), 1e-4);
}

TEST(Title, StandsAboveAndFits) {
  const Rect picture{{40, 50}, {140, 120}};
  const TextItem title = title_above(picture, "Geländeprofil", 4, 200, measure);
  const TextBox box = text_box(title, measure(title.text, title.height_mm));
  EXPECT_DOUBLE_EQ(title.height_mm, 4);
  EXPECT_NEAR(box.center.x, 90, 1e-9);
  EXPECT_LT(box.center.y + box.half.y, 50);
  const TextItem narrow = title_above(picture, "Geländeprofil", 4, 20, measure);
  EXPECT_NEAR(measure(narrow.text, narrow.height_mm).width, 20, 1e-9);
}

// The light at the eye.

/// Seen along a diagonal of the cube all its faces are alike; along (0, 1, 1) four are, and two are edge on.
TEST(Brightness, ParallelIsTheSquareOfTheCosine) {
  Scene scene;
  add_box(scene, {0, 0, 0}, {1, 1, 1});
  for (const double b : face_brightness(scene, make_camera(along({1, 1, 1}), scene))) EXPECT_NEAR(b, 1, 1e-12);
  std::vector<double> found = face_brightness(scene, make_camera(along({0, 1, 1}), scene));
  std::sort(found.begin(), found.end());
  for (std::size_t f = 0; f < 6; ++f) EXPECT_NEAR(found.at(f), f < 2 ? 0 : 1, 1e-12);
}

/// Two plates that look at the eye, one twice as far away: a quarter of the light. One behind the eye gets none.
TEST(Brightness, PerspectiveFallsWithTheSquareOfTheDistance) {
  Scene scene;
  for (const double y : {1.0, 2.0, -1.0}) add_face(scene, {{{-1, y, -1}, {1, y, -1}, {1, y, 1}, {-1, y, 1}}});
  const std::vector<double> b = face_brightness(scene, make_camera(from_eye({0, 0, 0}, {0, 1, 0}), scene));
  EXPECT_NEAR(b[0], 1, 1e-12);
  EXPECT_NEAR(b[1], 0.25, 1e-12);
  EXPECT_EQ(b[2], 0);
}

/// With lights: the mean of the cosines, without those that do not reach the face or stand behind it. Without: the light at
/// the eye.
TEST(Brightness, LightsGiveTheMeanOfTheirCosines) {
  Scene scene;
  add_face(scene, {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}});
  const Camera camera = make_camera(along({0, 1, -1}), scene);
  const std::vector<Light> lights{
      {Light::Kind::parallel, {0, 0, -2}}, {Light::Kind::parallel, {1, 0, -1}}, {Light::Kind::parallel, {0, 0, 1}}};
  const FaceLight light(scene, camera, lights);
  const double slanted = std::sqrt(0.5);
  EXPECT_NEAR(light.of(0), (1 + slanted) / 3, 1e-12);
  EXPECT_NEAR(light.of(0, 0b110), slanted / 3, 1e-12);
  EXPECT_EQ(light.of(0, 0), 0);
  const std::vector<Light> above{{Light::Kind::point, {0, 0, 5}}};
  EXPECT_NEAR(FaceLight(scene, camera, above).of(0), 1, 1e-12);
  EXPECT_EQ(FaceLight(scene, camera, {}).of(0), face_brightness(scene, camera)[0]);
}

// Ticks at round numbers, and their text.

/// Labels of the ticks of "FROM TO MOST": values/ticks.txt.
std::string labels(TickScale scale, const std::string& text, double (*end)(double)) {
  const std::vector<std::string> words = test::words_of(text);
  std::string all;
  for (const Tick& tick :
       round_ticks(scale, end(test::value_of(words.at(0))), end(test::value_of(words.at(1))), std::stoul(words.at(2))))
    all += (all.empty() ? "" : " ") + tick.label;
  return all;
}
double itself(double x) { return x; }
double exponent(double x) { return std::log10(x); }

const test::TextFunctions kFunctions{
    {"linear", [](auto& t) { return labels(TickScale::linear, t, itself); }},
    {"decades", [](auto& t) { return labels(TickScale::decades, t, itself); }},
    {"decades-of", [](auto& t) { return labels(TickScale::decades, t, exponent); }},
};

[[maybe_unused]] const bool values_are_added = test::add_function_scripts(LIGNE_SOURCE_DIR "/tests/view/values", kFunctions);

TEST(Ticks, OfExtremesAndOfRoundedEndsLieWithinTheRange) {
  const double largest = std::numeric_limits<double>::max(), least = std::numeric_limits<double>::denorm_min();
  for (const auto& [from, to] : {std::pair{-largest, largest},
                                 {0.0, largest},
                                 {0.0, least},
                                 {-least, least},
                                 {0.0, 1e-310},
                                 {-largest, 0.0},
                                 {largest / 2, largest},
                                 {-1.0, largest},
                                 {0.1 + 0.2, 1.1 - 0.2}}) {
    for (const std::size_t most : {1u, 2u, 5u, 11u})
      for (const TickScale scale : {TickScale::linear, TickScale::decades})
        for (const Tick& tick : round_ticks(scale, from, to, most)) EXPECT_TRUE(from <= tick.at && tick.at <= to);
  }
}

TEST(Ticks, Decades) {
  const auto ticks = round_ticks(TickScale::decades, 0, 1, 5);
  ASSERT_EQ(ticks.size(), 4u);
  EXPECT_DOUBLE_EQ(ticks[1].at, std::log10(2));
  EXPECT_DOUBLE_EQ(ticks[3].at, 1);
}

TEST(Ticks, AscendWithinTheRangeAndAreNoMoreThanAsked) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> mantissa(-10, 10), exponent(-12, 12);
  for (int i = 0; i < 2000; ++i) {
    const double scale = std::pow(10, exponent(random));
    double a = mantissa(random) * scale, b = mantissa(random) * scale;
    if (a > b) std::swap(a, b);
    for (const std::size_t most : {1u, 3u, 4u, 7u, 11u}) {
      const auto ticks = round_ticks(TickScale::linear, a, b, most);
      EXPECT_LE(ticks.size(), most);
      if (most >= 4) {
        EXPECT_GE(2.5 * static_cast<double>(ticks.size() + 1), static_cast<double>(most))
            << a << " to " << b << ": a step of 1, 2 or 5 fills more";
      }
      for (std::size_t k = 0; k < ticks.size(); ++k) {
        EXPECT_TRUE(a <= ticks[k].at && ticks[k].at <= b);
        if (k > 0) {
          EXPECT_LT(ticks[k - 1].at, ticks[k].at);
        }
        test::expect_no_parts(ticks[k].label, {"0000000"});
      }
    }
  }
}

}  // namespace
}  // namespace ligne::test
