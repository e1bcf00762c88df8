/// Surfaces as meshes.

#include "scene/surfaces/surface_mesh.hpp"
#include "even_positions.hpp"
#include "height_tools.hpp"
#include "scene/model/topology.hpp"
#include "scene/surfaces/height_filters.hpp"
#include "scene/surfaces/mesh_writer.hpp"

namespace ligne {
namespace {

using height_test::error_line;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kPi = std::numbers::pi;

SurfacePoints heights(const std::string& formula, std::size_t intervals, double from = -2, double to = 2) {
  return points_of(*formula_heights(formula, evenly(from, to, intervals), evenly(from, to, intervals)));
}

SurfacePoints parametric(const char* x, const char* y, const char* z, std::vector<double> u, std::vector<double> v) {
  return parametric_points({x, y, z}, u, v);
}

Scene scene_of(const SurfaceMesh& mesh, double z_scale = 1, std::optional<double> base = {}) {
  return surface_scene(std::span(&mesh, 1), {1, 1, z_scale}, base);
}

struct Counts {
  int vertices, edges, faces, borders = 0, many = 0, unlike = 0, curves = 0;
  int characteristic() const { return vertices - edges + faces; }
};

Counts count(const Scene& scene) {
  const Topology topology = build_topology(scene);
  Counts counts{static_cast<int>(scene.vertices.size()), static_cast<int>(topology.edges.size()),
                static_cast<int>(scene.faces.size())};
  for (std::size_t e = 0; e < topology.edges.size(); ++e) {
    counts.borders += topology.edges[e].face1 == kNone;
    counts.many += (topology.edge_flags[e] & kEdgeManyFaces) != 0;
    counts.unlike += (topology.edge_flags[e] & kEdgeUnlikeWound) != 0;
    counts.curves += (topology.edge_flags[e] & kEdgeCurve) != 0;
  }
  return counts;
}

TEST(SurfaceMesh, CellsAreCutFromLowXHighYToHighXLowY) {
  const Scene scene = scene_of(make_surface_mesh(heights("x*y", 1, 0, 1)));
  const Topology topology = build_topology(scene);
  ASSERT_EQ(scene.faces.size(), 2u);
  int diagonals = 0;
  for (const Edge& edge : topology.edges) {
    if (edge.face1 == kNone) continue;
    ++diagonals;
    EXPECT_EQ(std::set({scene.vertices[edge.v0].x, scene.vertices[edge.v1].x}), std::set({0.0, 1.0}));
    EXPECT_EQ(scene.vertices[edge.v0].x + scene.vertices[edge.v0].y, 1);
    EXPECT_EQ(scene.vertices[edge.v1].x + scene.vertices[edge.v1].y, 1);
  }
  EXPECT_EQ(diagonals, 1);
  for (std::uint32_t f = 0; f < 2; ++f) EXPECT_GT(face_normal(scene, f).z, 0);
}

TEST(SurfaceMesh, CellsWithAHoleAreLeftOut) {
  SurfacePoints surface = heights("0", 4);
  EXPECT_EQ(make_surface_mesh(surface).triangles.size(), 32u);
  surface.points[2 * 5 + 2].z = kNaN;
  EXPECT_EQ(make_surface_mesh(surface).triangles.size(), 24u);
  surface.points[0].x = std::numeric_limits<double>::infinity();
  const SurfaceMesh mesh = make_surface_mesh(surface);
  EXPECT_EQ(mesh.triangles.size(), 22u);
  EXPECT_EQ(scene_of(mesh).vertices.size(), 23u) << "holes are no vertices";
}

TEST(SurfaceMesh, CurvesAreEveryStrideAndTheLast) {
  SurfacePoints surface = heights("x+y", 5);
  const auto curves = [&](std::size_t x_stride, std::size_t y_stride) {
    surface.x_stride = x_stride;
    surface.y_stride = y_stride;
    return count(scene_of(make_surface_mesh(surface))).curves;
  };
  EXPECT_EQ(curves(1, 1), 2 * 6 * 5);
  EXPECT_EQ(curves(2, 0), 4 * 5);  // 0, 2, 4 and 5
  EXPECT_EQ(curves(0, 5), 2 * 5);
  EXPECT_EQ(curves(0, 0), 0);
}

TEST(SurfaceMesh, ClosedSurfacesClose) {
  const auto full = evenly(0, 2 * kPi, 12);
  struct Row {
    const char *x, *y, *z;
    std::vector<double> u, v;
    int vertices, characteristic, borders, unlike;
    int curves = -1;
  };
  for (const Row& row :
       {Row{"(3+cos(v))*cos(u)", "(3+cos(v))*sin(u)", "sin(v)", full, full, 144, 0, 0, 0, 2 * 144},
        Row{"sin(u)*cos(v)", "sin(u)*sin(v)", "cos(u)", evenly(0, kPi, 6), full, 2 + 5 * 12, 2, 0, 0, 5 * 12 + 6 * 12},
        // A Moebius strip: one border, twice round; and a seam. A Klein bottle has the seam alone.
        Row{"(1+v*cos(u/2))*cos(u)", "(1+v*cos(u/2))*sin(u)", "v*sin(u/2)", full, evenly(-0.5, 0.5, 4), 12 * 5, 0, 2 * 12,
            4},
        Row{"(3+cos(u/2)*sin(v)-sin(u/2)*sin(2*v))*cos(u)", "(3+cos(u/2)*sin(v)-sin(u/2)*sin(2*v))*sin(u)",
            "sin(u/2)*sin(v)+cos(u/2)*sin(2*v)", full, evenly(kPi / 14, kPi / 14 + 2 * kPi, 14), 12 * 14, 0, 0, 14}}) {
    SCOPED_TRACE(row.x);
    const Counts counts = count(scene_of(make_surface_mesh(parametric(row.x, row.y, row.z, row.u, row.v))));
    EXPECT_EQ(counts.vertices, row.vertices);
    EXPECT_EQ(counts.characteristic(), row.characteristic);
    EXPECT_EQ(counts.borders, row.borders);
    EXPECT_EQ(counts.unlike, row.unlike);
    EXPECT_EQ(counts.many, 0);
    if (row.curves >= 0) {
      EXPECT_EQ(counts.curves, row.curves);
    }
  }
}

TEST(SurfaceMesh, CurvesThatRunIntoAPoleAreWhole) {
  // A cone that does not close: its first and last curves have a triangle on one side only, and that one may have collapsed.
  for (const bool pole_first : {true, false}) {
    const auto v = pole_first ? evenly(0, 1, 3) : evenly(-1, 0, 3);
    SurfacePoints cone = parametric("v*cos(u)", "v*sin(u)", "v", evenly(0, 2, 4), v);
    cone.y_stride = 0;
    const Counts counts = count(scene_of(make_surface_mesh(cone)));
    EXPECT_EQ(counts.curves, 5 * 3) << pole_first;
    EXPECT_EQ(counts.borders, 2 * 3 + 4);
  }
}

TEST(SurfaceMesh, HeightsAreCutWhereTheyCross) {
  constexpr std::size_t kIntervals = 40;
  constexpr double kStep = 0.1, kTop = 2.503;
  SurfaceMesh mesh = make_surface_mesh(heights("x^2+y^2", kIntervals));
  clip_heights(mesh, 0, kTop);
  const Scene scene = scene_of(mesh);
  const Counts counts = count(scene);
  EXPECT_EQ(counts.characteristic(), 1) << "a disc";
  EXPECT_EQ(counts.many + counts.unlike, 0);
  const Topology topology = build_topology(scene);
  std::map<std::uint32_t, int> ends;
  double length = 0;
  for (std::size_t e = 0; e < topology.edges.size(); ++e) {
    const Edge& edge = topology.edges[e];
    if (edge.face1 != kNone) continue;
    EXPECT_FALSE(topology.edge_flags[e] & kEdgeCurve);
    const Point3 a = scene.vertices[edge.v0], b = scene.vertices[edge.v1];
    length += std::hypot(b.x - a.x, b.y - a.y);
    for (const std::uint32_t v : {edge.v0, edge.v1}) {
      ++ends[v];
      const Point3 p = scene.vertices[v];
      EXPECT_EQ(p.z, kTop) << "to the last bit";
      // It lies on a row, a column or a diagonal, where the chord of the parabola crosses.
      const auto off_grid = [&](double t) { return std::abs(t / kStep - std::round(t / kStep)); };
      const double x = std::floor(p.x / kStep) * kStep, y = std::floor(p.y / kStep) * kStep;
      const auto f = [](double s, double t) { return s * s + t * t; };
      double chord = 0;
      if (off_grid(p.x) < 1e-9) {
        const double column = std::round(p.x / kStep) * kStep, s = (p.y - y) / kStep;
        chord = (1 - s) * f(column, y) + s * f(column, y + kStep);
      } else if (off_grid(p.y) < 1e-9) {
        const double row = std::round(p.y / kStep) * kStep, s = (p.x - x) / kStep;
        chord = (1 - s) * f(x, row) + s * f(x + kStep, row);
      } else {
        ASSERT_LT(off_grid(p.x + p.y), 1e-9);
        const double s = (p.x - x) / kStep;
        chord = (1 - s) * f(x, y + kStep) + s * f(x + kStep, y);
      }
      EXPECT_NEAR(chord, kTop, 1e-12);
    }
  }
  for (const auto& [v, n] : ends) EXPECT_EQ(n, 2) << "one closed line";
  EXPECT_NEAR(length, 2 * kPi * std::sqrt(kTop), 0.01);
}

TEST(SurfaceMesh, CutsThatMeetVertices) {
  // z = x over x = -2 .. 2 in steps of 1: both planes run through rows of vertices.
  SurfaceMesh mesh = make_surface_mesh(heights("x", 4));
  clip_heights(mesh, -1, 1);
  const Scene scene = scene_of(mesh);
  EXPECT_EQ(scene.faces.size(), 16u);
  EXPECT_EQ(scene.vertices.size(), 15u);
  EXPECT_EQ(count(scene).curves, 3 * 4 + 5 * 2);
  SurfaceMesh flat = make_surface_mesh(heights("1", 4));
  clip_heights(flat, 1, 2);
  EXPECT_EQ(flat.triangles.size(), 32u) << "what lies in the plane stays";
  clip_heights(flat, 1.5, 2);
  EXPECT_TRUE(flat.triangles.empty());
  EXPECT_FALSE(height_range(std::span(&flat, 1)));
  EXPECT_TRUE(scene_of(flat).objects.empty());
}

TEST(SurfaceMesh, CutsOfHeightsNearTheLimitOfNumbers) {
  SurfacePoints surface = heights("x", 1, 0, 1);
  for (Point3& p : surface.points) p.z = p.x > 0 ? 1.7e308 : -1.7e308;
  SurfaceMesh mesh = make_surface_mesh(surface);
  EXPECT_EQ(error_line([&] { scene_of(mesh); }), "surface: has a coordinate beyond 1.6e60, too large to compute with");
  clip_heights(mesh, -1, 1);
  for (const Point3& p : scene_of(mesh).vertices) EXPECT_NEAR(p.x, 0.5, 1e-15);
}

/// The upright wall looks away from the place.
void expect_outwards(const Scene& scene, const Object& wall, const Point3& from) {
  for (std::uint32_t f = wall.face_begin; f < wall.face_end; ++f) {
    const Point3 normal = face_normal(scene, f), p = scene.vertices[scene.faces.contour(f, 0)[0]] - from;
    EXPECT_EQ(normal.z, 0);
    EXPECT_GT(normal.x * p.x + normal.y * p.y, 0);
  }
}

TEST(SurfaceMesh, SkirtsHangFromTheOuterRim) {
  SurfacePoints surface = heights("2+x", 4);
  surface.points[2 * 5 + 2].z = kNaN;
  const Scene scene = scene_of(make_surface_mesh(surface), 10, -1.0);
  ASSERT_EQ(scene.objects.size(), 5u);
  double lowest = 1e300;
  for (const Point3& p : scene.vertices) lowest = std::min(lowest, p.z);
  EXPECT_EQ(lowest, -10);
  for (std::size_t o = 1; o < 5; ++o) {
    const Object& wall = scene.objects[o];
    EXPECT_EQ(wall.face_end - wall.face_begin, 8u);
    EXPECT_EQ(wall.vertex_end - wall.vertex_begin, 10u);
    expect_outwards(scene, wall, {0, 0, 0});
  }
  const Scene touching = scene_of(make_surface_mesh(heights("2+x", 4)), 1, 0.0);
  EXPECT_EQ(touching.objects.size(), 4u) << "the rim at x = -2 lies on the base: no wall";
  EXPECT_EQ(touching.objects[1].face_end - touching.objects[1].face_begin, 7u) << "one triangle where the wall begins";
}

TEST(SurfaceMesh, SkirtsFollowTheRimOfWhatThereIs) {
  // Cells round the rim are missing, of 6 x 6 cells of side 1, and one more.
  SurfacePoints surface = heights("2", 6, 0, 6);
  for (std::size_t k = 0; k < 7; ++k)
    for (const std::size_t sample : {k, 42 + k, 7 * k, 7 * k + 6}) surface.points[sample].z = kNaN;
  surface.points[1 * 7 + 1].z = kNaN;  // at the corner of the 4 x 4 that are left
  const Scene scene = scene_of(make_surface_mesh(surface), 1, 0.0);
  ASSERT_EQ(scene.objects.size(), 5u);
  double length = 0;
  for (std::size_t o = 1; o < 5; ++o) {
    const Object& wall = scene.objects[o];
    length += (wall.face_end - wall.face_begin) / 2;
    expect_outwards(scene, wall, {3, 3, 0});
  }
  EXPECT_EQ(length, 16) << "the step at the corner is as long as the corner";
}

TEST(SurfaceMesh, ContoursCutTrianglesAlongTheirPlanes) {
  const std::vector<double> levels{-3, -1, 0, 0.5, 1, 1.0000000000000002, 2, 7};
  for (const char* formula : {"x*x-y*y", "x+y", "x-y", "floor(x)+y/8", "1"}) {
    SurfaceMesh mesh = make_surface_mesh(heights(formula, 8));
    const Scene whole = scene_of(mesh);
    cut_contours(mesh, levels);
    const Scene scene = scene_of(mesh);
    const auto area = [formula](const Scene& s) {
      double sum = 0;
      for (std::uint32_t f = 0; f < s.faces.size(); ++f) {
        const auto c = s.faces.contour(f, 0);
        const Point3 n = glm::cross(s.vertices[c[1]] - s.vertices[c[0]], s.vertices[c[2]] - s.vertices[c[0]]);
        EXPECT_GT(n.z, 0) << formula;
        sum += glm::length(n) / 2;
      }
      return sum;
    };
    EXPECT_NEAR(area(scene), area(whole), 1e-12 * area(whole)) << formula;
    const Counts before = count(whole), counts = count(scene);
    EXPECT_EQ(counts.characteristic(), 1) << formula << ": neighbours have the same corners on their common edge";
    EXPECT_EQ(counts.many + counts.unlike, 0) << formula;
    EXPECT_GE(counts.borders, before.borders);
    const Topology topology = build_topology(scene);
    for (std::size_t e = 0; e < topology.edges.size(); ++e) {
      const double a = scene.vertices[topology.edges[e].v0].z, b = scene.vertices[topology.edges[e].v1].z;
      const bool level = a == b && std::find(levels.begin(), levels.end(), a) != levels.end();
      EXPECT_TRUE(level || !(topology.edge_flags[e] & kEdgeContour)) << formula;
      for (const double l : levels) {
        const double rounding = 2 * std::abs(l) * kFormulaRounding;  // levels that near are one
        EXPECT_FALSE(std::min(a, b) < l - rounding && l + rounding < std::max(a, b)) << formula << ": an edge crosses " << l;
      }
    }
    EXPECT_EQ(counts.faces == before.faces, std::string(formula) == "1" || std::string(formula) == "x+y");
  }
}

TEST(SurfaceMesh, ContoursThatMeetVertices) {
  // The level runs along a row of samples: one line, since one of its sides is below; the flat top has a rim.
  SurfaceMesh mesh = make_surface_mesh(heights("min(1,y)", 4));
  cut_contours(mesh, std::vector<double>{1});
  const Scene scene = scene_of(mesh);
  EXPECT_EQ(scene.faces.size(), 32u) << "nothing to cut";
  const Topology topology = build_topology(scene);
  int along = 0;
  for (std::size_t e = 0; e < topology.edges.size(); ++e) {
    if (!(topology.edge_flags[e] & kEdgeContour)) continue;
    ++along;
    EXPECT_EQ(scene.vertices[topology.edges[e].v0].y, 1);
    EXPECT_EQ(scene.vertices[topology.edges[e].v1].y, 1);
  }
  EXPECT_EQ(along, 4);
}

std::vector<Point3> corner_positions(const Scene& scene) {
  std::vector<Point3> positions;
  for (const std::uint32_t v : scene.faces.corners()) positions.push_back(scene.vertices[v]);
  return positions;
}

TEST(SurfaceMesh, FilesReadBackTheSame) {
  SurfaceMesh mesh = make_surface_mesh(heights("sin(x*y)/3", 7));
  mesh.name = "a \"name\"\nof two lines";
  const Scene scene = scene_of(mesh, 1.7, -2.0);
  const auto read = [](const std::string& text, ModelFormat format) {
    Warnings warnings;
    const Scene back = read_scene({reader_test::bytes_of(text), "M"}, format, {}, warnings);
    EXPECT_TRUE(warnings.counts().empty());
    return back;
  };
  for (const ModelFormat format : {ModelFormat::ligne_scene, ModelFormat::obj}) {
    const Scene back = read(format == ModelFormat::obj ? write_obj(scene) : write_ligne_scene(scene), format);
    EXPECT_EQ(back.vertices.size(), scene.vertices.size());
    EXPECT_TRUE(std::ranges::equal(corner_positions(back), corner_positions(scene)));
    ASSERT_EQ(back.objects.size(), 5u);
  }
  const Scene back = read(write_ligne_scene(scene), ModelFormat::ligne_scene);
  EXPECT_EQ(back.objects[0].precision, scene.objects[0].precision);
  EXPECT_EQ(back.objects[0].name, mesh.name);
  EXPECT_EQ(back.up_axis, Axis::z);
}

TEST(SurfacePoints, TooManySamplesAreRefused) {
  std::size_t taken = 0;
  take_samples(taken, 2000, 1000, "a");
  take_samples(taken, 1000, 2000, "b");
  EXPECT_EQ(taken, kMostMeshSamples);
  EXPECT_EQ(error_line([&] { take_samples(taken, 2, 2, "c"); }),
            "c: 2 x 2 samples are too many for a mesh: all surfaces together may have 4000000");
}

TEST(HeightFilters, Logarithms) {
  const auto source = log_heights(formula_heights("x", {-1, 0, 1, 100}, {0, 1}));
  const auto z = height_test::heights_of(*source);
  EXPECT_TRUE(std::isnan(z[0][0]) && std::isnan(z[0][1]));
  EXPECT_EQ(z[1][2], 0);
  EXPECT_EQ(z[1][3], 2);
}

TEST(HeightFilters, Windows) {
  const auto window = [](AxisWindow x, AxisWindow y) {
    return window_heights(formula_heights("x+10*y", evenly(0, 5, 5), evenly(0, 4, 4)), x, y, "g");
  };
  const auto part = window({0.5, 3}, {});
  EXPECT_EQ(part->x(), (std::vector<double>{1, 2, 3}));
  EXPECT_EQ(part->y().size(), 5u);
  const auto corner = window({4, 9}, {2, 3});
  EXPECT_EQ(height_test::heights_of(*corner), (std::vector<std::vector<double>>{{24, 25}, {34, 35}}));
  EXPECT_EQ(error_line([&] {
              window({7, 9}, {});
            }),
            "g: the window -x, -y holds 0 columns and 5 rows of the grid; two of each are needed");
}

}  // namespace
}  // namespace ligne
