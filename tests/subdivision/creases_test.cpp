// Sharp and semi-sharp edges, and the tags of files that name them.

#include "control_scenes.hpp"
#include "scene/clean/clean.hpp"
#include "scene/creases/find_creases.hpp"
#include "scene/reader_tools.hpp"
#include "support/scene_parts.hpp"

namespace ligne::subdivision_test {
namespace {

bool is_on_cube(const Point3& p) { return std::abs(std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) - 1) < 1e-12; }

TEST(SharpEdges, KeepACube) {
  for (const SubdivisionScheme scheme : {kCatmullClark, kLoop}) {
    const Made made = subdivided(cube_points(), kCube, scheme, 3, creased_cube(kAlwaysSharp));
    for (const Point3& p : made.scene.vertices) EXPECT_TRUE(is_on_cube(p));
    for (std::size_t v = 0; v < 8; ++v) EXPECT_EQ(made.scene.vertices[v], cube_points()[v]);
    EXPECT_EQ(made.report.sharp_edges, 12u);
    // Each edge of the cube is halved three times, and is a side of two faces.
    EXPECT_EQ(std::ranges::count_if(made.scene.corner_flags, [](std::uint8_t f) { return f & kCornerSharp; }), 12 * 8 * 2);
    EXPECT_TRUE(std::ranges::all_of(made.scene.corner_flags,
                                    [](std::uint8_t f) { return ((f & kCornerSharp) != 0) != ((f & kCornerSmooth) != 0); }));
  }
}

TEST(SharpEdges, FromTheFileAreSharp) {
  Scene scene = scene_of(cube_points(), kCube);
  scene.corner_flags.assign(24, 0);
  for (std::size_t k = 0; k < 4; ++k) scene.corner_flags[k] = kCornerSharp;  // the bottom
  const Made made = subdivided(std::move(scene), kCatmullClark, 3);
  EXPECT_EQ(made.report.sharp_edges, 4u);
  // Four edges in a ring are a spline in the plane of the bottom.
  for (std::size_t v = 0; v < 4; ++v)
    expect_near(made.scene.vertices[v], cube_points()[v] * Point3(2.0 / 3, 2.0 / 3, 1), 1e-13);
}

TEST(SemiSharpEdges, OfSharpnessOneAreSharpForOneLevel) {
  const Made once = subdivided(cube_points(), kCube, kCatmullClark, 4, creased_cube(1));
  // The cube with its faces cut in four, without creases.
  std::vector<Point3> points;
  Polygons quads;
  std::map<std::tuple<double, double, double>, std::uint32_t> number;
  const auto vertex = [&](const Point3& p) {
    const auto [at, is_new] = number.try_emplace({p.x, p.y, p.z}, static_cast<std::uint32_t>(points.size()));
    if (is_new) points.push_back(p);
    return at->second;
  };
  for (const Point3& corner : cube_points()) vertex(corner);
  for (const auto& face : kCube) {
    Point3 center(0);
    for (const std::uint32_t v : face) center += points[v] / 4.0;
    for (std::size_t k = 0; k < 4; ++k) {
      const Point3 p = cube_points()[face[k]], next = cube_points()[face[(k + 1) % 4]],
                   before = cube_points()[face[(k + 3) % 4]];
      quads.push_back({face[k], vertex((p + next) / 2.0), vertex(center), vertex((p + before) / 2.0)});
    }
  }
  const Made cut = subdivided(points, quads, kCatmullClark, 3);
  ASSERT_EQ(once.scene.vertices.size(), cut.scene.vertices.size());
  for (std::size_t v = 0; v < 8; ++v) expect_near(once.scene.vertices[v], cut.scene.vertices[v], 1e-13);
}

TEST(SemiSharpEdges, LieBetweenSmoothAndSharp) {
  for (const SubdivisionScheme scheme : {kCatmullClark, kLoop}) {
    double before = glm::length(subdivided(cube_points(), kCube, scheme, 5).scene.vertices[7]);
    const Made nearly_smooth = subdivided(cube_points(), kCube, scheme, 5, creased_cube(1e-6f));
    EXPECT_NEAR(glm::length(nearly_smooth.scene.vertices[7]), before, 1e-5);
    for (const float sharpness : {0.25f, 0.5f, 1.0f, 1.5f, 2.0f, 3.0f, 4.0f}) {
      const Made made = subdivided(cube_points(), kCube, scheme, 5, creased_cube(sharpness));
      const double reach = glm::length(made.scene.vertices[7]);
      EXPECT_GT(reach, before) << sharpness;
      EXPECT_LT(reach, std::sqrt(3.0)) << sharpness;
      before = reach;
    }
  }
}

TEST(SemiSharpEdges, EndInASmoothSurface) {
  CreaseTags tags;
  tags.edges = {{0, 1, kAlwaysSharp}};  // a single edge: both of its ends are darts, smooth vertices
  const Made made = subdivided(cube_points(), kCube, kCatmullClark, 3, tags),
             smooth = subdivided(cube_points(), kCube, kCatmullClark, 3);
  EXPECT_EQ(made.report.sharp_edges, 1u);
  expect_near(made.scene.vertices[7], smooth.scene.vertices[7], 0.02);
  EXPECT_GT(glm::distance(made.scene.vertices[8], smooth.scene.vertices[8]), 0.1);
}

/// The creases of a clear drawing of a limit surface.
Creases creases_of(Made made) {
  test::finish(made.scene);
  return find_creases(made.scene, build_topology(made.scene), {});
}

std::ptrdiff_t crease_count(const Creases& creases) { return std::ranges::count(creases.lines, kCreaseLine); }

/// A bar whose cross section is a star of so many points: its folds stay narrow at a few levels.
Made star_bar(CreaseTags tags) {
  constexpr std::uint32_t kCorners = 16, kRings = 5;
  std::vector<Point3> points;
  Polygons quads;
  for (std::uint32_t ring = 0; ring < kRings; ++ring) {
    for (std::uint32_t k = 0; k < kCorners; ++k) {
      const double angle = 2 * std::numbers::pi * k / kCorners, r = k % 2 ? 4 : 10;
      points.emplace_back(r * std::cos(angle), r * std::sin(angle), 8.0 * ring);
    }
  }
  for (std::uint32_t ring = 0; ring + 1 < kRings; ++ring) {
    for (std::uint32_t k = 0; k < kCorners; ++k) {
      const std::uint32_t a = ring * kCorners + k, b = ring * kCorners + (k + 1) % kCorners;
      quads.push_back({a, b, b + kCorners, a + kCorners});
    }
  }
  return subdivided(points, quads, kCatmullClark, 2, std::move(tags));
}

TEST(CreasesOfLimitSurfaces, AreNoneWithoutSharpEdges) {
  const Creases creases = creases_of(star_bar({}));
  EXPECT_EQ(crease_count(creases), 0);
  EXPECT_TRUE(creases.patches.list.empty());
  EXPECT_EQ(std::ranges::count(creases.patch_edges, PatchEdge::tangent), 0);
}

TEST(CreasesOfLimitSurfaces, AreTheSharpEdges) {
  CreaseTags tags;
  for (std::uint32_t ring = 0; ring < 4; ++ring) tags.edges.push_back({16 * ring, 16 * (ring + 1), kAlwaysSharp});
  EXPECT_EQ(crease_count(creases_of(star_bar(tags))), 4 * 4);
  // Semi-sharp edges that have decayed are creases while they bend.
  EXPECT_EQ(crease_count(creases_of(subdivided(cube_points(), kCube, kCatmullClark, 4, creased_cube(3.5f)))), 12 * 16);
  EXPECT_EQ(crease_count(creases_of(subdivided(cube_points(), kCube, kCatmullClark, 4, creased_cube(0.5f)))), 0);
}

TEST(SharpCorners, StayWhereTheyAre) {
  CreaseTags tags;
  tags.corners = {{7, kAlwaysSharp}, {0, 1}};
  const Made made = subdivided(cube_points(), kCube, kCatmullClark, 4, tags),
             smooth = subdivided(cube_points(), kCube, kCatmullClark, 4);
  EXPECT_EQ(made.scene.vertices[7], Point3(1, 1, 1));
  EXPECT_GT(glm::length(made.scene.vertices[0]), glm::length(smooth.scene.vertices[0]) + 0.1);
  EXPECT_LT(glm::length(made.scene.vertices[0]), std::sqrt(3.0));
}

// Meshes that are no surfaces, and what belongs to faces.

/// Points of a surface lie in the box of its control mesh, since all weights of the masks are positive.
void expect_sane(const Made& made, double reach) {
  ASSERT_FALSE(made.scene.objects.empty());
  if (!made.scene.faces.empty()) reader_test::expect_sound(made.scene, true);
  EXPECT_EQ(made.scene.corner_flags.size(), made.scene.faces.corners().size());
  for (const Point3& p : made.scene.vertices)
    EXPECT_TRUE(std::abs(p.x) <= reach && std::abs(p.y) <= reach && std::abs(p.z) <= reach)
        << p.x << " " << p.y << " " << p.z;
}

TEST(HostileControlMeshes, GiveFinitePoints) {
  const std::vector<Point3> cube = cube_points();
  const std::vector<std::pair<const char*, Polygons>> meshes{
      {"a triangle", {{0, 1, 2}}},
      {"three faces at an edge", {{0, 1, 3, 2}, {0, 1, 5, 4}, {0, 1, 7, 6}}},
      {"three faces at an edge inside", {{0, 1, 3}, {1, 0, 2}, {0, 4, 1}, {0, 3, 2}, {1, 2, 3}}},
      {"a face twice", {{0, 1, 3, 2}, {0, 1, 3, 2}}},
      {"a face and its back", {{0, 1, 3, 2}, {2, 3, 1, 0}}},
      {"a triangle and its back", {{0, 1, 3}, {3, 1, 0}}},
      {"unlike windings", {{0, 2, 3, 1}, {4, 6, 7, 5}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 4, 6, 2}, {1, 5, 7, 3}}},
      {"a spike", {{0, 1, 0, 2}, {0, 1, 3, 2}}},
      {"there and back", {{0, 1, 2, 1}}},
      {"an eight", {{0, 1, 3, 0, 4, 6}}},
      {"corners in a row", {{0, 0, 1, 1, 3, 2, 2, 0}}},
      {"two fans at a vertex", {{0, 1, 3}, {0, 4, 6}}},
      {"two closed fans at a vertex",
       {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}, {0, 4, 5}, {0, 5, 6}, {0, 6, 4}, {4, 6, 5}}},
      {"nothing but collapsed faces and a quad", {{0, 0, 1}, {1, 1, 1}, {0, 1, 0}, {4, 5, 7, 6}}},
      {"all vertices", {{0, 1, 2, 3, 4, 5, 6, 7}, {7, 6, 5, 4, 3, 2, 1, 0}}},
  };
  for (const auto& [name, polygons] : meshes) {
    SCOPED_TRACE(name);
    for (const SubdivisionScheme scheme : {kCatmullClark, kLoop})
      for (const float sharpness : {0.0f, 0.5f, kAlwaysSharp}) {
        const Made made = subdivided(cube, polygons, scheme, 3, sharpness > 0 ? creased_cube(sharpness) : CreaseTags{});
        expect_sane(made, 1 + 1e-12);
        EXPECT_EQ(made.scene.faces.empty(), scheme == kLoop && std::string(name) == "there and back");
      }
  }
}

