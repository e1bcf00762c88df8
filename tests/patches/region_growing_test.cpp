/// Planes and cylinders of known parts are those that CGAL's region growing finds [OesauEtAl2022].

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Point_set_3.h>
#include <CGAL/Shape_detection/Region_growing.h>
#include <CGAL/Surface_mesh.h>

#include "clear/true_parts.hpp"
#include "patches/patch_scenes.hpp"
#include "scene/patches/facet_graph.hpp"
#include "scene/readers/reader.hpp"
#include "support/test.hpp"

namespace ligne::test {
namespace {

using namespace CGAL::Shape_detection;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Points = CGAL::Point_set_3<Kernel::Point_3>;
using Planes = Polygon_mesh::Least_squares_plane_fit_region<Kernel, Mesh>;
using Cylinders = Point_set::Least_squares_cylinder_fit_region<Kernel, Points, Points::Point_map, Points::Vector_map>;

std::vector<std::vector<std::size_t>> grow(const auto& items, auto&& neighbours, auto&& fit) {
  std::vector<std::vector<std::size_t>> regions;
  Region_growing(items, neighbours, fit).detect(std::back_inserter(regions));
  return regions;
}

/// Compares the cylinders of a part that has no other curved surfaces. The middles of their strips lie on a cylinder whose
/// radius is smaller by the sag. `patch_of`: by middle.
void compare_cylinders(const Patches& patches, const Points& middles, const std::vector<std::uint32_t>& patch_of) {
  constexpr unsigned kFirst = 6;  // CGAL takes these as they come, so a region has more
  constexpr double kTolerance = 1e-3, kDegrees = 2, kLeastRadius = 0.1, kLargestRadius = 100, kRadiusTolerance = 1e-4;
  const auto at = middles.point_map();
  const auto root = [](double x) { return std::sqrt(x); };
  const auto cylinders =
      grow(middles, Point_set::K_neighbor_query<Kernel, Points, Points::Point_map>(middles, kFirst, at),
           Cylinders(middles, kTolerance, kDegrees, kFirst + 1, kLeastRadius, kLargestRadius, at, middles.normal_map()));
  EXPECT_EQ(cylinders.size(), patches.list.size());
  for (const auto& strips : cylinders) {
    const std::uint32_t patch = patch_of[strips[0]];
    ASSERT_NE(patch, kNone);
    EXPECT_EQ(std::ranges::count(patch_of, patch), std::ssize(strips));
    for (const std::size_t strip : strips) EXPECT_EQ(patch_of[strip], patch);
    Kernel::Line_3 axis;
    double radius = 0;
    internal::cylinder_fit(strips, at, middles.normal_map(), root, Kernel::Compute_squared_distance_3(), axis, radius);
    EXPECT_NEAR(radius + patches.list[patch].sag, patches.list[patch].surface.radius, kRadiusTolerance);
  }
}

void compare(const FoundPatches& ours, bool has_only_cylinders) {
  constexpr double kRoundings = 4, kDegrees = 0.5;
  const auto& [scene, topology, angles, patches, edges] = ours;
  const Object& object = scene.objects.at(0);
  Mesh mesh;
  for (const Point3& p : scene.vertices) mesh.add_vertex({p.x, p.y, p.z});
  const auto corner = [](std::uint32_t v) { return Mesh::Vertex_index(v); };
  for (const Triangle& t : topology.triangles) mesh.add_face(corner(t.v[0]), corner(t.v[1]), corner(t.v[2]));
  const FacetGraph graph = facet_graph(scene, topology, object, edges_of(topology, object), angles.normals);
  EXPECT_EQ(std::ranges::count(patches.is_freeform, 1), 0);
  Points middles(true);
  std::vector<std::uint32_t> patch_of;
  for (const auto& faces : grow(mesh.faces(), Polygon_mesh::One_ring_neighbor_query<Mesh>(mesh),
                                Planes(mesh, kRoundings * object.precision, kDegrees, 1, mesh.points()))) {
    EXPECT_TRUE(std::ranges::is_permutation(faces, graph.faces[graph.facet_of[faces[0]]]));
    patch_of.push_back(patches.patch_of[faces[0]]);
    Point3 middle(0), normal(angles.normals[faces[0]]);
    for (const std::size_t f : faces) {
      EXPECT_EQ(patches.patch_of[f], patch_of.back());
      for (const std::uint32_t v : topology.triangles[f].v) middle += scene.vertices[v] / (3.0 * double(faces.size()));
    }
    middles.insert({middle.x, middle.y, middle.z}, {normal.x, normal.y, normal.z});
  }
  if (has_only_cylinders) compare_cylinders(patches, middles, patch_of);
}

TEST(RegionGrowing, FindsTheSamePlanesAndCylinders) {
  const TemporaryFolder folder;
  for (const TruePart& part : true_parts()) {
    for (const int facets : {16, 24, 48, 96}) {
      SCOPED_TRACE(part.name + std::to_string(facets));
      write_mesh(part, facets, folder / "part.stl");
      Warnings warnings;
      // CGAL needs seven strips of a quarter.
      const bool has_only_cylinders = std::holds_alternative<Extrusion>(part.shape) && facets >= 48;
      compare(FoundPatches(read_scene(folder / "part.stl", {}, warnings)), has_only_cylinders);
    }
  }
}

}  // namespace
}  // namespace ligne::test
