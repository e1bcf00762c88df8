/// Clear drawings of parts whose edges and outlines are known: all of these are drawn, and nothing else.

#include "clear/true_comparison.hpp"
#include "main/script.hpp"
#include "main/tier.hpp"
#include "picture/models/models.hpp"
#include "support/page_lines.hpp"
#include "support/test.hpp"

namespace ligne::test {
namespace {

/// Facets to a turn of the mesh that tells what is hidden.
constexpr int kFineFacets = 240;

/// Ends of lines nearer to another line meet it.
constexpr double kMeetsMm = 0.05;
/// A line does not meet itself so near to its end.
constexpr double kOwnEndMm = 0.5;
/// An outline ends so near to its cusp.
constexpr double kCuspMm = 1;

/// The distance of the first point of a line from the rest of it, behind kOwnEndMm.
double distance_from_rest(std::span<const Point2> line) {
  double distance = std::numeric_limits<double>::infinity(), way = 0;
  for (std::size_t k = 1; k < line.size(); ++k) {
    if (way >= kOwnEndMm) distance = std::min(distance, distance_to_segment(line[0], line[k - 1], line[k]));
    way += glm::distance(line[k - 1], line[k]);
  }
  return distance;
}

std::vector<Point2> loose_ends(const Drawing& drawing, std::span<const Point2> cusps) {
  std::vector<std::vector<Point2>> lines;
  for (const Layer& layer : drawing.layers)
    for (std::size_t i = 0; i < layer.lines.size(); ++i) lines.emplace_back(layer.lines[i].begin(), layer.lines[i].end());
  std::vector<Point2> loose;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    for (int end = 0; end < 2; ++end, std::ranges::reverse(lines[i])) {
      const Point2 p = lines[i].front();
      const auto meets = [&](const std::vector<Point2>& line) {
        if (&line == &lines[i]) return distance_from_rest(line) <= kMeetsMm;
        for (std::size_t k = 1; k < line.size(); ++k)
          if (distance_to_segment(p, line[k - 1], line[k]) <= kMeetsMm) return true;
        return false;
      };
      const bool is_cusp = std::ranges::any_of(cusps, [&](Point2 cusp) { return glm::distance(p, cusp) < kCuspMm; });
      if (!is_cusp && !std::ranges::any_of(lines, meets)) loose.push_back(p);
    }
  }
  return loose;
}

Scene scene_of(const TruePart& part, int facets, const TemporaryFolder& folder) {
  const std::filesystem::path file = folder / (part.name + std::to_string(facets) + ".stl");
  write_mesh(part, facets, file);
  return load_models({.files = {file.string()}}).scene;
}

/// Directions of sight in which no surface of a part is seen edge on.
constexpr std::array<Point3, 4> kSights{Point3{-1, 1, -0.8}, {0.6, 1, -0.5}, {-1, 0.4, -0.7}, {0.3, 1, -1.2}};
/// Eyes of pictures in perspective, model units.
constexpr std::array<Point3, 4> kEyes{Point3{70, -60, 55}, {85, 40, 60}, {-60, -75, 50}, {20, -90, 75}};

Comparison compare(const TruePart& part, int facets, const ViewRequest& view) {
  const TemporaryFolder folder;
  const TrueScene scene{scene_of(part, facets, folder), scene_of(part, kFineFacets, folder),
                        [&](const Viewer& viewer, double step) {
                          return KnownLines{true_lines(part, viewer, step), {}};
                        },
                        [&](const TruePoint& p) { return p.radius * (1 - std::cos(std::numbers::pi / facets)); }};
  return compare_with_truth(scene, view);
}

/// Part of what is surely seen that is drawn, of each kind, and of what is drawn that is true.
constexpr double kLeast = 0.99;
class TrueLines : public testing::TestWithParam<TruePart> {};

void expect_true(const TruePart& part, int facets, const ViewRequest& view) {
  const Comparison result = compare(part, facets, view);
  const char* const kNames[] = {"sharp", "tangent", "outline"};
  for (std::size_t kind = 0; kind < 3; ++kind)
    EXPECT_GE(result.kinds[kind].part(), kLeast) << kNames[kind] << ", of " << result.kinds[kind].seen_mm << " mm";
  EXPECT_GE(result.true_mm, kLeast * result.ink_mm) << "of " << result.ink_mm << " mm drawn";
  for (const Point2 p : loose_ends(result.drawing, result.cusps))
    ADD_FAILURE() << "an end in the air at " << p.x << ", " << p.y;
}

/// Compares meshes of four accuracies in the views whose member `given` is one of the points; in the first tier in one of
/// two.
void expect_true_from(const TruePart& part, std::span<const Point3> points, std::optional<Point3> ViewRequest::*given) {
  for (const int facets : {12, 16, 24, 48}) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (!is_chosen(part.name + std::to_string(facets), i, 2)) continue;
      SCOPED_TRACE(part.name + ", " + std::to_string(facets) + " facets, view " + std::to_string(i));
      ViewRequest view;
      view.*given = points[i];
      expect_true(part, facets, view);
    }
  }
}

TEST_P(TrueLines, AreDrawnAndNothingElse) { expect_true_from(GetParam(), kSights, &ViewRequest::direction); }

TEST_P(TrueLines, AreDrawnInPerspective) { expect_true_from(GetParam(), kEyes, &ViewRequest::eye); }

/// Number of curves that begin in the paths of an SVG file.
std::size_t curves_in(const std::string& svg) {
  std::size_t count = 0;
  bool in_path = false;
  for (const std::string& part : parts_of(svg, '"')) {
    if (in_path) count += static_cast<std::size_t>(std::ranges::count(part, 'c') + std::ranges::count(part, 'C'));
    in_path = part.ends_with(" d=");
  }
  return count;
}

TEST(TruePictures, HaveArcsForQuartersOfCirclesInFourSteps) {
  // All of its arcs are quarters, and too small for a finer mesh. The circles of their surfaces are known all the same.
  const std::vector<TruePart> parts = true_parts();
  const auto angle = std::ranges::find(parts, "angle", &TruePart::name);
  ASSERT_NE(angle, parts.end());
  const TemporaryFolder folder;
  const Scene scene = scene_of(*angle, 16, folder);
  PictureRequest request;
  request.page.size = {Page{80, 70, 4}, true};
  request.view.direction = kSights[0];
  RunReport run;
  EXPECT_GE(curves_in(draw_scene(scene, request, run).bytes), std::size_t{9});  // 6 above, and 3 of those below are seen
  request.output.curves = false;
  EXPECT_EQ(curves_in(draw_scene(scene, request, run).bytes), std::size_t{0});
}

INSTANTIATE_TEST_SUITE_P(Parts, TrueLines, testing::ValuesIn(true_parts()),
                         [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace ligne::test
