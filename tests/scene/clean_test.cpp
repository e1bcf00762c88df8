#include "scene/clean/clean.hpp"

#include "scene/clean/weld_near.hpp"
#include "scene/model/topology.hpp"
#include "support/test.hpp"

namespace ligne {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr char kDegenerate[] = "faces with fewer than three distinct vertices dropped";
constexpr char kNotFinite[] = "faces with vertices that are not finite dropped";
constexpr char kNotPlanar[] = "non-planar faces cut into triangles";

using Corners = std::vector<std::uint32_t>;
using Points = std::vector<Point3>;
using Flags = std::vector<std::uint8_t>;

struct Cleaned {
  Scene scene;
  Warnings warnings;
  std::size_t count(const char* kind) const {
    const auto it = warnings.counts().find(kind);
    return it == warnings.counts().end() ? 0 : it->second;
  }
};

Cleaned clean(Scene scene) {
  Cleaned c{std::move(scene), {}};
  finish_scene(c.scene, c.warnings);
  return c;
}

void add_object(Scene& scene, const Points& points, const std::vector<Corners>& faces, double precision = 0) {
  Object o;
  o.vertex_begin = static_cast<std::uint32_t>(scene.vertices.size());
  o.face_begin = static_cast<std::uint32_t>(scene.faces.size());
  scene.vertices.insert(scene.vertices.end(), points.begin(), points.end());
  for (Corners face : faces) {
    for (std::uint32_t& v : face) v += o.vertex_begin;
    scene.faces.add_face(face);
  }
  o.vertex_end = static_cast<std::uint32_t>(scene.vertices.size());
  o.face_end = static_cast<std::uint32_t>(scene.faces.size());
  o.precision = precision;
  scene.objects.push_back(o);
}

Scene one_object(const Points& points, const std::vector<Corners>& faces, double precision = 0) {
  Scene scene;
  add_object(scene, points, faces, precision);
  return scene;
}

Corners corners(const Scene& scene) {
  const auto c = scene.faces.corners();
  return {c.begin(), c.end()};
}

TEST(FinishScene, WeldsEqualPositionsOfOneObject) {
  const Points seam{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, -0.0}, {1, 1, 0}, {0, 1, 0}};
  Scene scene;
  add_object(scene, seam, {{0, 1, 2}, {3, 4, 5}});
  add_object(scene, seam, {{0, 1, 2}, {3, 4, 5}});
  const Cleaned c = clean(scene);
  EXPECT_EQ(c.scene.vertices.size(), 8u) << "objects are not welded to each other";
  EXPECT_EQ(corners(c.scene), (Corners{0, 1, 2, 1, 3, 2, 4, 5, 6, 5, 7, 6}));
  EXPECT_EQ(c.scene.objects[0].vertex_end, 4u);
  EXPECT_EQ(c.scene.objects[1].vertex_begin, 4u);
  EXPECT_EQ(c.scene.objects[1].vertex_end, 8u);
  EXPECT_TRUE(c.scene.faces.all_triangles());
  EXPECT_TRUE(c.warnings.counts().empty());
}

