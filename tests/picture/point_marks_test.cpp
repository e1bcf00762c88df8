// Marks and labels of points, against a search through all boxes.

#include "picture/marks/point_marks.hpp"

#include "picture/marks/contour_labels.hpp"
#include "picture/marks/mark_tree.hpp"
#include "plotting/stroke_text.hpp"
#include "support/test.hpp"

namespace ligne {
namespace {

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

TEST(MarkTree, AgreesWithALookAtAllPoints) {
  std::mt19937 random(5);
  std::uniform_int_distribution<int> place(0, 40);
  for (const std::size_t count : {0, 1, 8, 9, 500}) {
    std::vector<Point2> points;
    for (std::size_t i = 0; i < count; ++i) {
      const Point2 p{place(random) * 0.5, place(random) * 0.5};
      points.insert(points.end(), i % 5 == 0 ? 12 : 1, p);
    }
    const MarkTree tree(points);
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
