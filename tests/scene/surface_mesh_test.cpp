/// Surfaces as meshes.

#include "scene/surfaces/surface_mesh.hpp"
#include "height_tools.hpp"
#include "main/script.hpp"
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

Scene scene_of(const SurfaceMesh& mesh, double z_scale = 1, std::optional<double> base = {}) {
  return surface_scene(std::span(&mesh, 1), {1, 1, z_scale}, base);
}

struct Counts {
  std::size_t vertices, edges, faces, borders = 0, many = 0, unlike = 0, curves = 0, contours = 0;
  int characteristic() const { return static_cast<int>(vertices) - static_cast<int>(edges) + static_cast<int>(faces); }
};

Counts count(const Scene& scene) {
  const Topology topology = build_topology(scene);
  Counts counts{scene.vertices.size(), topology.edges.size(), scene.faces.size()};
  for (std::size_t e = 0; e < topology.edges.size(); ++e) {
    counts.borders += topology.edges[e].face1 == kNone;
    counts.many += (topology.edge_flags[e] & kEdgeManyFaces) != 0;
    counts.unlike += (topology.edge_flags[e] & kEdgeUnlikeWound) != 0;
    counts.curves += (topology.edge_flags[e] & kEdgeCurve) != 0;
    counts.contours += (topology.edge_flags[e] & kEdgeContour) != 0;
  }
  return counts;
}

/// Counts of the mesh of a surface after its changes: "missing N", a sample; "strides X Y" of the curves; "clip LOW HIGH";
/// "cut LEVELS"; "base Z", of a skirt.
std::string meshed(SurfacePoints surface, const std::vector<std::string>& changes) {
  std::vector<std::pair<std::string, std::vector<double>>> steps;
  for (const std::string& change : changes) {
    const std::vector<std::string> words = test::words_of(change);
    auto& [verb, numbers] = steps.emplace_back(words.at(0), std::vector<double>());
    for (std::size_t i = 1; i < words.size(); ++i) numbers.push_back(test::value_of(words[i]));
    if (verb == "missing") surface.points.at(static_cast<std::size_t>(numbers[0])).z = kNaN;
    if (verb != "strides") continue;
    surface.x_stride = static_cast<std::size_t>(numbers[0]);
    surface.y_stride = static_cast<std::size_t>(numbers[1]);
  }
  SurfaceMesh mesh = make_surface_mesh(surface);
  std::optional<double> base;
  for (const auto& [verb, numbers] : steps) {
    if (verb == "clip") clip_heights(mesh, numbers[0], numbers[1]);
    if (verb == "cut") cut_contours(mesh, numbers);
    if (verb == "base") base = numbers[0];
  }
  const Scene scene = scene_of(mesh, 1, base);
  EXPECT_EQ(scene.objects.empty(), !height_range(std::span(&mesh, 1)));
  const Counts counts = count(scene);
  std::string text;
  for (const auto& [name, number] : {std::pair("vertices", counts.vertices),
                                     {"edges", counts.edges},
                                     {"faces", counts.faces},
                                     {"objects", scene.objects.size()},
                                     {"borders", counts.borders},
                                     {"many", counts.many},
                                     {"unlike", counts.unlike},
                                     {"curves", counts.curves},
                                     {"contours", counts.contours}})
    if (number > 0) text += (text.empty() ? "" : ", ") + std::to_string(number) + " " + name;
  return text;
}

std::vector<double> positions(const std::string& text) {
  const std::vector<std::string> words = test::words_of(text);
  return evenly(test::value_of(words.at(0)), test::value_of(words.at(1)), std::stoul(words.at(2)));
}

/// "FORMULA; FROM TO INTERVALS; CHANGES" over a square.
std::string meshed_heights(const std::string& text) {
  const std::vector<std::string> parts = test::parts_of(text, ';');
  const std::vector<double> at = positions(parts.at(1));
  return meshed(points_of(*formula_heights(parts[0], at, at)), {parts.begin() + 2, parts.end()});
}