TEST(FinishScene, NothingToDoCopiesNothing) {
  Scene scene = one_object({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
  const Point3* vertices = scene.vertices.data();
  const std::uint32_t* first = scene.faces.corners().data();
  Warnings warnings;
  finish_scene(scene, warnings);
  EXPECT_EQ(scene.vertices.data(), vertices);
  EXPECT_EQ(scene.faces.corners().data(), first);
}

TEST(FinishScene, DropsCollapsedTrianglesAndKeepsTheRestTogether) {
  const Points p{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}, {1, 1, 0}, {5, 5, 5}};
  Scene scene;
  add_object(scene, p, {{0, 1, 3}, {0, 1, 2}, {0, 5, 5}});
  add_object(scene, p, {{0, 1, 3}, {1, 4, 2}});
  scene.face_material = {0, 1, 2, 3, 4};
  scene.corner_flags = {1, 1, 1, 0, 1, 0, 1, 1, 1, 1, 1, 1, 0, 0, 1};
  scene.materials.resize(5);
  scene.details = {{0, 0, {}}, {1, 1, {}}, {4, 2, {}}};
  const Cleaned c = clean(scene);
  EXPECT_EQ(c.count(kDegenerate), 3u);
  EXPECT_EQ(corners(c.scene), (Corners{0, 1, 2, 3, 5, 4}));
  EXPECT_EQ(c.scene.face_material, (Corners{1, 4}));
  EXPECT_EQ(c.scene.corner_flags, (Flags{0, 1, 0, 0, 0, 1}));
  EXPECT_EQ(c.scene.objects[0].face_end, 1u);
  EXPECT_EQ(c.scene.objects[1].face_begin, 1u);
  EXPECT_EQ(c.scene.objects[1].face_end, 2u);
  EXPECT_EQ(c.scene.vertices.size(), 6u) << "vertices that no face uses go";
  ASSERT_EQ(c.scene.details.size(), 2u);
  EXPECT_EQ(c.scene.details[0].face, 0u);
  EXPECT_EQ(c.scene.details[1].face, 1u);
  EXPECT_EQ(c.count("details of dropped faces dropped"), 1u);
}

TEST(FinishScene, VerticesThatAreNotFiniteGoWithTheirFaces) {
  const Points p{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {kNan, 0, 0}, {0, INFINITY, 0}, {1, 1, 0}};
  const Cleaned triangles = clean(one_object(p, {{0, 1, 3}, {0, 1, 2}, {1, 4, 2}}));
  EXPECT_EQ(triangles.count(kNotFinite), 2u);
  EXPECT_EQ(corners(triangles.scene), (Corners{0, 1, 2}));
  const Cleaned polygons = clean(one_object(p, {{0, 1, 3, 2}, {0, 1, 5, 2}}));
  EXPECT_EQ(polygons.count(kNotFinite), 1u);
  EXPECT_EQ(polygons.scene.faces.size(), 1u);
  EXPECT_EQ(polygons.scene.vertices.size(), 4u);
}

TEST(FinishScene, RepeatedCornersGo) {
  Scene scene =
      one_object({{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2, 3, 4, 0}, {0, 1, 2, 0}, {0, 1, 0, 2}});
  scene.corner_flags = Flags(14, 0);
  scene.corner_flags[1] = 1;  // on the edge that vanishes
  scene.corner_flags[2] = kCornerFileHidden;
  const Cleaned c = clean(scene);
  EXPECT_EQ(c.count(kDegenerate), 2u);
  ASSERT_EQ(c.scene.faces.size(), 1u);
  const auto contour = std::as_const(c.scene.faces).contour(0, 0);
  EXPECT_EQ(Corners(contour.begin(), contour.end()), (Corners{0, 1, 2, 3}));
  EXPECT_EQ(c.scene.corner_flags, (Flags{0, kCornerFileHidden, 0, 0}));
}

TEST(FinishScene, HolesThatCollapseGo) {
  Scene scene =
      one_object({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {1, 1, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}}, {{0, 1, 2, 3}});
  scene.faces.add_hole(Corners{4, 5, 6});
  scene.faces.add_hole(Corners{4, 7, 5});
  const Cleaned c = clean(scene);
  ASSERT_EQ(c.scene.faces.contour_count(0), 2u);
  EXPECT_EQ(c.count("holes with fewer than three distinct vertices dropped"), 1u);
  EXPECT_EQ(c.scene.vertices.size(), 7u);
}

TEST(FinishScene, PlanarWithinThePrecision) {
  // Each coordinate of a tilted square is off by the precision at most.
  constexpr double kPrecision = 1e-4;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> off(-kPrecision, kPrecision);
  for (int i = 0; i < 200; ++i) {
    Points p{{0, 0, 0}, {40, 0, 40}, {40, 0.5, 40}, {20, 0.25, 20}, {0, 0.5, 0}};
    for (Point3& q : p) q += Point3(off(random), off(random), off(random));
    EXPECT_EQ(clean(one_object(p, {{0, 1, 2, 3, 4}}, kPrecision)).scene.faces.size(), 1u);
  }
  EXPECT_EQ(clean(one_object({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 20 * kPrecision}}, {{0, 1, 2, 3}}, kPrecision))
                .count(kNotPlanar),
            1u);
}

