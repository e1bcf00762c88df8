// Labels of contour lines, on ten terrains at three scales, in both styles of text.

#include "picture/marks/contour_labels.hpp"
#include "picture/parse/parse_terrain.hpp"
#include "picture/surface/surface_picture.hpp"
#include "support/page_lines.hpp"
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
    for (std::size_t i = 0; i < layer.lines.size(); ++i) {
      const auto line = layer.lines[i];
      for (std::size_t k = 1; k < line.size(); ++k)
        nearest = std::min(nearest, test::distance_to_segment(label.at, line[k - 1], line[k]));
    }
  }
  return nearest;
}

double step_of(const Drawing& drawing) {
  std::vector<double> heights;
  for (const Layer& layer : drawing.layers) {
    if (layer.height) heights.push_back(*layer.height);
  }
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
    }
    for (const Layer& layer : drawing.layers) {
      if (!layer.height) continue;
      for (std::size_t i = 0; i < layer.lines.size(); ++i) {
        const auto line = layer.lines[i];
        for (std::size_t k = 1; k < line.size(); ++k) {
          for (const TextBox& box : boxes) EXPECT_FALSE(is_inside(box, (line[k - 1] + line[k]) / 2.0, 1e-6));
        }
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Terrains, Labels,
                         testing::Combine(testing::ValuesIn(kTerrains), testing::Values("A6", "A4", "A2"),
                                          testing::Values(TextStyle::font, TextStyle::stroke)));

/// The number that a label says.
double number_of(std::string text) {
  if (text.rfind("\u2212", 0) == 0) text.replace(0, 3, "-");
  return std::stod(text);
}

/// A random surface over a random ground, whose heights have any size.
SurfaceRequest random_surface(std::mt19937& random) {
  const auto between = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); };
  const double size = std::pow(10.0, between(-5, 5));
  std::ostringstream formula;
  formula << size << "*(sin(" << between(0.3, 2) << "*x+" << between(-1, 1) << "*y)*cos(" << between(0.3, 2) << "*y)+"
          << between(-0.5, 0.5) << "*x+" << between(-30, 30) << ")";
  SurfaceRequest request;
  request.formulas = {formula.str()};
  request.x = CurveRange{between(-6, -1), between(1, 6), 16};
  request.y = CurveRange{between(-6, -1), between(1, 6), 16};
  request.samples = 31;
  request.lines = CurveFamilies::none;
  request.curves.contours = std::uniform_int_distribution<unsigned>(2, 40)(random);
  request.curves.labels = ContourLabels::all;
  request.picture.view.named_view = "top";
  request.picture.axes.style = AxesStyle::back;
  return request;
}

TEST(Labels, EqualTheirLevelsOnRandomSurfaces) {
  std::mt19937 random(7);
  std::size_t labels = 0, opposite = 0, pairs = 0;
  for (int run_number = 0; run_number < 200; ++run_number) {
    const SurfaceRequest request = random_surface(random);
    RunReport run;
    std::vector<Surface> surfaces = surfaces_of(request, run);
    const auto drawn = draw_horizon(request, surfaces, run);
    ASSERT_TRUE(drawn) << request.formulas.front();
    const Drawing& drawing = drawn->drawing;
    const double step = step_of(drawing);
    std::vector<TextItem> contour_labels;
    std::vector<TextBox> boxes;
    for (const TextItem& text : drawing.texts) {
      boxes.push_back(text_box(text, text_extent(text.text, text.height_mm, TextStyle::font)));
      for (std::size_t k = 0; k + 1 < boxes.size(); ++k) EXPECT_FALSE(overlap(boxes[k], boxes.back())) << text.text;
      if (text.height_mm < drawing.texts.back().height_mm) contour_labels.push_back(text);
    }
    for (const TextItem& label : contour_labels) {
      ++labels;
      const double says = number_of(label.text);
      const TextBox gap = label_box(label, TextStyle::font);
      double nearest = std::numeric_limits<double>::infinity(), height = 0;
      for (const Layer& layer : drawing.layers) {
        for (std::size_t i = 0; layer.height && i < layer.lines.size(); ++i) {
          for (const Point2 p : {layer.lines[i].front(), layer.lines[i].back()}) {
            // The label's own line ends at the short sides of its gap; where lines run close, others do so beside them.
            const Point2 d = p - gap.center;
            const double along = std::abs(std::abs(glm::dot(d, gap.axes()[0])) - gap.half.x);
            const double beside = std::abs(glm::dot(d, gap.axes()[1]));
            if (along + beside < nearest) nearest = along + beside, height = *layer.height;
          }
        }
      }
      EXPECT_NEAR(says, height, 1e-9 * std::abs(height) + 1e-9 * step) << label.text << " of " << request.formulas.front();
      EXPECT_TRUE(says != 0 || label.text == "0") << label.text << ": a zero without a sign";
      for (const TextItem& other : contour_labels) {
        const double turn = std::remainder(label.rotation_degrees - other.rotation_degrees, 360);
        if (&other == &label || glm::distance(other.at, label.at) > 5 * label.height_mm) continue;
        ++pairs;
        if (std::abs(turn) > 150) ++opposite;
      }
    }
  }
  EXPECT_GT(labels, 1000u);
  EXPECT_GT(pairs, 500u);
  EXPECT_LE(opposite, pairs / 200) << "neighbours are read alike";
}

