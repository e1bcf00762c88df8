// Labels of contour lines, on ten terrains at three scales, in both styles of text.

#include "drawing/measures.hpp"
#include "geometry/search/nearest_points.hpp"
#include "main/script.hpp"
#include "picture/marks/contour_labels.hpp"
#include "picture/marks/point_marks.hpp"
#include "picture/parse/parse_terrain.hpp"
#include "picture/surface/surface_picture.hpp"
#include "plotting/stroke_text.hpp"
#include "support/line_text.hpp"
#include "support/test.hpp"

namespace ligne {
namespace {

constexpr double kOnLineMm = 0.1;

constexpr const char* kTerrains[] = {
    "800*exp(-r^2/9)",
    "600*exp(-((x-2)^2+y^2)/4)+500*exp(-((x+2)^2+(y-1)^2)/6)",
    "300*(1-abs(sin(0.8*x+0.6*sin(0.9*y))))*(1-abs(sin(0.9*y+0.7*sin(0.8*x))))",
    "900*exp(-(r-2.2)^2/1.6)-180*exp(-((x-2.5)^2+(y+1)^2))",
    "120*x+40*sin(3*y)",
    "30*sin(2*x)*cos(3*y)+10*x*y",
    "500/(1+x^2+4*y^2)+60*sin(4*x)",
    "250*tanh(x-0.3*y^2)+15*sin(5*y+2*x)",
    "200*sinc(r)+20*cos(x*y)",
    "0.02*(x^2+y^2)^2*100-80*x^2",
};

Drawing contours_of(const char* formula, const char* page, RunReport& run) {
  SurfaceRequest request;
  request.formulas = {formula};
  request.x = CurveRange{-5, 5, 61};
  request.y = CurveRange{-4, 4, 61};
  request.samples = 121;
  request.lines = CurveFamilies::none;
  request.curves.contours = 25;
  request.curves.index_contours = 5;
  request.picture.view.named_view = "top";
  request.picture.page.size.page = parse_page(page);
  std::vector<Surface> surfaces = surfaces_of(request, run);
  const auto drawn = draw_horizon(request, surfaces, run);
  EXPECT_TRUE(drawn) << formula;
  return drawn ? drawn->drawing : Drawing{};
}

/// The distance of a label from the nearest contour line that has its height.
double off_its_line(const Drawing& drawing, const TextItem& label, double step) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Layer& layer : drawing.layers) {
    if (!layer.height || height_text(*layer.height, step, false) != label.text) continue;
    nearest = std::min(nearest, test::distance_to_lines(label.at, layer.lines));
  }
  return nearest;
}

double step_of(const Drawing& drawing) {
  std::vector<double> heights;
  for (const Layer& layer : drawing.layers)
    if (layer.height) heights.push_back(*layer.height);
  std::sort(heights.begin(), heights.end());
  double step = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < heights.size(); ++i) step = std::min(step, heights[i] - heights[i - 1]);
  return step;
}

/// Whether a point lies inside the box, by more than `slack`.
bool is_inside(const TextBox& box, Point2 p, double slack) {
  const auto axes = box.axes();
  return std::abs(glm::dot(p - box.center, axes[0])) < box.half.x - slack &&
         std::abs(glm::dot(p - box.center, axes[1])) < box.half.y - slack;
}

class Labels : public testing::TestWithParam<std::tuple<const char*, const char*, TextStyle>> {};

TEST_P(Labels, KeepApartEachOnItsOwnLine) {
  const auto [formula, page, style] = GetParam();
  RunReport run;
  std::size_t opposite = 0, pairs = 0;
  const Drawing plain = contours_of(formula, page, run);
  for (const bool index_only : {true, false}) {
    Drawing drawing = plain;
    ContourLabelOptions options;
    options.style = style;
    options.index_only = index_only;
    options.page = parse_page(page).sheet();
    const std::vector<TextItem> labels = label_contours(drawing, options, {});
    // 25 contours that all have labels may leave no room on A6
    if (index_only) {
      EXPECT_GT(labels.size(), 0u);
    }
    std::vector<TextBox> boxes;
    for (const TextItem& label : labels) {
      EXPECT_LE(off_its_line(plain, label, step_of(plain)), kOnLineMm) << label.text;
      EXPECT_TRUE(std::abs(label.rotation_degrees) <= 115)
          << "is readable, and leans no more beyond upright than 25 degrees";
      const TextBox box = text_box(label, text_extent(label.text, label.height_mm, style));
      for (const TextBox& other : boxes) EXPECT_FALSE(overlap(box, other)) << label.text;
      boxes.push_back(box);
      EXPECT_TRUE(label.text.find_first_of("123456789") != std::string::npos || label.text == "0")
          << "a zero without a sign";
      for (const TextItem& other : labels) {
        if (&other == &label || glm::distance(other.at, label.at) > 5 * label.height_mm) continue;
        ++pairs;
        opposite += std::abs(std::remainder(label.rotation_degrees - other.rotation_degrees, 360)) > 150;
      }
    }
    for (const Layer& layer : drawing.layers) {
      if (!layer.height) continue;
      test::for_segments(layer.lines, [&](Point2 a, Point2 b) {
        for (const TextBox& box : boxes) EXPECT_FALSE(is_inside(box, (a + b) / 2.0, 1e-6));
      });
    }
  }
  EXPECT_LE(opposite, pairs / 20) << "neighbours are read alike";
}

INSTANTIATE_TEST_SUITE_P(Terrains, Labels,
                         testing::Combine(testing::ValuesIn(kTerrains), testing::Values("A6", "A4", "A2"),
                                          testing::Values(TextStyle::font, TextStyle::stroke)));