TEST(FinishScene, NonPlanarFacesAreCut) {
  Scene scene = one_object({{0, 0, 0}, {1, 0, 0}, {1, 1, 1}, {0, 1, 0}, {2, 0, 0}, {2, 1, 1}}, {{0, 1, 2, 3}, {1, 4, 5, 2}});
  scene.face_material = {3, 4};
  scene.materials.resize(5);
  scene.corner_flags = {0, kCornerFileHidden, 0, 0, 0, 0, 0, 0};
  scene.details = {{1, 0, {}}};
  const Cleaned c = clean(scene);
  EXPECT_EQ(c.count(kNotPlanar), 1u);
  ASSERT_EQ(c.scene.faces.size(), 3u);
  EXPECT_EQ(c.scene.face_material, (Corners{3, 3, 4}));
  EXPECT_EQ(c.scene.details[0].face, 2u);
  EXPECT_EQ(c.scene.objects[0].face_end, 3u);
  // Two inner corners, one on each side of the cut, and the file's flag on the edge 1 2 alone.
  int inner = 0, hidden = 0;
  for (std::size_t f = 0; f < 2; ++f) {
    const auto t = std::as_const(c.scene.faces).contour(f, 0);
    ASSERT_EQ(t.size(), 3u);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = t[k], b = t[(k + 1) % 3];
      const bool outer = (a + 1) % 4 == b;
      const std::uint8_t flags = c.scene.corner_flags[3 * f + k];
      EXPECT_EQ(flags, outer ? (a == 1 ? kCornerFileHidden : 0) : kCornerInner);
      inner += flags == kCornerInner, hidden += flags == kCornerFileHidden;
    }
  }
  EXPECT_EQ(inner, 2);
  EXPECT_EQ(hidden, 1);
}

/// A slanted plane; `points` in it.
Points slanted(const std::vector<std::array<double, 2>>& points) {
  Points result;
  for (const auto& [x, y] : points) result.emplace_back(x, y, x / 2 + y / 4);
  return result;
}

TEST(FinishScene, CountsFacesThatLoseAreaWhereTheirContourCrosses) {
  const auto lost = [](const std::vector<std::array<double, 2>>& points) {
    Scene scene;
    Corners corners;
    for (std::uint32_t i = 0; i < points.size(); ++i) corners.push_back(i);
    add_object(scene, slanted(points), {corners, {0, 1, 2}});
    return clean(std::move(scene)).count("faces whose contours cross, or with holes outside, are not filled as a whole");
  };
  EXPECT_EQ(lost({{0, 0}, {4, 4}, {4, 0}, {0, 4}}), 1u) << "a bow tie of two equal halves";
  EXPECT_EQ(lost({{0, 0}, {4, 3}, {4, 0}, {0, 5}}), 1u) << "and of unequal ones";
  EXPECT_EQ(lost({{0, 6}, {4, -5}, {-6, 2}, {6, 2}, {-4, -5}}), 1u) << "a pentagram";
  EXPECT_EQ(lost({{0, 0}, {4, 0}, {4, 4}, {0, 4}}), 0u);
  EXPECT_EQ(lost({{0, 0}, {4, 0}, {1, 1}, {0, 4}}), 0u) << "concave";
  EXPECT_EQ(lost({{0, 0}, {2, 2}, {4, 0}, {4, 4}, {2, 2}, {0, 4}}), 0u) << "a bow tie whose halves touch";
  EXPECT_EQ(lost({{0, 0}, {4, 0}, {4, 4}, {4, 0}}), 0u) << "a spike has no area to lose";
  EXPECT_EQ(lost({{0, 0}, {1, 0}, {2, 0}, {3, 0}}), 0u) << "nothing at all";
}