TEST(ContourLevels, AreRoundUnlessAsked) {
  const auto levels = [](const CurveRequest& curves, double low, double high) {
    return contour_levels(curves, low, high, false);
  };
  CurveRequest curves;
  curves.contours = 10;
  EXPECT_EQ(levels(curves, 0.03, 0.97), (std::vector<double>{0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9}));
  EXPECT_EQ(levels(curves, -1.03, 1), (std::vector<double>{-1, -0.8, -0.6, -0.4, -0.2, 0, 0.2, 0.4, 0.6, 0.8}));
  EXPECT_FALSE(std::signbit(levels(curves, -1.03, 1)[5]));
  EXPECT_EQ(levels(curves, 100, 1100), (std::vector<double>{200, 300, 400, 500, 600, 700, 800, 900, 1000})) << "no ends";
  curves.contours = 1;
  EXPECT_EQ(levels(curves, 15.5, 18.4), (std::vector<double>{16, 18})) << "no step has one";
  EXPECT_EQ(levels(curves, 3, 3).size(), 0u);
  curves.contours = 3;
  EXPECT_EQ(levels(curves, 1e15, 1e15 + 4).size(), 3u) << "too near for round numbers";
  curves.even_contours = true;
  EXPECT_EQ(levels(curves, 0.5, 1.5), (std::vector<double>{0.75, 1, 1.25}));
  parse_contours("9:even", curves);
  EXPECT_EQ(levels(curves, 0, 10).size(), 9u);
  parse_contours("7,3,5,99", curves);
  EXPECT_EQ(levels(curves, 0, 10), (std::vector<double>{3, 5, 7}));
  parse_contours("5,", curves);
  EXPECT_EQ(levels(curves, 0, 10), (std::vector<double>{5}));
  EXPECT_THROW(parse_contours("0", curves), std::invalid_argument);
  EXPECT_THROW(parse_contours("a,b", curves), std::invalid_argument);
}

TEST(HeightText, HasTheDigitsThatTellNeighbours) {
  EXPECT_EQ(height_text(-1e-17, 0.1, false), "0");
  EXPECT_EQ(height_text(0.125, 0.125, false), "0.125");
  EXPECT_EQ(height_text(0.12493, 0.125, false), "0.125");
  EXPECT_EQ(height_text(-2e-5, 2e-5, false), "\u22120.00002");
  EXPECT_EQ(height_text(112.5, 2.5, false), "112.5");
  EXPECT_EQ(height_text(3 * 0.1, 0.1, false), "0.3");
  EXPECT_EQ(height_text(94.4615384615, 8.15, false), "94.5");
  EXPECT_EQ(height_text(1234567.8, 1000, false), "1234568");
  EXPECT_EQ(height_text(-50, 10, false), "\u221250");
  EXPECT_EQ(height_text(-0.0, 10, false), "0");
}

TEST(WithoutBoxes, ARingThatIsCutBecomesOneLine) {
  Polylines ring;
  ring.add(std::vector<Point2>{{0, 0}, {10, 0}, {10, 10}, {0, 10}, {0, 0}});
  const std::vector<TextBox> boxes{{{10, 5}, {1, 2}, 0}};
  const Polylines cut = without_boxes(ring, boxes);
  ASSERT_EQ(cut.size(), 1u);
  EXPECT_EQ(cut[0].front(), (Point2{10, 7}));
  EXPECT_EQ(cut[0].back(), (Point2{10, 3}));
  EXPECT_EQ(cut[0].size(), 6u);
}

}  // namespace
}  // namespace ligne
