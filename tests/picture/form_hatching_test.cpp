// Hatching that follows the form: where strokes lie, how far apart, and along what.

#include "base/parallel.hpp"
#include "drawing/measures.hpp"
#include "picture/draw_scene.hpp"
#include "picture/drawn_scene.hpp"
#include "picture/errors.hpp"
#include "picture/hatching/form_field.hpp"
#include "picture/surface/surface_mesh_picture.hpp"
#include "picture/surface/surface_request.hpp"
#include "picture/surface/surface_samples.hpp"
#include "scene/model/topology.hpp"
#include "support/round_bodies.hpp"
#include "support/test.hpp"
#include "visibility/registry.hpp"

namespace ligne {
namespace {

constexpr double kPenMm = 0.3, kSpacingMm = 1.5;

PictureRequest request_of(HatchKind kind) {
  PictureRequest request;
  request.hatch.kind = kind;
  request.hatch.direction.form = FormLines::curvature;
  request.hatch.spacing_mm = kSpacingMm;
  request.page.pen_width_mm = kPenMm;
  request.lines.quality = Quality::exact;
  return request;
}

/// The strokes of hatching, and all lines that are rims.
struct Hatched {
  Polylines strokes, rims;
};

Hatched hatched(const DrawnScene& drawn) {
  RunReport run;
  Hatched result;
  for (const Layer& layer : drawn.compose(run).layers)
    append(layer.name == "hatch" ? result.strokes : result.rims, layer.lines);
  return result;
}

double length_of(std::span<const Point2> line) {
  double length = 0;
  for (std::size_t k = 1; k < line.size(); ++k) length += glm::distance(line[k - 1], line[k]);
  return length;
}

bool cross(Point2 a, Point2 b, Point2 c, Point2 d) {
  const auto side = [](Point2 p, Point2 q, Point2 r) { return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x); };
  return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
}

class FormHatching : public testing::TestWithParam<const char*> {};

TEST_P(FormHatching, StrokesLieOnWhatIsSeenAndCrossNoRim) {
  const Scene scene = test::torus(30, 13, 48, 24);
  PictureRequest request = request_of(HatchKind::shade);
  request.lines.method = find_method(GetParam());
  RunReport run;
  const DrawnScene drawn = draw_lines(scene, request, run);
  const auto [strokes, rims] = hatched(drawn);
  ASSERT_GT(strokes.size(), 200u);
  const std::vector<Region>& regions = *drawn.visibility().result.regions;
  // Points of a stroke are a fifth of the spacing apart, and are looked at one by one: between two of them a rim can come
  // nearer by what a chord of that length cuts off its bend.
  constexpr double kSlackMm = 0.02;
  const double pen_mm = plot_options(request, drawn.prepared().around.placement.page).style_of("hatch").width_mm;
  for (std::size_t i = 0; i < strokes.size(); ++i) {
    const auto stroke = strokes[i];
    for (std::size_t k = 0; k < stroke.size(); ++k) {
      ASSERT_TRUE(std::ranges::any_of(regions,
                                      [&](const Region& r) {
                                        return test::holds(r, stroke[k]) || test::holds(r, stroke[k] + Point2{2e-3, 1e-3}) ||
                                               test::holds(r, stroke[k] - Point2{2e-3, 1e-3});
                                      }))
          << stroke[k].x << ' ' << stroke[k].y;
      ASSERT_GE(test::distance_to_lines(stroke[k], rims), pen_mm / 2 - kSlackMm);
      for (std::size_t r = 0; k > 0 && r < rims.size(); ++r)
        for (std::size_t m = 1; m < rims[r].size(); ++m)
          ASSERT_FALSE(cross(stroke[k - 1], stroke[k], rims[r][m - 1], rims[r][m]));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Methods, FormHatching, testing::Values("atherton-weiler", "warnock"),
                         [](const auto& info) { return info.index == 0 ? "AthertonWeiler" : "Warnock"; });

/// Plain hatching: nowhere is more white than where a stroke just did not fit, and strokes of one direction keep apart.
TEST(FormHatchingSpacing, IsWithinBounds) {
  const Scene scene = test::torus(30, 13, 48, 24);
  RunReport run;
  const DrawnScene drawn = draw_lines(scene, request_of(HatchKind::plain), run);
  const auto [strokes, rims] = hatched(drawn);
  std::size_t crowded = 0, points = 0;
  for (std::size_t i = 0; i < strokes.size(); ++i) {
    const auto stroke = strokes[i];
    EXPECT_GE(length_of(stroke), kSpacingMm * 0.99);
    for (std::size_t k = 1; k + 1 < stroke.size(); ++k) {
      if (test::distance_to_lines(stroke[k], rims) < 2 * kSpacingMm) continue;  // two sheets may meet there
      double least = 1e300;
      for (std::size_t j = 0; j < strokes.size(); ++j)
        for (std::size_t m = 1; j != i && m < strokes[j].size(); ++m)
          least = std::min(least, test::distance_to_segment(stroke[k], strokes[j][m - 1], strokes[j][m]));
      ++points;
      crowded += least < 0.6 * kSpacingMm;
    }
  }
  EXPECT_GT(points, 500u);
  EXPECT_LE(crowded, points / 100);
  std::size_t white = 0, places = 0;
  for (const Region& region : *drawn.visibility().result.regions) {
    const Point2 p = region.contours[0][0];
    if (test::distance_to_lines(p, rims) < 2 * kSpacingMm) continue;
    ++places;
    white += test::distance_to_lines(p, strokes) > 2 * kSpacingMm;
  }
  EXPECT_GT(places, 300u);
  EXPECT_LE(white, places / 100);
}

TEST(FormHatchingStrokes, KeepTheLeastLength) {
  PictureRequest request = request_of(HatchKind::shade);
  request.lines.least_mm = 9;
  RunReport run;
  const auto [strokes, rims] = hatched(draw_lines(test::torus(30, 13, 48, 24), request, run));
  ASSERT_GT(strokes.size(), 20u);
  for (std::size_t i = 0; i < strokes.size(); ++i) EXPECT_GE(length_of(strokes[i]), 9 - 0.01);
}

TEST(FormHatchingBytes, AreTheSameForAnyNumberOfThreads) {
  const Scene scene = test::torus(30, 13, 96, 48);
  std::vector<std::string> files;
  for (const unsigned threads : {1u, 2u, 8u}) {
    run_with_threads(threads, [&] {
      RunReport run;
      files.push_back(draw_scene(scene, request_of(HatchKind::shade), run).bytes);
    });
  }
  EXPECT_GT(files[0].size(), 10000u);
  EXPECT_EQ(files[0], files[1]);
  EXPECT_EQ(files[0], files[2]);
}

TEST(FormField, FollowsTheTube) {
  const Scene scene = test::torus(30, 10, 48, 24);
  const FormMesh mesh = form_mesh(scene, build_topology(scene), 30);
  ASSERT_EQ(mesh.points.size(), scene.vertices.size());
  const FormField field = curvature_field(mesh, 1, [](std::uint32_t) { return Point3{0, 0, 0}; });
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const Point3 p = (mesh.point(t, 0) + mesh.point(t, 1) + mesh.point(t, 2)) / 3.0;
    const Point3 along = glm::normalize(Point3{-p.y, p.x, 0});  // the ring
    const Weights middle{1.0 / 3, 1.0 / 3, 1.0 / 3};
    EXPECT_LT(std::abs(glm::dot(field.at(mesh, t, middle, false), along)), 0.05);
    EXPECT_GT(std::abs(glm::dot(field.at(mesh, t, middle, true), along)), 0.95);
  }
}

TEST(FormMesh, EndsSurfacesAtCreases) {
  Scene scene = test::torus(30, 10, 48, 4);  // the tube is a square
  const FormMesh mesh = form_mesh(scene, build_topology(scene), 30);
  EXPECT_EQ(mesh.points.size(), 2 * scene.vertices.size());
  for (const FormTriangle& triangle : mesh.triangles) EXPECT_EQ(std::ranges::count(triangle.across, kNone), 1);
}

Hatched hatched_surface(const SurfaceRequest& request) {
  RunReport run;
  const SurfaceScene surface = make_surface_scene(request, surfaces_of(request, run), run);
  return hatched(draw_lines(surface.scene, surface.picture, run, surface.box));
}

SurfaceRequest surface_request(FormLines form) {
  SurfaceRequest request;
  request.picture = request_of(HatchKind::shade);
  request.picture.hatch.direction.form = form;
  request.lines = CurveFamilies::none;
  return request;
}

/// From above, curves x = constant and y = constant are straight lines along the page.
TEST(FormHatchingOfSurfaces, FollowsTheCurvesOfHeights) {
  SurfaceRequest request = surface_request(FormLines::iso);
  request.formulas = {"2*exp(-r^2/4)"};
  request.x = CurveRange{-4, 4, 41};
  request.y = CurveRange{-4, 4, 41};
  request.picture.view.named_view = "top";
  request.picture.hatch.cross = true;
  const Polylines strokes = hatched_surface(request).strokes;
  ASSERT_GT(strokes.size(), 50u);
  std::size_t upright = 0;
  for (std::size_t i = 0; i < strokes.size(); ++i) {
    const auto stroke = strokes[i];
    const Point2 way = glm::abs(stroke.back() - stroke.front());
    upright += way.x < way.y;
    for (const Point2 p : stroke) EXPECT_LE(way.x < way.y ? std::abs(p.x - stroke[0].x) : std::abs(p.y - stroke[0].y), 1e-3);
  }
  EXPECT_GT(upright, 10u);
  EXPECT_LT(upright, strokes.size() - 10);
}

/// Seen along its axis, the curves u = constant of a dome are circles and the others lead to the middle.
TEST(FormHatchingOfSurfaces, FollowsTheCurvesOfParameters) {
  SurfaceRequest request = surface_request(FormLines::iso);
  request.parametric = {{"cos(v)*cos(u)", "cos(v)*sin(u)", "2*sin(v)"}};
  request.u = {CurveRange{0, 2 * std::numbers::pi, 41}};
  request.v = {CurveRange{0.1, 1.4, 21}};
  request.picture.view.named_view = "top";
  const auto [strokes, rims] = hatched_surface(request);
  ASSERT_GT(strokes.size(), 30u);
  Rect box;
  for (const Point2 p : rims.points) box.extend(p);
  std::size_t circles = 0;
  const Point2 middle = (box.min + box.max) * 0.5;
  for (std::size_t i = 0; i < strokes.size(); ++i) {
    const Point2 first = strokes[i][0] - middle;
    const double radius = glm::length(first);
    double off_circle = 0, off_ray = 0;
    for (const Point2 p : strokes[i]) {
      const Point2 q = p - middle;
      off_circle = std::max(off_circle, std::abs(glm::length(q) - radius));
      off_ray = std::max(off_ray, std::abs(q.x * first.y - q.y * first.x) / radius);
    }
    EXPECT_LT(std::min(off_circle, off_ray), 0.3);
    circles += off_circle < 0.3;
  }
  EXPECT_GT(circles, 20u);
}

TEST(FormHatchingRequests, NameWhatIsMissing) {
  const Scene scene = test::torus(30, 13, 24, 12);
  const auto field_of_error = [&](PictureRequest request) -> std::string {
    RunReport run;
    try {
      draw_scene(scene, request, run);
    } catch (const RequestError& e) {
      return e.field();
    }
    return {};
  };
  PictureRequest request = request_of(HatchKind::shade);
  request.hatch.direction.form = FormLines::iso;
  EXPECT_EQ(field_of_error(request), "hatch-angle") << "a mesh has no curves";
  request = request_of(HatchKind::shade);
  request.lines.method = find_method("watkins");
  EXPECT_EQ(field_of_error(request), "hatch-angle") << "spans are straight";
  request = request_of(HatchKind::shade);
  request.hatch.spacing_mm = 1e-4;
  EXPECT_EQ(field_of_error(request), "hatch-spacing");
}

}  // namespace
}  // namespace ligne