TEST(FinishScene, NonPlanarFaceWithHole) {
  // A square bent along its diagonal, with a square hole, wound as the outer contour and against it.
  for (const bool same : {false, true}) {
    const auto z = [](double x, double y) { return std::max(0.0, x + y - 4); };
    Points p;
    for (const auto& [x, y] :
         {std::pair{0.0, 0.0}, {4.0, 0.0}, {4.0, 4.0}, {0.0, 4.0}, {1.0, 1.0}, {1.0, 3.0}, {3.0, 3.0}, {3.0, 1.0}}) {
      p.emplace_back(x, y, z(x, y));
    }
    Scene scene = one_object(p, {{0, 1, 2, 3}});
    scene.faces.add_hole(same ? Corners{7, 6, 5, 4} : Corners{4, 5, 6, 7});
    const Cleaned c = clean(scene);
    EXPECT_EQ(c.scene.faces.size(), 8u);
    EXPECT_TRUE(c.scene.faces.all_triangles());
    EXPECT_EQ(std::count(c.scene.corner_flags.begin(), c.scene.corner_flags.end(), 0), 8) << "the eight edges of the face";
    double area = 0;
    for (std::size_t f = 0; f < c.scene.faces.size(); ++f) {
      const auto t = std::as_const(c.scene.faces).contour(f, 0);
      const Point3 a = c.scene.vertices[t[0]], b = c.scene.vertices[t[1]], d = c.scene.vertices[t[2]];
      area += ((b.x - a.x) * (d.y - a.y) - (b.y - a.y) * (d.x - a.x)) / 2;
    }
    EXPECT_DOUBLE_EQ(area, 12);
  }
}

TEST(FinishScene, SceneWithoutObjectsIsOne) {
  Scene scene;
  scene.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  scene.faces.add_triangle(0, 1, 2);
  const Cleaned c = clean(scene);
  ASSERT_EQ(c.scene.objects.size(), 1u);
  EXPECT_EQ(c.scene.objects[0].vertex_end, 3u);
  EXPECT_EQ(c.scene.objects[0].face_end, 1u);
  EXPECT_TRUE(clean(Scene{}).scene.objects.empty());
  const Cleaned thin = clean(one_object({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}}));
  EXPECT_EQ(thin.scene.faces.size(), 1u) << "triangles without an area stay";
  EXPECT_TRUE(thin.warnings.counts().empty());
}

TEST(FinishScene, LargeWeldsAreRight) {
  // Every triangle of a grid has vertices of its own; two objects of the same positions.
  constexpr std::uint32_t kSide = 150;
  Scene scene;
  for (int object = 0; object < 2; ++object) {
    Points points;
    std::vector<Corners> faces;
    for (std::uint32_t y = 0; y < kSide; ++y) {
      for (std::uint32_t x = 0; x < kSide; ++x) {
        const auto n = static_cast<std::uint32_t>(points.size());
        for (const auto& [dx, dy] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}})
          points.emplace_back(0.1 * (x + dx), 0.1 * (y + dy), 0);
        faces.insert(faces.end(), {{n, n + 1, n + 2}, {n + 3, n + 4, n + 5}});
      }
    }
    add_object(scene, points, faces);
  }
  const Points before = scene.vertices;
  const Corners old = corners(scene);
  const Cleaned c = clean(scene);
  EXPECT_EQ(c.scene.vertices.size(), 2 * (kSide + 1) * (kSide + 1));
  const Corners now = corners(c.scene);
  ASSERT_EQ(now.size(), old.size());
  std::uint32_t next = 0;
  for (std::size_t k = 0; k < now.size(); ++k) {
    ASSERT_EQ(c.scene.vertices[now[k]], before[old[k]]);
    ASSERT_LE(now[k], next) << "vertices stay in the order of their first use";
    if (now[k] == next) ++next;
  }
}

Scene points(std::vector<Point3> vertices) {
  Scene scene;
  scene.vertices = std::move(vertices);
  return scene;
}