TEST(HostileControlMeshes, RandomSoupGivesFinitePoints) {
  std::mt19937 random(17);
  const auto below = [&](std::uint32_t n) { return std::uniform_int_distribution<std::uint32_t>(0, n - 1)(random); };
  for (int round = 0; round < 200; ++round) {
    Polygons polygons(1 + below(12));
    for (auto& polygon : polygons) {
      polygon.resize(3 + below(5));
      for (std::uint32_t& v : polygon) v = below(8);
    }
    polygons.push_back({0, 1, 2});
    for (const SubdivisionScheme scheme : {kCatmullClark, kLoop})
      expect_sane(subdivided(cube_points(), polygons, scheme, 2, creased_cube(0.25f * static_cast<float>(round % 8))),
                  1 + 1e-12);
  }
}

TEST(HostileControlMeshes, WindingsDoNotMatter) {
  Polygons turned = kCube;
  for (const std::size_t f : {1u, 4u}) std::ranges::reverse(turned[f]);
  const Made like = subdivided(cube_points(), kCube, kCatmullClark, 3),
             unlike = subdivided(cube_points(), turned, kCatmullClark, 3);
  for (std::size_t v = 0; v < 8; ++v) expect_near(like.scene.vertices[v], unlike.scene.vertices[v], 1e-13);
}