/// "CONTOURS LOW HIGH": the levels.
std::string levels(const std::string& text) {
  const std::vector<std::string> words = test::words_of(text);
  CurveRequest curves;
  parse_contours(words.at(0), curves);
  std::string all;
  for (const double level : contour_levels(curves, test::value_of(words.at(1)), test::value_of(words.at(2)), false))
    all += (all.empty() ? "" : " ") + test::as_text(level);
  return all;
}

/// "HEIGHT STEP"
std::string height(const std::string& text) {
  const std::vector<std::string> words = test::words_of(text);
  return height_text(test::value_of(words.at(0)), test::value_of(words.at(1)), false);
}

[[maybe_unused]] const bool values_are_added =
    test::add_function_scripts(LIGNE_SOURCE_DIR "/tests/picture/values", {{"levels", levels}, {"height", height}});

TEST(WithoutBoxes, ARingThatIsCutBecomesOneLine) {
  const Polylines ring = test::lines_of_text("0,0 10,0 10,10 0,10 0,0");
  const std::vector<TextBox> boxes{{{10, 5}, {1, 2}, 0}};
  const Polylines cut = without_boxes(ring, boxes);
  ASSERT_EQ(cut.size(), 1u);
  EXPECT_EQ(cut[0].front(), (Point2{10, 7}));
  EXPECT_EQ(cut[0].back(), (Point2{10, 3}));
  EXPECT_EQ(cut[0].size(), 6u);
}

// Marks and labels of points, against a search through all boxes.

constexpr double kHeight = 2.5;
constexpr double kRadius = 0.45 * kHeight;  ///< half the side of a mark

/// A page seen from above, whose millimetres are those of the model.
View flat_view() {
  View view;
  view.window = {{0, 0}, {200, 200}};
  return view;
}

/// `crowd` of the points lie within a millimetre.
std::vector<MarkedPoint> random_points(std::size_t count, std::size_t crowd) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> page(0, 200), near(0, 1);
  std::vector<MarkedPoint> points(count);
  for (std::size_t i = 0; i < count; ++i) {
    points[i].at = i < crowd ? Point3{90 + near(random), 90 + near(random), 0} : Point3{page(random), page(random), 0};
    points[i].label = std::string(1 + i % 9, 'n');
    if (i % 17 == 0) points[i].label.clear();
  }
  return points;
}

TEST(PointMarks, LabelsOverlapNothingAndNoPlaceIsLeft) {
  const View view = flat_view();
  const std::vector<MarkedPoint> points = random_points(600, 200);
  std::vector<std::uint8_t> seen(points.size(), 1);
  for (std::size_t i = 0; i < seen.size(); i += 13) seen[i] = 0;
  const std::vector<TextItem> taken{{"taken already", {100, 100}, 5, TextAcross::center, TextUp::middle, 30}};
  Drawing drawing;
  const auto labels = mark_points(drawing, points, seen, view, {kHeight, TextStyle::font}, taken);
  ASSERT_EQ(drawing.layers.size(), 1u);
  std::vector<TextBox> boxes{text_box(taken[0], text_extent(taken[0].text, taken[0].height_mm, TextStyle::font))};
  std::size_t marks = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!seen[i]) continue;
    boxes.push_back({page_point(view, points[i].at), {kRadius, kRadius}, 0});
    ++marks;
  }
  EXPECT_EQ(drawing.layers[0].lines.size(), 2 * marks);
  EXPECT_GT(labels.size(), 50u);
  EXPECT_LT(labels.size(), marks);
  for (const TextItem& label : labels) {
    const TextBox box = text_box(label, text_extent(label.text, kHeight, TextStyle::font));
    for (const TextBox& other : boxes) ASSERT_FALSE(overlap(other, box)) << label.text;
    boxes.push_back(box);
  }
  // A point without a label has no place to the right of it, above its middle.
  std::size_t next = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!seen[i] || points[i].label.empty()) continue;
    const Point2 p = page_point(view, points[i].at);
    const bool has_label = next < labels.size() && labels[next].text == points[i].label &&
                           std::hypot(labels[next].at.x - p.x, labels[next].at.y - p.y) < 0.86 * std::sqrt(2) * kHeight;
    if (has_label) {
      ++next;
      continue;
    }
    const TextItem item{points[i].label, p + Point2{0.85, -0.85} * kHeight, kHeight, TextAcross::left, TextUp::base, 0};
    const TextBox box = text_box(item, text_extent(item.text, kHeight, TextStyle::font));
    ASSERT_TRUE(std::any_of(boxes.begin(), boxes.end(), [&](const TextBox& other) { return overlap(other, box); })) << i;
  }
  EXPECT_EQ(next, labels.size()) << "labels come in the order of their points";
}

TEST(NearestPoints, FindsPointsInABoxAsALookAtAllPoints) {
  std::mt19937 random(5);
  std::uniform_int_distribution<int> place(0, 40);
  for (const std::size_t count : {0, 1, 8, 9, 500}) {
    std::vector<Point2> points;
    for (std::size_t i = 0; i < count; ++i) {
      const Point2 p{place(random) * 0.5, place(random) * 0.5};
      points.insert(points.end(), i % 5 == 0 ? 12 : 1, p);
    }
    const NearestPoints tree(points);
    for (int k = 0; k < 2000; ++k) {
      const Point2 center{place(random) * 0.5, place(random) * 0.5}, half{place(random) * 0.05, place(random) * 0.05};
      const bool expected = std::any_of(points.begin(), points.end(), [&](Point2 p) {
        return std::abs(p.x - center.x) < half.x && std::abs(p.y - center.y) < half.y;
      });
      ASSERT_EQ(tree.any_within(center, half), expected) << count << ", " << k;
    }
  }
}

}  // namespace
}  // namespace ligne
