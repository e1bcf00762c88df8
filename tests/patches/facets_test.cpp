/// Facets: rows of parallel edges, flat sets, and surfaces of few facets or of facets hardly larger than a rounding.

#include <glm/common.hpp>
#include <numeric>

#include "patches/patch_scenes.hpp"
#include "scene/creases/find_creases.hpp"
#include "scene/model/edge_rows.hpp"
#include "scene/patches/facets/flat_sets.hpp"
#include "support/test.hpp"

namespace ligne::test {
namespace {

/// The scene of polygons whose coordinates were rounded to whole steps.
Scene rounded_scene(std::vector<Corners> polygons, double step) {
  for (Corners& polygon : polygons) {
    for (Point3& p : polygon)
      p = {step * std::round(p.x / step), step * std::round(p.y / step), step * std::round(p.z / step)};
  }
  Scene scene = scene_of(polygons);
  scene.objects[0].precision = step / 2;
  return scene;
}

/// A slanting tube, closed by two rings, of triangles. Its height is 3, its bore half as wide.
std::vector<Corners> tube(int sides, double radius) {
  const Point3 axis = glm::normalize(Point3(0.3, -0.2, 1)), side = glm::normalize(glm::cross(axis, Point3(1, 0, 0)));
  const Point3 other = glm::cross(axis, side);
  const auto point = [&](double r, int u, double z) {
    const double angle = 2 * kPi * (u % sides) / sides;
    return r * std::cos(angle) * side + r * std::sin(angle) * other + z * axis;
  };
  std::vector<Corners> polygons;
  add_grid(polygons, sides, 1, true, [&](int u, int v) { return point(radius, u, 3 * v); });
  add_grid(polygons, sides, 1, true, [&](int u, int v) { return point(radius * (1 - 0.5 * v), u, 3); });
  add_grid(polygons, sides, 1, true, [&](int u, int v) { return point(radius * (0.5 + 0.5 * v), u, 0); });
  add_grid(polygons, sides, 1, true, [&](int u, int v) { return point(radius / 2, u, 3 - 3 * v); });
  return polygons;
}

std::size_t count_creases(const Scene& scene) {
  const Creases creases = find_creases(scene, build_topology(scene), {30, kSurfaceCreaseDegrees});
  return static_cast<std::size_t>(std::count(creases.lines.begin(), creases.lines.end(), kCreaseLine));
}

// Rows of parallel edges.

/// A strip along y of `facets` facets that bend by the given angles, in degrees, each 1 wide; of triangles where asked.
struct Strip {
  Scene scene;
  Topology topology;
  std::vector<glm::vec3> normals;

  Strip(const std::vector<double>& bends, bool triangles) {
    std::vector<Point3> profile{{0, 0, 0}, {1, 0, 0}};
    double angle = 0;
    for (const double bend : bends) {
      angle -= bend * kPi / 180;
      profile.push_back(profile.back() + Point3(std::cos(angle), 0, std::sin(angle)));
    }
    std::vector<Corners> polygons;
    add_grid(polygons, static_cast<int>(profile.size()) - 1, 1, triangles,
             [&](int u, int v) { return profile[static_cast<std::size_t>(u)] + Point3(0, 5.0 * v, 0); });
    scene = scene_of(polygons);
    topology = build_topology(scene);
    normals = face_normals(scene, topology);
  }

  EdgeRows rows() const { return {scene, topology, normals}; }