TEST(HostileControlMeshes, FacesThatAreNotFiniteAreDropped) {
  std::vector<Point3> points = cube_points();
  points[7].x = std::numeric_limits<double>::quiet_NaN();
  const Made made = subdivided(points, kCube, kCatmullClark, 2);
  EXPECT_EQ(made.scene.faces.size(), 3u * 2u * 16u);
  EXPECT_EQ(made.warnings.lines(), std::vector<std::string>{std::string("3 ") + kFacesNotFinite});
  expect_sane(made, 1);
}

TEST(HostileControlMeshes, DoubledVerticesAreOne) {
  // Every face with vertices of its own, as files with flat normals have them.
  std::vector<Point3> points;
  Polygons polygons;
  for (const auto& face : kCube) {
    polygons.emplace_back();
    for (const std::uint32_t v : face) {
      polygons.back().push_back(static_cast<std::uint32_t>(points.size()));
      points.push_back(cube_points()[v]);
    }
  }
  const Made made = subdivided(points, polygons, kCatmullClark, 2);
  EXPECT_EQ(made.scene.vertices.size(), subdivided(cube_points(), kCube, kCatmullClark, 2).scene.vertices.size());
}

TEST(HostileControlMeshes, HolesAreCut) {
  Scene scene =
      scene_of({{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {0, 3, 0}, {1, 1, 0}, {1, 2, 0}, {2, 2, 0}, {2, 1, 0}}, {{0, 1, 2, 3}});
  scene.faces.add_hole(std::vector<std::uint32_t>{4, 5, 6, 7});
  for (const SubdivisionScheme scheme : {kCatmullClark, kLoop}) {
    CreaseTags tags;
    tags.edges = {{4, 5, 1}};
    const Made made = subdivided(scene, scheme, 2, tags);
    EXPECT_EQ(made.report.faces, 8u);
    for (const Point3& p : made.scene.vertices) EXPECT_EQ(p.z, 0);
    // Nothing lies in the middle of the hole: its border is a spline about it.
    for (const Point3& p : made.scene.vertices) EXPECT_GT(glm::distance(p, Point3(1.5, 1.5, 0)), 0.4);
    expect_sane(made, 3);
  }
}

TEST(SubdividedScene, KeepsObjectsMaterialsAndSources) {
  Scene scene = scene_of(cube_points(), kCube);
  scene.face_material = {0, 1, 0, 1, 0, 1};
  scene.face_source = {10, 11, 12, 13, 14, 15};
  scene.materials.resize(2);
  scene.details.push_back({3, 1, {{0, 0, 1}}});
  begin_object(scene, "plate");
  for (const Point3& p : {Point3(5, 0, 0), Point3(6, 0, 0), Point3(6, 1, 0), Point3(5, 1, 0)}) scene.vertices.push_back(p);
  scene.faces.add_face(std::vector<std::uint32_t>{8, 9, 10, 11});
  scene.face_material.push_back(0), scene.face_source.push_back(16);
  end_object(scene);
  scene.details.push_back({6, 1, {{5, 0, 0}}});
  for (const bool plate_too : {true, false}) {
    for (const SubdivisionScheme scheme : {kCatmullClark, kLoop}) {
      Made made{scene, {}, {}};
      SubdivisionRequest request{{scheme, 2}, {}, false};
      if (!plate_too)
        request.is_wanted = [](const Object& object, std::size_t i) { return i == 0 && object.name == "control"; };
      made.report = subdivide(made.scene, request, {}, "M", made.warnings);
      ASSERT_EQ(made.scene.objects.size(), 2u);
      EXPECT_EQ(made.scene.objects[1].name, "plate");
      const std::size_t per_face = made.scene.objects[0].face_end / 6;
      EXPECT_EQ(per_face, 32u);
      for (std::size_t f = 0; f < 6 * per_face; ++f) {
        EXPECT_EQ(made.scene.face_source[f], 10 + f / per_face);
        EXPECT_EQ(made.scene.face_material[f], f / per_face % 2);
      }
      EXPECT_EQ(made.scene.objects[1].face_end - made.scene.objects[1].face_begin, plate_too ? per_face : 1u);
      EXPECT_EQ(made.scene.face_source.back(), 16u);
      EXPECT_EQ(made.scene.details.size(), plate_too ? 0u : 1u);
      for (const Detail& detail : made.scene.details) EXPECT_EQ(detail.face, made.scene.objects[1].face_begin);
      EXPECT_FALSE(made.warnings.lines().empty());
      Warnings warnings;
      finish_scene(made.scene, warnings);
      EXPECT_TRUE(warnings.lines().empty());
    }
  }
}

// The quad that looks up is a crease of another face's edge only where the file says so of all sides.
TEST(SubdividedScene, KeepsFlagsOfEdges) {
  Scene scene = grid(2);
  scene.corner_flags.assign(16, 0);
  scene.corner_flags[1] = kCornerFileHidden;  // of two sides of an edge one
  scene.corner_flags[0] = kCornerFileHidden;  // a border
  const Made made = subdivided(std::move(scene), kCatmullClark, 2);
  EXPECT_EQ(std::ranges::count_if(made.scene.corner_flags, [](std::uint8_t f) { return f & kCornerFileHidden; }), 4);
}

}  // namespace
}  // namespace ligne::subdivision_test
