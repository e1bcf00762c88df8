// The edges of scenes so large that they are filed in several parts, against a plain table of them.

#include "scene/model/topology.hpp"
#include "base/parallel.hpp"
#include "height_tools.hpp"
#include "main/script.hpp"
#include "scene/clean/crossing_edges.hpp"
#include "scene/model/find_edges.hpp"
#include "scene/model/self_contact.hpp"
#include "scene/surfaces/surface_mesh.hpp"
#include "support/round_bodies.hpp"

namespace ligne {
namespace {

/// The faces of each edge in their order, each with whether it runs through the edge from the lower vertex, and the flags
/// of its corner there.
struct Side {
  std::uint32_t face;
  bool upwards;
  std::uint8_t flags;
};
using EdgeTable = std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<Side>>;

EdgeTable edge_table(const Scene& scene) {
  EdgeTable table;
  for (std::uint32_t f = 0; f < scene.faces.size(); ++f) {
    for (std::size_t c = 0; c < scene.faces.contour_count(f); ++c) {
      const auto contour = scene.faces.contour(f, c);
      for (std::size_t k = 0; k < contour.size(); ++k) {
        const std::uint32_t a = contour[k], b = contour[(k + 1) % contour.size()];
        const std::size_t corner = scene.faces.corner_index(f, c) + k;
        const std::uint8_t flags = scene.corner_flags.empty() ? std::uint8_t{0} : scene.corner_flags[corner];
        table[std::minmax(a, b)].push_back({f, a < b, flags});
      }
    }
  }
  return table;
}

void expect_edges(const Scene& scene) {
  const EdgeTable table = edge_table(scene);
  for (const unsigned threads : {1u, 3u}) {
    Topology topology;
    run_with_threads(threads, [&] { topology = build_topology(scene); });
    ASSERT_EQ(topology.edges.size(), table.size());
    const std::vector<std::uint32_t> borders = edges_with(topology, kEdgeBorder);
    std::size_t e = 0, wrong = 0;
    for (const auto& [ends, sides] : table) {
      const Edge& edge = topology.edges[e];
      const std::uint16_t flags = topology.edge_flags[e++];
      wrong += topology.first_edges[edge.v0] >= e || topology.first_edges[edge.v0 + 1] < e;
      wrong += edge.v0 != ends.first || edge.v1 != ends.second || edge.face0 != sides[0].face;
      wrong += edge.face1 != (sides.size() > 1 ? sides[1].face : kNone);
      wrong += ((flags & kEdgeManyFaces) != 0) != (sides.size() > 2);
      wrong += std::ranges::binary_search(borders, e - 1) != (sides.size() == 1);
      wrong += ((flags & kEdgeUnlikeWound) != 0) != (sides.size() == 2 && sides[0].upwards == sides[1].upwards);
      wrong += ((flags & kEdgeSharp) != 0) != std::ranges::any_of(sides, [](const Side& s) { return s.flags != 0; });
    }
    EXPECT_EQ(wrong, 0u) << threads << " threads";
  }
}

/// Triangles anywhere among neighbouring vertices, and some that reach over all of them.
Scene random_mesh(std::uint32_t vertices, std::uint32_t faces) {
  std::mt19937 random(3);
  const auto below = [&](std::uint32_t n) { return static_cast<std::uint32_t>(random() % n); };
  Scene scene;
  for (std::uint32_t v = 0; v < vertices; ++v) scene.vertices.emplace_back(v, v % 1000, v % 31);
  while (scene.faces.size() < faces) {
    const std::uint32_t first = below(vertices), reach = below(50) == 0 ? vertices : 6;
    std::array<std::uint32_t, 3> t{};
    for (std::uint32_t& v : t) v = (first + below(reach)) % vertices;
    if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) scene.faces.add_triangle(t[0], t[1], t[2]);
  }
  return scene;
}

TEST(Topology, EdgesOfManyParts) {
  Scene scene = random_mesh(60'000, 150'000);
  expect_edges(scene);
  for (std::size_t k = 0; k < scene.faces.corners().size(); ++k)
    scene.corner_flags.push_back(static_cast<std::uint8_t>(k % 7 == 0 ? kCornerSharp : 0));
  expect_edges(scene);
}

TEST(Topology, EdgesOfPolygonsAndRoundAHubOfManyParts) {
  Scene polygons = random_mesh(60'000, 100'000), hub = random_mesh(20'000, 20'000);
  for (std::uint32_t v = 0; v + 4 < 60'000; v += 3) polygons.faces.add_face(std::array{v, v + 1, v + 4, v + 2});
  expect_edges(polygons);
  for (std::uint32_t v = 1; v + 1 < 20'000; ++v) hub.faces.add_triangle(v + 1, 0, v);
  expect_edges(hub);
}

/// The number of edges that are marked, over all objects, along which surfaces pass through each other.
int crossing_edges(Scene scene) {
  double precision = 0;
  for (const Object& object : scene.objects) precision = std::max(precision, object.precision);
  mark_crossing_edges(scene, precision);
  const Topology topology = build_topology(scene);
  int count = 0;
  for (const std::uint16_t flags : topology.edge_flags) count += (flags & kEdgeCrossing) != 0;
  return count;
}

/// "Z; Z; ...": surfaces over [-1, 1] x [-1, 1] with four cells along each side.
std::string crossing_of_formulas(const std::string& text) {
  std::vector<SurfaceMesh> meshes;
  for (const std::string& formula : test::parts_of(text, ';')) {
    SurfacePoints points = points_of(*formula_heights(formula, evenly(-1, 1, 4), evenly(-1, 1, 4)));
    points.from_formula = true;
    meshes.push_back(make_surface_mesh(points));
  }
  return std::to_string(crossing_edges(surface_scene(meshes, {1, 1, 1}, {})));
}

/// "X; Y; Z; MOST U; CELLS; MOST V; CELLS": a surface with itself; u and v from 0.
std::string crossing_of_parametric(const std::string& text) {
  const std::vector<std::string> parts = test::parts_of(text, ';');
  const auto places = [&](std::size_t i) { return evenly(0, test::value_of(parts.at(i)), std::stoul(parts.at(i + 1))); };
  const SurfaceMesh mesh = make_surface_mesh(parametric_points({parts.at(0), parts[1], parts[2]}, places(3), places(5)));
  return std::to_string(crossing_edges(surface_scene(std::span(&mesh, 1), {1, 1, 1}, {})));
}

/// Surfaces that run into themselves, and the pairs of triangles that this is decided by.

/// The answer for the pair, which must not depend on the order of the two, nor on how they are wound.
bool apart(Corners3 t, Corners3 u, int shared) {
  const bool answer = are_apart(t, u, shared);
  EXPECT_EQ(are_apart(u, t, shared), answer);
  if (shared < 2) std::swap(t[1], t[2]);
  EXPECT_EQ(are_apart(t, u, shared), answer);
  return answer;
}

/// "SHARED X,Y,Z X,Y,Z X,Y,Z": the triangle and a flat one that shares so many corners with it.
std::string apart_from_flat(const std::string& text) {
  const std::vector<std::string> words = test::words_of(text);
  Corners3 triangle;
  for (std::size_t i = 0; i < 3; ++i)
    std::sscanf(words.at(1 + i).c_str(), "%lf,%lf,%lf", &triangle[i].x, &triangle[i].y, &triangle[i].z);
  return apart({{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}}, triangle, std::stoi(words[0])) ? "apart" : "meet";
}

[[maybe_unused]] const bool contacts_are_added = test::add_function_scripts(
    LIGNE_SOURCE_DIR "/tests/scene/contacts",
    {{"crossing", crossing_of_formulas}, {"crossing-itself", crossing_of_parametric}, {"flat-and", apart_from_flat}});

TEST(PlaneSide, Identities) {
  EXPECT_EQ(plane_side({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, -1}), 1);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> u(-1, 1);
  const auto point = [&] {
    const double x = u(random), y = u(random), z = u(random);
    return Point3{x, y, z};
  };
  for (int i = 0; i < 1000; ++i) {
    const Point3 a = point(), b = point(), c = point(), d = point();
    const int side = plane_side(a, b, c, d);
    EXPECT_EQ(plane_side(b, c, a, d), side);
    EXPECT_EQ(plane_side(b, a, c, d), -side);
    const Point3 p = glm::round(a * 1000.0), q = glm::round(b * 1000.0), r = glm::round(c * 1000.0);
    EXPECT_EQ(plane_side(p, q, r, q + r - p), 0) << "a point of the plane";
  }
}

TEST(TrianglePairs, CoplanarTrianglesThatAreTurnedDoNotMeet) {
  // Rounding leaves their corners beside the plane; the projections tell them apart.
  const Point3 x = Point3{0.6, 0.48, 0.64}, y{-0.8, 0.36, 0.48};
  const auto at = [&](double a, double b) { return x * a + y * b; };
  for (int i = 1; i < 50; ++i) {
    const double s = i / 7.0;
    EXPECT_TRUE(apart({{at(0, 0), at(s, s), at(s, 0)}}, {{at(0, 0), at(s, s), at(0, s)}}, 2));
    EXPECT_TRUE(apart({{at(s, s), at(2 * s, s), at(2 * s, 2 * s)}}, {{at(s, s), at(0, s), at(0, 0)}}, 1));
  }
}

TEST(TrianglePairs, AreaIsTold) {
  EXPECT_TRUE(has_no_area({{{0, 0, 0}, {1, 2, 3}, {2, 4, 6}}}));
  EXPECT_FALSE(has_no_area({{{0, 0, 0}, {1, 2, 3}, {2, 4, 6.5}}}));
}

/// The triangles of a torus whose tube goes round a circle of radius 1.
struct Torus {
  Scene scene;
  std::vector<Triangle> triangles;

  Torus(std::uint32_t n, double tube) : scene(test::torus(1, tube, n, n, 0.5)), triangles(build_topology(scene).triangles) {}
};

TEST(SelfContact, ATorusPenetratesItselfWhenItsTubeIsTooThick) {
  for (const double tube : {0.2, 0.9, 0.99, 1.02, 1.5}) {
    const Torus torus(24, tube);
    const std::vector<std::uint32_t> one(torus.triangles.size(), 0);
    EXPECT_EQ(find_self_contacts(torus.scene.vertices, torus.triangles, one, 1), (std::vector<std::uint8_t>{tube > 1}));
  }
}

TEST(SelfContact, SurfacesAreHeldAgainstThemselvesOnly) {
  Torus torus(16, 0.3);
  const auto half = static_cast<std::uint32_t>(torus.triangles.size());
  std::vector<Triangle> twice = torus.triangles;
  for (Triangle t : torus.triangles) {
    t.face += half;
    twice.push_back(t);
  }
  std::vector<std::uint32_t> surface(2 * half, 0);
  std::fill(surface.begin() + half, surface.end(), 1);
  EXPECT_EQ(find_self_contacts(torus.scene.vertices, twice, surface, 2), (std::vector<std::uint8_t>{0, 0}));
  std::fill(surface.begin(), surface.begin() + half, kNone);
  EXPECT_EQ(find_self_contacts(torus.scene.vertices, twice, surface, 2), (std::vector<std::uint8_t>{0, 0}));
  std::fill(surface.begin(), surface.end(), 1);
  EXPECT_EQ(find_self_contacts(torus.scene.vertices, twice, surface, 2), (std::vector<std::uint8_t>{0, 1}));
}

/// A torus: every edge has two faces.
Scene closed_mesh(std::uint32_t n) {
  Scene scene = test::torus(3, 1, n, n);
  scene.stated.state(StatedFact::adjacency);
  return scene;
}

// [Boulle1980] 1.2.2.1: edges of a stated adjacency are those that are found, over several parts of vertices, and round a
// hub; where the fact is false, they are found after all.
TEST(Topology, StatedAdjacencyGivesTheSameEdges) {
  Topology found;
  const Scene torus = closed_mesh(180);
  EXPECT_TRUE(find_paired_edges(torus, found) && is_paired(found));
  expect_edges(torus);

  // Two fans on one rim.
  Scene fans;
  constexpr std::uint32_t kRim = 500;
  fans.vertices.assign(kRim + 2, {0, 0, 0});
  for (std::uint32_t i = 0; i < kRim; ++i) {
    fans.faces.add_triangle(kRim, i, (i + 1) % kRim);
    fans.faces.add_triangle(kRim + 1, (i + 1) % kRim, i);
  }
  fans.objects.push_back({"fans", 0, kRim + 2, 0, 2 * kRim, 0});
  fans.stated.state(StatedFact::adjacency);
  EXPECT_TRUE(find_paired_edges(fans, found));
  expect_edges(fans);
}

TEST(Topology, FalseAdjacencyIsNoticed) {
  Topology found;
  const auto expect_refused = [&](const Scene& scene, const char* why) {
    EXPECT_FALSE(find_paired_edges(scene, found)) << why;
    EXPECT_FALSE(is_paired(build_topology(scene)));
    expect_edges(scene);
  };
  Scene scene = closed_mesh(20);
  scene.faces.add_triangle(0, 1, 300);
  expect_refused(scene, "a further face at an edge");

  scene = closed_mesh(21);
  const std::size_t last = scene.faces.size() - 1, begin = scene.faces.corner_index(last, 0);
  std::swap(scene.faces.corners()[begin + 1], scene.faces.corners()[begin + 2]);
  expect_refused(scene, "a face turned round");

  scene = {};
  scene.vertices.assign(6, {0, 0, 0});
  for (const std::uint32_t v : {2u, 3u, 4u, 5u}) scene.faces.add_triangle(v % 2 == 0 ? 0 : 1, v % 2 == 0 ? 1 : 0, v);
  scene.objects.push_back({"book", 0, 6, 0, 4, 0});
  scene.stated.state(StatedFact::adjacency);
  expect_refused(scene, "four faces at an edge");
}

}  // namespace
}  // namespace ligne