  /// The edge along y between facets k - 1 and k.
  std::uint32_t edge(int k) const {
    for (std::uint32_t e = 0; e < topology.edges.size(); ++e) {
      const Edge& at = topology.edges[e];
      if (at.face1 == kNone || std::abs(scene.vertices[at.v0].y - scene.vertices[at.v1].y) < 4.9) continue;
      if (scene.vertices[at.v0].x != scene.vertices[at.v1].x) continue;
      if (k-- == 1) return e;
    }
    return kNone;
  }
};

class EdgeRowsOf : public testing::TestWithParam<bool> {};

TEST_P(EdgeRowsOf, GoOnWhereEdgesBendAlike) {
  const Strip strip({20, 20, 20, 7, 20, -20}, GetParam());
  const EdgeRows rows = strip.rows();
  const auto both = rows.beside(strip.edge(2), kEvenBends);
  ASSERT_TRUE(both);
  for (const EdgeRows::Step& step : *both) {
    EXPECT_TRUE(step.edge == strip.edge(1) || step.edge == strip.edge(3));
    EXPECT_NEAR(step.distance, 1, 1e-6);
  }
  EXPECT_NE((*both)[0].edge, (*both)[1].edge);
  // An edge of 7 degrees bends by too little; at the last one the strip bends to the other side.
  EXPECT_FALSE(rows.beside(strip.edge(3), kRoundingBends));
  EXPECT_FALSE(rows.beside(strip.edge(5), kRoundingBends));
  EXPECT_TRUE(rows.beside(strip.edge(4), kRoundingBends));
  EXPECT_FALSE(rows.beside(strip.edge(4), kEvenBends));
}

TEST_P(EdgeRowsOf, EndAtCornersOfPolygonsAndBorders) {
  const Strip strip({25, 25, 50, 25}, GetParam());
  const EdgeRows rows = strip.rows();
  for (const int k : {1, 2, 3, 4}) EXPECT_FALSE(rows.beside(strip.edge(k), kRoundingBends)) << k;
}

TEST_P(EdgeRowsOf, CompareAllEdgesWithTheFirst) {
  const Strip strip({10, 18, 27, 27}, GetParam());
  const EdgeRows rows = strip.rows();
  const Edge& first = strip.topology.edges[strip.edge(3)];
  int most = 0;
  for (const std::uint32_t face : {first.face0, first.face1}) {
    EdgeRows::Step step{strip.edge(3), face};
    int count = 0;
    while ((step = rows.next(step, kRoundingBends))) ++count;
    most = std::max(most, count);
  }
  EXPECT_EQ(most, 1);  // 18 of 27 degrees are alike, 10 are not, although they are of 18
}

INSTANTIATE_TEST_SUITE_P(Triangles, EdgeRowsOf, testing::Bool());

// Limits of the search for planes where coordinates are coarse for their facets.

/// Ground of n x n squares of side 1 with heights of up to 32 steps, without order; a part of it is level.
Scene rough_ground(int n, double step, int level) {
  std::vector<Corners> polygons;
  add_grid(polygons, n, n, true, [&](int u, int v) {
    const auto mixed = static_cast<std::uint32_t>(u * 73856093) ^ static_cast<std::uint32_t>(v * 19349663);
    const bool is_level = u < level && v < level;
    return Point3(u, v, is_level ? 0 : step * (mixed * 2654435761u >> 27));
  });
  Scene scene = scene_of(polygons);
  scene.objects[0].precision = step / 2;
  return scene;
}

/// The sets of a scene in which each pair of faces seems flat.
FlatSets sets_of(const Scene& scene) {
  const Topology topology = build_topology(scene);
  std::vector<std::uint32_t> joints, order(scene.faces.size());
  for (std::uint32_t e = 0; e < topology.edges.size(); ++e) {
    if (topology.edges[e].face1 != kNone) joints.push_back(e);
  }
  std::iota(order.begin(), order.end(), 0u);
  return flat_sets(scene, scene.objects[0], topology.edges, joints, order);
}

TEST(FlatSets, GiveUpRoughGround) {
  const Scene scene = rough_ground(300, 0.1, 0);
  const FlatSets sets = sets_of(scene);
  EXPECT_GT(sets.looks, 5'400'000u) << "no search that must be ended";
  EXPECT_LT(sets.looks, 6'000'000u);
  EXPECT_FALSE(sets.has_small_faces);
  std::vector<std::uint32_t> own(scene.faces.size());
  std::iota(own.begin(), own.end(), 0u);
  EXPECT_EQ(sets.set_of, own);
}

TEST(FlatSets, FindTheLevelPartOfRoughGround) {
  const FlatSets sets = sets_of(rough_ground(200, 0.1, 60));
  std::vector<std::size_t> sizes(sets.set_of.size(), 0);
  for (const std::uint32_t set : sets.set_of) ++sizes[set];
  const std::size_t largest = *std::max_element(sizes.begin(), sizes.end());
  EXPECT_GE(largest, 2u * 59 * 59);
  EXPECT_LE(largest, 2u * 62 * 62);
}

// Surfaces of few facets, and of facets that are hardly larger than the rounding of their coordinates.

/// A tube and what it has: two cylinders, and four rims.
void expect_tube(const Scene& scene, int sides, double radius) {
  const FoundPatches found(scene);
  const auto faces = found.faces();
  ASSERT_EQ(faces.size(), 2u);
  for (const auto& [patch, count] : faces) {
    const PatchSurface& surface = found.patches.list[patch].surface;
    EXPECT_EQ(surface.kind, SurfaceKind::cylinder);
    EXPECT_EQ(count, 2u * static_cast<std::size_t>(sides));
    EXPECT_LE(std::min(std::abs(surface.radius - radius), std::abs(surface.radius - radius / 2)),
              4 * scene.objects[0].precision);
  }
  EXPECT_EQ(found.count(PatchEdge::tangent), 0u);
  EXPECT_EQ(count_creases(scene), 4u * static_cast<std::size_t>(sides));
}

class FineSurfaces : public testing::TestWithParam<int> {};

TEST_P(FineSurfaces, RoundedTubesAreTwoCylinders) {
  for (const double radius : {1.0, 5.0}) {
    for (const double step : {1e-3, 1e-4, 1e-5, 1e-6}) {
      // A facet of the bore is as wide as five steps there: its normal tells nothing.
      if (GetParam() > 100 && step * 1000 > radius / 2) continue;
      SCOPED_TRACE(testing::Message() << radius << " " << step);
      expect_tube(rounded_scene(tube(GetParam(), radius), step), GetParam(), radius);
    }
  }
}

TEST_P(FineSurfaces, TubesOfFloat32FarFromTheOriginAreTwoCylinders) {
  for (const double radius : {1.0, 5.0}) {
    for (const double far : {100.0, 1000.0, 3000.0}) {
      SCOPED_TRACE(testing::Message() << radius << " " << far);
      std::vector<Corners> polygons = tube(GetParam(), radius);
      for (Corners& polygon : polygons) {
        for (Point3& p : polygon) p += far * Point3(1, 1.3, -0.7);
      }
      expect_tube(scene_of(polygons), GetParam(), radius);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Sides, FineSurfaces, testing::Values(100, 600));

TEST(ShortFillets, AreCylindersWhateverTheOrderOfFaces) {
  const std::vector<Corners> box = rounded_box({4, 3, 2.5}, 3);
  for (std::size_t first = 0; first < box.size(); first += 7) {
    for (const bool turned : {false, true}) {
      std::vector<Corners> polygons(box.begin() + static_cast<std::ptrdiff_t>(first), box.end());
      polygons.insert(polygons.end(), box.begin(), box.begin() + static_cast<std::ptrdiff_t>(first));
      if (turned) std::reverse(polygons.begin(), polygons.end());
      const FoundPatches found(polygons);
      std::size_t cylinders = 0;
      for (const auto& [patch, count] : found.faces())
        cylinders += found.patches.list[patch].surface.kind == SurfaceKind::cylinder;
      EXPECT_EQ(cylinders, 12u) << first << turned;
    }
  }
}

TEST(FineSurfaces, ARoundedRowOfTrianglesIsNoSphere) {
  // Both circles of a row on a cone lie on a sphere, too.
  for (const int sides : {120, 170, 240}) {
    std::vector<Corners> polygons;
    add_grid(polygons, sides, 1, true,
             [&](int u, int v) { return on_circle(6 - 1.5 * v, 2 * kPi * (u % sides) / sides, 2 * v); });
    const FoundPatches found(rounded_scene(polygons, 0.002));
    for (const auto& [patch, count] : found.faces())
      EXPECT_NE(found.patches.list[patch].surface.kind, SurfaceKind::sphere) << sides;
    EXPECT_EQ(found.count(PatchEdge::tangent) + found.count(PatchEdge::sharp), 0u) << sides;
  }
}

TEST(FineSurfaces, TheSidesOfAThreadAreNoSurfaces) {
  // Pieces of a helicoid lie on cylinders and tori within some roundings, and leave them slowly.
  std::vector<Corners> polygons;
  add_grid(polygons, 600, 3, true, [](int u, int v) {
    return on_circle(8 + v / 3.0, 2 * kPi * u / 200, 2.0 * u / 200 + 0.5 * v / 3) + Point3(220, 264, 0);
  });
  const FoundPatches found(polygons);
  EXPECT_TRUE(found.faces().empty());
  EXPECT_EQ(found.count(PatchEdge::tangent), 0u);
}

// Boxes with rounded edges: all twelve of their fillets are found, however few or many facets they have.

/// A cube of half size 10 with a rounding of the given radius, of `facets` facets to a quarter turn. The grid of each side
/// of the cube has lines where the roundings begin and `facets` / 2 more on either side.
std::vector<Corners> rounded_box(double radius, int facets, bool triangles) {
  std::vector<double> places;  // angles from the middle of a side, 45 degrees at its border
  for (int k = 0; k <= facets / 2; ++k) places.push_back(kPi / 4 * 2 * k / facets);
  std::vector<Corners> polygons;
  const int last = 2 * static_cast<int>(places.size()) - 1;
  const auto place = [&](int k) {  // inner corner of the rounding and slope
    const int from = static_cast<int>(places.size());
    const double slope =
        std::tan(k >= from ? places[static_cast<std::size_t>(k - from)] : -places[static_cast<std::size_t>(from - 1 - k)]);
    return Point2(k >= from ? 10 - radius : radius - 10, slope);
  };
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      const auto at = [&](int u, int v) {
        const Point2 a = place(side > 0 ? u : last - u), b = place(v);
        Point3 core, way;
        core[axis] = side * (10 - radius), way[axis] = side;
        core[(axis + 1) % 3] = a.x, way[(axis + 1) % 3] = a.y;
        core[(axis + 2) % 3] = b.x, way[(axis + 2) % 3] = b.y;
        const Point3 found = core + radius * glm::normalize(way);
        return 0x1p-20 * glm::round(0x1p20 * found);  // sides of the cube share their corners
      };
      add_grid(polygons, last, last, triangles, at);
    }
  }
  return polygons;
}

class SymmetricFillets : public testing::TestWithParam<std::tuple<int, bool, double>> {};

TEST_P(SymmetricFillets, HaveTwelveFillets) {
  const auto& [facets, triangles, radius] = GetParam();
  std::vector<Corners> polygons = rounded_box(radius, facets, triangles);
  for (int turn = 0; turn < 3; ++turn) {  // the order of the faces makes no difference
    const FoundPatches found(polygons);
    std::vector<std::uint8_t> is_used(found.patches.list.size(), 0);
    for (const std::uint32_t p : found.patches.patch_of) {
      if (p != kNone) is_used[p] = 1;
    }
    int cylinders = 0;
    for (std::size_t p = 0; p < is_used.size(); ++p) {
      if (!is_used[p] || found.patches.list[p].surface.kind != SurfaceKind::cylinder) continue;
      EXPECT_NEAR(found.patches.list[p].surface.radius, radius, 1e-4);
      ++cylinders;
    }
    EXPECT_EQ(cylinders, 12);
    std::rotate(polygons.begin(), polygons.begin() + static_cast<std::ptrdiff_t>(polygons.size() / 3 + 1), polygons.end());
  }
}

INSTANTIATE_TEST_SUITE_P(Facets, SymmetricFillets,
                         testing::Combine(testing::Values(4, 8, 20), testing::Bool(), testing::Values(0.75, 2.0, 4.0)));

}  // namespace
}  // namespace ligne::test