TEST(WeldNear, TheFirstVertexStaysAndTheOthersGoThere) {
  Scene scene = points({{0, 0, 0}, {1, 0, 0}, {1.05, 0, 0}, {0.95, 0.02, 0}, {-0.05, 0, 0}});
  weld_near_vertices(scene, 0.1);
  EXPECT_EQ(scene.vertices, (std::vector<Point3>{{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {1, 0, 0}, {0, 0, 0}}));
}

TEST(WeldNear, ChainsDoNotCollapse) {
  Scene scene = points({{0, 0, 0}, {0.08, 0, 0}, {0.16, 0, 0}, {0.24, 0, 0}});
  weld_near_vertices(scene, 0.1);
  EXPECT_EQ(scene.vertices, (std::vector<Point3>{{0, 0, 0}, {0, 0, 0}, {0.16, 0, 0}, {0.16, 0, 0}}));
}

TEST(WeldNear, ObjectsAreApart) {
  Scene scene = points({{0, 0, 0}, {0.01, 0, 0}, {0.02, 0, 0}});
  Object a, b;
  a.vertex_end = b.vertex_begin = 1;
  b.vertex_end = 3;
  scene.objects = {a, b};
  weld_near_vertices(scene, 0.1);
  EXPECT_EQ(scene.vertices, (std::vector<Point3>{{0, 0, 0}, {0.01, 0, 0}, {0.01, 0, 0}}));
}

TEST(WeldNear, AnyNumbersAreTaken) {
  constexpr double kInf = std::numeric_limits<double>::infinity();
  const std::vector<Point3> odd{{kInf, 0, 0}, {1e60, -1e60, 0}, {std::numeric_limits<double>::quiet_NaN(), 0, 0}, {1, 2, 3}};
  for (const double distance : {std::numeric_limits<double>::denorm_min(), 1e-300, 1.0, 1e300}) {
    Scene scene = points(odd);
    weld_near_vertices(scene, distance);
    EXPECT_EQ(scene.vertices[0], odd[0]);
    EXPECT_TRUE(scene.vertices[2].x != scene.vertices[2].x);
    EXPECT_EQ(scene.vertices[3], distance < 1e300 ? odd[3] : odd[1]);
  }
}

/// Against all pairs: who moves, moves to a vertex that stayed and is near; who stays has no such vertex before it.
TEST(WeldNear, IsWhatAllPairsSay) {
  std::mt19937_64 random(7);
  for (const double distance : {0.01, 0.1, 0.4}) {
    std::uniform_real_distribution<double> coordinate(-1, 1);
    std::vector<Point3> stored(600);
    for (Point3& p : stored) p = {coordinate(random), coordinate(random), coordinate(random)};
    Scene scene = points(stored);
    weld_near_vertices(scene, distance);
    std::vector<Point3> stayed;
    for (std::size_t i = 0; i < stored.size(); ++i) {
      bool near_one = false, is_there = false;
      for (const Point3& p : stayed) {
        near_one |= glm::distance(p, stored[i]) <= distance;
        is_there |= p == scene.vertices[i] && glm::distance(p, stored[i]) <= distance;
      }
      EXPECT_EQ(near_one, is_there) << i;
      if (!near_one) {
        EXPECT_EQ(scene.vertices[i], stored[i]);
        stayed.push_back(stored[i]);
      }
    }
  }
}

/// Two triangles of a square whose seam gapes by a thousandth.
TEST(WeldNear, ASeamIsNoBorder) {
  const auto borders = [](double distance) {
    Scene scene = points({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0.001, 0, 0}, {1, 1.001, 0}, {0, 1, 0}});
    scene.faces.add_triangle(0, 1, 2);
    scene.faces.add_triangle(3, 4, 5);
    if (distance > 0) weld_near_vertices(scene, distance);
    Warnings warnings;
    finish_scene(scene, warnings);
    std::size_t n = 0;
    for (const Edge& edge : build_topology(scene).edges) n += edge.face1 == kNone;
    return n;
  };
  EXPECT_EQ(borders(0), 6u);
  EXPECT_EQ(borders(0.0005), 6u);
  EXPECT_EQ(borders(0.002), 4u);
}

}  // namespace
}  // namespace ligne
