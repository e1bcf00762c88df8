// From the scene to the projected scene: every end of a line where its source edge says, whatever is cut away; lines on the
// border of the window; faces seen edge on.

#include <glm/vec4.hpp>

#include "scene/model/bounds.hpp"
#include "support/scenes.hpp"
#include "view/clip.hpp"
#include "view/edge_classes.hpp"
#include "view/edge_on.hpp"

namespace ligne::test {
namespace {

const Rect kA4{{0, 0}, {297, 210}};
const Frame kA4Frame{{{10, 10}, {287, 200}}};

Point2 true_page_point(const View& view, const Point3& p) {
  const glm::dvec4 h = view.model_to_page * glm::dvec4(p, 1);
  return {h.x / h.w, h.y / h.w};
}

/// How far the ends of a projected line lie from those of its part of the source edge, in steps: half a step in each
/// direction, but for what the parameter rounds.
double farthest_end(const ProjectedScene& projected, std::size_t line, const Point3& a, const Point3& b) {
  const ProjectedEdge& edge = projected.edges[line];
  const auto part = projected.edge_parts.empty() ? std::array<double, 2>{0, 1} : projected.edge_parts[line];
  double farthest = 0;
  for (const bool last : {false, true}) {
    const Point2 drawn = projected.lattice.to_mm(projected.vertices[last ? edge.v1 : edge.v0].p);
    const Point2 true_place = true_page_point(projected.view, a + part[last] * (b - a));
    farthest = std::max(farthest, glm::distance(drawn, true_place) / projected.lattice.step_mm);
  }
  return farthest;
}
constexpr double kFarthestSteps = 1;

struct Projected {
  Topology topology;
  ProjectedScene scene;
};

Projected project_all(const Scene& scene, const CameraRequest& request) {
  Projected result{build_topology(scene), {}};
  const View view = make_view(scene, make_camera(request, scene), kA4Frame, kA4);
  result.scene = project(scene, result.topology, view, {classes("all"), 30});
  return result;
}

/// A box at whole numbers, from eyes at whole numbers round it and in it: with a field of view of 90 degrees its vertices
/// lie on the border to the last digit, on one side of it or on the other.
TEST(Projection, EndsOfLinesLieWhereTheirEdgesSay) {
  Scene scene;
  add_box(scene, {1, -3, 1}, {5, 3, 8});
  int on_border = 0;
  for (int x = -2; x <= 8; x += 2) {
    for (int y = -9; y <= 5; ++y) {
      for (int z = 0; z <= 10; ++z) {
        for (const Point3& way : {Point3{0, 8, 0}, Point3{0, 0, -4}, Point3{3, 0, 0}, Point3{1, 2, 2}}) {
          for (const double fov : {90.0, 53.0}) {
            const Point3 eye{double(x), double(y), double(z)};
            const Projected p = project_all(scene, from_eye(eye, eye + way, fov));
            for (std::size_t i = 0; i < p.scene.edges.size(); ++i) {
              const Edge& edge = p.topology.edges[p.scene.edges[i].source];
              const double steps = farthest_end(p.scene, i, scene.vertices[edge.v0], scene.vertices[edge.v1]);
              ASSERT_LE(steps, kFarthestSteps) << "eye " << x << ',' << y << ',' << z << " way " << way.x << ',' << way.y
                                               << ',' << way.z << " fov " << fov << " edge " << p.scene.edges[i].source;
            }
            for (const Point3& v : scene.vertices) {
              const HomogeneousPoint h = to_homogeneous(p.scene.view, v);
              if (h.w <= 0) continue;
              on_border += std::abs(h.y / h.w - p.scene.view.window.min.y) < 1e-9;
            }
          }
        }
      }
    }
  }
  EXPECT_GT(on_border, 100);  // what the test is for happens
}

/// A prism of eight sides along y, with corners as float32. In the isometric view two of its chamfers are seen edge on but
/// for rounding.
Scene chamfered_bar(float size, float off) {
  Scene scene;
  begin_object(scene);
  const float cut = 0.03F, end = 10 - cut;
  const float steps[8][2] = {{cut, 0}, {end, 0}, {10, cut}, {10, end}, {end, 10}, {cut, 10}, {0, end}, {0, cut}};
  for (const float y : {0.F, 30 * size})
    for (const auto& [x, z] : steps) scene.vertices.push_back({off + size * x, off + y, off + size * z});
  for (std::uint32_t k = 0; k < 8; ++k) {
    const std::uint32_t next = (k + 1) % 8;
    scene.faces.add_triangle(k, 8 + next, next);
    scene.faces.add_triangle(k, 8 + k, 8 + next);
    if (k < 2) continue;
    scene.faces.add_triangle(0, k - 1, k);
    scene.faces.add_triangle(8, 8 + k, 7 + k);
  }
  end_object(scene);
  return scene;
}

/// Otherwise an outline would be left out: rounding moves one of the edges of a chamfer before the other.
TEST(Projection, EdgesAtWhichThePageTurnsAreOutlines) {
  constexpr double kThin = 1e9;  // square steps, of faces as long as the page
  int nearly_edge_on = 0;
  for (int i = 0; i < 400; ++i) {
    const Scene scene = chamfered_bar(1 + 0.0007F * static_cast<float>(i), 0.0037F * static_cast<float>(i));
    const Projected p = project_all(scene, {});
    const auto turn = [&](std::uint32_t face) {
      LatticePoint at[3];
      for (int k = 0; k < 3; ++k) {
        const Point2 mm = page_point(p.scene.view, scene.vertices[scene.faces.contour(face, 0)[k]]);
        at[k] = p.scene.lattice.snap(mm);
      }
      return orientation(at[0], at[1], at[2]);
    };
    for (const ProjectedEdge& edge : p.scene.edges) {
      const Edge& source = p.topology.edges[edge.source];
      const double one = turn(source.face0), other = turn(source.face1);
      const bool is_one_thin = std::abs(one) < kThin, is_other_thin = std::abs(other) < kThin;
      nearly_edge_on += is_one_thin != is_other_thin;
      if (is_one_thin && is_other_thin) continue;
      ASSERT_TRUE(one * other >= 0 || edge.line_class == LineClass::outline) << i << ' ' << source.v0 << ' ' << source.v1;
    }
  }
  EXPECT_GT(nearly_edge_on, 400);
}

TEST(Projection, LinesOfNoFaceLieWhereTheyAre) {
  Scene scene;
  add_box(scene, {1, -3, 1}, {5, 3, 8});
  for (int y = -9; y <= 5; ++y) {
    const Point3 eye{0, double(y), 4};
    Projected p = project_all(scene, from_eye(eye, eye + Point3{0, 8, 0}, 90));
    const std::size_t before = p.scene.edges.size();
    std::vector<std::array<Point3, 2>> lines;
    for (const Edge& edge : p.topology.edges) lines.push_back({scene.vertices[edge.v0], scene.vertices[edge.v1]});
    const std::uint32_t first = p.scene.source_count;
    add_lines(p.scene, lines, LineClass::axes);
    ASSERT_EQ(p.scene.edges.size(), 2 * before);
    for (std::size_t i = before; i < p.scene.edges.size(); ++i) {
      const auto& line = lines[p.scene.edges[i].source - first];
      ASSERT_LE(farthest_end(p.scene, i, line[0], line[1]), kFarthestSteps) << "eye 0," << y << ",4";
    }
  }
}

TEST(ClipSegment, SaysWhichEndsAreCut) {
  const auto part = [](Point2 a, Point2 b) {
    return clip_segment({a.x, a.y, 0, 1}, {b.x, b.y, 0, 1}, {{{-100, -100}, {100, 100}}, 0.5});
  };
  using Cut = std::array<bool, 2>;
  EXPECT_EQ(part({-110, 50}, {110, 50}).value().cut, (Cut{true, true}));
  EXPECT_TRUE(part({-100, -100}, {100, 100}).value().whole());
  EXPECT_EQ(part({-100, -100}, {100, 100})->range, (std::array<double, 2>{0, 1}));
  EXPECT_FALSE(part({-103, 50}, {-101, 50}));
  EXPECT_FALSE(part({-101, 50}, {-100, 50})) << "one point of the border";
  // An end outside by the last digit is cut though its parameter is one.
  const double outside = std::nextafter(100.0, 200.0);
  EXPECT_EQ(part({-90, 0}, {outside, 0}).value().range[1], 1);
  EXPECT_EQ(part({-90, 0}, {outside, 0})->cut, (Cut{false, true}));
  EXPECT_EQ(part({outside, 0}, {-90, 0}).value().cut, (Cut{true, false}));
}

/// A line along the border of the sheet is in view, wherever its last digits put it, and a face that goes on beyond the
/// sheet covers both of its banks.
TEST(Projection, LinesAlongTheSheetsBorderHaveFaceOnBothBanks) {
  Scene scene;
  add_face(scene, {{{-100, -100, 10}, {100, -100, 10}, {100, 100, 10}, {-100, 100, 10}}});
  for (const double off : {-1.0, 0.0, 1.0}) {  // at heights of their own: they are not to be one plate
    const double x = 50 + 1e-9 * off;
    add_face(scene, {{{-x, -30, off}, {x, -30, off}, {x, 30, off}, {-x, 30, off}}});
  }
  CameraRequest top;
  top.named_view = "top";
  const Rect sheet{{0, 0}, {100, 100}};
  const View view = make_view(scene, make_camera(top, scene), {sheet}, sheet, 1.0);
  const Topology topology = build_topology(scene);
  const ProjectedScene projected = project(scene, topology, view, {classes("all"), 30});
  EXPECT_EQ(projected.edges.size(), 12u);  // those of the small plates; the large one's lie outside
  double least = 1e9, most = -1e9, lines = 0;
  for (const Triangle& t : projected.triangles)
    for (const std::uint32_t v : t.v) {
      least = std::min(least, projected.lattice.to_mm(projected.vertices[v].p).x);
      most = std::max(most, projected.lattice.to_mm(projected.vertices[v].p).x);
    }
  for (const ProjectedEdge& e : projected.edges)
    for (const std::uint32_t v : {e.v0, e.v1})
      lines = std::max(lines, std::abs(projected.lattice.to_mm(projected.vertices[v].p).x - 50));
  const double step = projected.lattice.step_mm;
  EXPECT_LE(lines, 50 + step);
  EXPECT_LT(least, -2 * step);
  EXPECT_GT(most, 100 + 2 * step);
  EXPECT_GT(least, -1e-3);  // but by less than a drawing may be off
  EXPECT_LT(most, 100 + 1e-3);
  for (const char* method : {"appel", "warnock", "watkins", "atherton-weiler"}) {
    const VisibilityResult result = find_method(method)->compute_visibility(projected, {});
    EXPECT_TRUE(result.strokes->strokes.empty()) << method;
  }
}

/// Three plates that meet in one edge, one of them with the eye on it.
Scene book() {
  Scene scene;
  begin_object(scene);
  const Point3 up{0, 0, 3}, a{0.7725729189911219, 1.8239641859906681, 0}, b{-0.9316515903678265, 1.6136678894694236, 0},
      c{0.47014470878097625, -1.5997425130494345, 0};
  scene.vertices = {{0, 0, 0}, up, a + up, a, b + up, b, c + up, c};
  for (const std::array<std::uint32_t, 4>& corners :
       {std::array<std::uint32_t, 4>{0, 1, 2, 3}, {5, 4, 1, 0}, {0, 1, 6, 7}}) {
    scene.faces.add_face(corners);
  }
  end_object(scene);
  return scene;
}

/// Most triangles are told by a bound: it must not tell otherwise than the whole test.
TEST(EdgeOn, TheBoundAgreesWithTheTest) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  std::uniform_int_distribution<int> bits(-60, 0);
  const auto point = [&] { return Point3(coordinate(random), coordinate(random), coordinate(random)); };
  Camera camera;
  camera.perspective = false;
  camera.forward = glm::normalize(Point3(1, 2, -0.5));
  Scene scene;
  begin_object(scene);
  for (std::uint32_t i = 0; i < 30'000; ++i) {
    // Sides along the sight, off it by any power of two.
    const Point3 p = point() * 100.0, off = point() * std::ldexp(1.0, bits(random));
    const Point3 q = p + camera.forward * coordinate(random) + off, r = p + camera.forward * coordinate(random) - 2.0 * off;
    const auto v = static_cast<std::uint32_t>(scene.vertices.size());
    scene.vertices.insert(scene.vertices.end(), {p, q, r + point() * std::ldexp(1.0, bits(random))});
    scene.faces.add_triangle(v, v + 1, v + 2);
  }
  end_object(scene);
  const double largest = largest_coordinate(scene);
  const Topology topology = build_topology(scene);
  const std::vector<std::uint8_t> edge_on = faces_seen_edge_on(scene, topology, camera, largest);
  ASSERT_EQ(edge_on.size(), scene.faces.size());
  View view;
  view.camera = camera;
  const std::vector<std::int8_t> facings = face_facings(scene, view);
  const std::vector<std::int8_t> sure =
      sure_facings(scene, camera, mesh_angles(scene, topology, object_sizes(scene)), largest);
  EXPECT_EQ(faces_seen_edge_on(scene, topology, camera, largest, sure), edge_on);
  std::size_t seen_so = 0;
  for (std::uint32_t f = 0; f < edge_on.size(); ++f) {
    const Point3* const t = &scene.vertices[3 * f];
    const bool whole = is_seen_edge_on(t[0], t[1], t[2], camera, 0, view_rounding(camera, largest));
    EXPECT_EQ(edge_on[f] != 0, whole) << f;
    EXPECT_TRUE(sure[f] == 0 || (!whole && sure[f] == facings[f])) << f;
    seen_so += whole;
  }
  EXPECT_LT(std::ranges::count(sure, 0), 29'900);
  EXPECT_GT(seen_so, 1000u);
  EXPECT_LT(seen_so, 29'000u);
}

TEST(EdgeOn, AFaceWithTheEyeOnItHidesNothing) {
  const Scene scene = book();
  const Point3 eye{0.1922756744317828, -0.6542487129363209, 1.154344595871148},
      target{-0.9316515903678265, 1.6136678894694236, 3.0};
  const CameraRequest request = from_eye(eye, target, 170);
  const Projected p = project_all(scene, request);
  EXPECT_EQ(p.scene.face_is_edge_on, (std::vector<std::uint8_t>{0, 0, 1}));
  for (const char* method : {"appel", "warnock", "watkins", "atherton-weiler"}) {
    const VisibilityResult result = find_method(method)->compute_visibility(p.scene, {});
    double seam_mm = 0;  // the edge that all three have
    for (const Stroke& s : result.strokes->strokes) {
      const Edge& edge = p.topology.edges[s.source];
      if (edge.v0 == 0 && edge.v1 == 1) seam_mm += glm::distance(p.scene.lattice.to_mm(s.from), p.scene.lattice.to_mm(s.to));
    }
    EXPECT_GT(seam_mm, 10) << method;
  }
}

TEST(EdgeOn, IsToldToTheLastDigitsOnly) {
  const Scene scene = book();
  const Topology topology = build_topology(scene);
  const auto edge_on = [&](const CameraRequest& request) {
    return faces_seen_edge_on(scene, topology, make_camera(request, scene), largest_coordinate(scene));
  };
  EXPECT_TRUE(edge_on(from_eye({5, -6, 4}, {0, 0, 1})).empty());
  const Point3 on_face{0.1922756744317828, -0.6542487129363209, 1.154344595871148};
  const Point3 beside = on_face + Point3{1e-12, 0, 0};
  EXPECT_FALSE(edge_on(from_eye(on_face, {0, 0, 0})).empty());
  EXPECT_TRUE(edge_on(from_eye(beside, {0, 0, 0})).empty());
  // In parallel projection along a face, and a little beside it.
  EXPECT_EQ(edge_on(along(scene.vertices[3] + Point3{0, 0, -7})), (std::vector<std::uint8_t>{1, 0, 0}));
  EXPECT_TRUE(edge_on(along(scene.vertices[3] + Point3{1e-12, 0, -7})).empty());
}

/// Coordinates that are not known better than a micrometre: an eye nearer to the plane is on it.
TEST(EdgeOn, IsToldToThePrecisionOfTheInput) {
  Scene scene = book();
  scene.objects[0].precision = 1e-3;
  const Topology topology = build_topology(scene);
  const Point3 beside = Point3{0.1922756744317828, -0.6542487129363209, 1.154344595871148} + Point3{5e-4, 0, 0};
  const Camera camera = make_camera(from_eye(beside, {0, 0, 0}), scene);
  EXPECT_EQ(faces_seen_edge_on(scene, topology, camera, largest_coordinate(scene)), (std::vector<std::uint8_t>{0, 0, 1}));
}

}  // namespace
}  // namespace ligne::test