/// "X; Y; Z; FROM TO INTERVALS; FROM TO INTERVALS; CHANGES" of u and v.
std::string meshed_parametric(const std::string& text) {
  const std::vector<std::string> parts = test::parts_of(text, ';');
  return meshed(parametric_points({parts.at(0), parts.at(1), parts.at(2)}, positions(parts.at(3)), positions(parts.at(4))),
                {parts.begin() + 5, parts.end()});
}

/// "FORMULA; XS; YS; X FROM TO Y FROM TO", a window of a grid, or without it its logarithms: x, y and rows of heights.
std::string filtered(const std::string& text) {
  const std::vector<std::string> parts = test::parts_of(text, ';');
  const auto numbers = [&](std::size_t i) {
    std::vector<double> list;
    for (const std::string& word : test::words_of(parts.at(i))) list.push_back(word == "none" ? kNaN : test::value_of(word));
    return list;
  };
  auto heights = formula_heights(parts.at(0), numbers(1), numbers(2));
  if (parts.size() > 3) {
    const std::vector<double> n = numbers(3);
    const auto window = [](double from, double to) { return std::isnan(from) ? AxisWindow{} : AxisWindow{from, to}; };
    heights = window_heights(std::move(heights), window(n.at(0), n.at(1)), window(n.at(2), n.at(3)), "g");
  } else {
    heights = log_heights(std::move(heights));
  }
  std::string all;
  for (const std::vector<double>& row : height_test::heights_of(*heights)) {
    for (const double z : row) all += (all.empty() || all.ends_with("; ") ? "" : " ") + test::as_text(z);
    all += "; ";
  }
  return all + "x " + test::as_text(heights->x().front()) + " y " + test::as_text(heights->y().front());
}

[[maybe_unused]] const bool surfaces_are_added =
    test::add_function_scripts(LIGNE_SOURCE_DIR "/tests/scene/surfaces",
                               {{"heights", meshed_heights}, {"parametric", meshed_parametric}, {"filtered", filtered}});

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

/// The corners of the cut are where the edges of the whole surface cross its height, all of them and no others.
TEST(SurfaceMesh, HeightsAreCutWhereTheyCross) {
  constexpr double kTop = 2.503;
  SurfaceMesh mesh = make_surface_mesh(heights("x^2+y^2", 40));
  const Scene whole = scene_of(mesh);
  clip_heights(mesh, 0, kTop);
  const Scene scene = scene_of(mesh);
  const Counts counts = count(scene);
  EXPECT_EQ(counts.characteristic(), 1) << "a disc";
  EXPECT_EQ(counts.many + counts.unlike, 0u);
  std::vector<Point3> crossings;
  for (const Edge& edge : build_topology(whole).edges) {
    const Point3 a = whole.vertices[edge.v0], b = whole.vertices[edge.v1];
    if ((a.z < kTop) != (b.z < kTop)) crossings.push_back(a + (b - a) * ((kTop - a.z) / (b.z - a.z)));
  }
  const Topology topology = build_topology(scene);
  std::map<std::uint32_t, int> ends;
  double length = 0;
  for (std::size_t e = 0; e < topology.edges.size(); ++e) {
    const Edge& edge = topology.edges[e];
    if (edge.face1 != kNone) continue;
    EXPECT_FALSE(topology.edge_flags[e] & kEdgeCurve);
    length += glm::distance(scene.vertices[edge.v0], scene.vertices[edge.v1]);
    ++ends[edge.v0], ++ends[edge.v1];
  }
  EXPECT_EQ(ends.size(), crossings.size());
  for (const auto& [v, n] : ends) {
    const Point3 p = scene.vertices[v];
    EXPECT_EQ(n, 2) << "one closed line";
    EXPECT_EQ(p.z, kTop) << "to the last bit";
    EXPECT_TRUE(std::ranges::any_of(crossings, [&](const Point3& q) { return glm::distance(p, q) < 1e-12; }));
  }
  EXPECT_NEAR(length, 2 * kPi * std::sqrt(kTop), 0.01);
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
    EXPECT_EQ(counts.many + counts.unlike, 0u) << formula;
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

}  // namespace
}  // namespace ligne
