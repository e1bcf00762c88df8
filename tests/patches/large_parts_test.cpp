/// Large free forms, and parts that stand many times. Runs the scripts of this folder.

#include "base/parallel.hpp"
#include "patches/patch_scenes.hpp"
#include "scene/patches/borders/patch_outlines.hpp"
#include "scene/patches/facets/flat_joints.hpp"
#include "scene/patches/find_patches.hpp"
#include "scene/patches/freeform.hpp"
#include "scene/patches/parts/large_freeform.hpp"
#include "scene/patches/repeated_objects.hpp"
#include "support/mesh_script.hpp"
#include "support/mesh_text.hpp"
#include "support/test.hpp"

namespace ligne {
namespace {

using namespace test;

// Large free forms, recognised by samples.

/// A mesh of one object, with what find_patches() computes first.
struct Mesh {
  explicit Mesh(const MeshText& text)
      : scene(text.scene()), topology(build_topology(scene)), angles(mesh_angles(scene, topology, object_sizes(scene))) {}

  TriangleObject object() const {
    const Object& first = scene.objects[0];
    return {scene, topology, first, edges_of(topology, first), angles};
  }

  Scene scene;
  Topology topology;
  MeshAngles angles;
};

/// Compares the findings with those of the graph of all facets. Returns the number of faces in planes.
std::size_t compare_with_all_facets(const Mesh& mesh) {
  const TriangleObject whole = mesh.object();
  std::vector<std::uint32_t> joints;
  const auto found = find_large_freeform(whole, joints);
  EXPECT_TRUE(found.has_value());
  if (!found) return 0;

  const FacetGraph graph = facet_graph(mesh.scene, mesh.topology, whole.object, whole.edges, mesh.angles.normals);
  const std::vector<std::uint32_t> patch_of(graph.size(), kNone);
  const std::vector<std::uint8_t> freeform = freeform_facets(mesh.scene, mesh.topology, graph, {{}, patch_of, {}},
                                                             EdgeRows(mesh.scene, mesh.topology, mesh.angles.normals));
  std::size_t in_planes = 0, different = 0;
  for (std::uint32_t f = 0; f < whole.face_count(); ++f) {
    different += found->is_freeform[f] != freeform[graph.facet_of[f]];
    in_planes += found->is_freeform[f] == 0;
  }
  EXPECT_EQ(different, 0u);
  EXPECT_EQ(found->plane_edges, edges_inside_planes(mesh.topology, whole.object, graph, whole.edges.begin, whole.edges.end,
                                                    mesh.angles.normals));
  const std::vector<FreeformBorder> borders =
      freeform_borders(mesh.scene, mesh.topology, graph, {{}, patch_of, freeform}, {});
  EXPECT_EQ(found->borders.size(), borders.size());
  for (std::size_t i = 0; i < std::min(borders.size(), found->borders.size()); ++i) {
    EXPECT_EQ(found->borders[i].edge, borders[i].edge);
    EXPECT_EQ(found->borders[i].angle, borders[i].angle);
    EXPECT_EQ(found->borders[i].turn, borders[i].turn);
    EXPECT_EQ(found->borders[i].is_fleck, borders[i].is_fleck);
    EXPECT_EQ(found->borders[i].is_beside_plane, borders[i].is_beside_plane);
    const bool same_chain = i > 0 && borders[i].chain == borders[i - 1].chain;
    EXPECT_EQ(i > 0 && found->borders[i].chain == found->borders[i - 1].chain, same_chain);
  }
  return in_planes;
}

/// Wavy ground with a level square and a level strip.
TEST(LargeFreeform, HasTheFindingsOfAllFacets) {
  const Mesh mesh(
      mesh_of("grid 300 x 300 triangles: u; v; "
              "if((u>=100)*(u<=125)*(v>=100)*(v<=120)+(u>=20)*(u<=22)*(v>=30)*(v<=50)>0,2,"
              "2*sin(0.31*u+0.15*v)+2*sin(0.33*v-0.14*u)+sin(0.21*u-0.19*v))"));
  EXPECT_GE(compare_with_all_facets(mesh), 2u * 25 * 20);
}

/// Fine waves have many pairs of triangles in one plane, which are a part of the form. The two level triangles that are much
/// larger than those around them are a plane.
TEST(LargeFreeform, HasPairsOfTrianglesInOnePlane) {
  const std::string x = "(u+if(u>150,9,0))", y = "(v+if(v>150,9,0))";
  const Mesh mesh(mesh_of("grid 300 x 300 triangles: " + x + "; " + y +
                          "; if((abs(u-150.5)<1)*(abs(v-150.5)<1)>0,1,3*sin(0.05*" + x + "+0.02*" + y + ")+3*sin(0.06*" + y +
                          "-0.03*" + x + "))"));
  const TriangleObject whole = mesh.object();
  const std::vector<std::uint32_t> joints =
      flat_joints(mesh.scene, mesh.topology, whole.object, whole.edges, mesh.angles.normals, mesh.angles.flat);
  EXPECT_GE(joints.size(), whole.edge_count() / 32);
  EXPECT_GE(compare_with_all_facets(mesh), 2u);
}

/// A dozen small triangles that lie in one plane amid waves are no plane.
TEST(LargeFreeform, HasNoPlanesOfFewSmallTriangles) {
  const Mesh mesh(
      mesh_of("grid 300 x 300 triangles: u; v; if((u>=100)*(u<=103)*(v>=100)*(v<=102)>0,2,"
              "2*sin(0.31*u+0.15*v)+2*sin(0.33*v-0.14*u)+sin(0.21*u-0.19*v))"));
  std::vector<std::uint32_t> joints;
  const auto found = find_large_freeform(mesh.object(), joints);
  ASSERT_TRUE(found.has_value());
  EXPECT_GE(joints.size(), 11u);
  EXPECT_EQ(std::ranges::count(found->is_freeform, 0), 0);
}

TEST(LargeFreeform, IsNoMeshOfCylinders) {
  std::string tubes;
  for (int tube = 0; tube < 20; ++tube)
    tubes += "grid 64 x 80 triangles round: 3*" + std::to_string(tube) + "+cos(pi*u/32); sin(pi*u/32); 0.05*v\n";
  const Mesh mesh(mesh_of(tubes));
  ASSERT_GE(mesh.scene.faces.size(), 150'000u);
  std::vector<std::uint32_t> joints;
  EXPECT_FALSE(find_large_freeform(mesh.object(), joints).has_value());
}

TEST(LargeFreeform, IsNoMeshThatMostlyLiesInPlanes) {
  const Mesh mesh(mesh_of("grid 300 x 300 triangles: u; v; if(u<200,1,sin(0.1*u+0.03*v))"));
  std::vector<std::uint32_t> joints;
  EXPECT_FALSE(find_large_freeform(mesh.object(), joints).has_value());
}

/// Arcs behind a free form in the order of sizes. Threads that try seeds at once change nothing, though the first seed of an
/// arc would exclude all of its facets if it failed, or two seeds find one arc.
TEST(PatchFinder, FindsTheSameWithAnyNumberOfThreads) {
  std::string lines = "grid 7 x 4 triangles: u; v; 3*sin(0.31*u)*cos(0.23*v)+sin(0.11*u*v)";
  for (int k = 0; k < 12; ++k) {
    const std::string middle = std::to_string(3 * k), length = std::to_string(0.9 - 0.001 * k);
    const std::string angle = k % 2 ? "pi*u/12" : "pi*(u-2.5-0.02*(u-2.5)^3)/12";  // the one in the middle is the largest
    lines += "\ngrid 5 x 1: " + middle + "+cos(" + angle + "); sin(" + angle + ")-9; " + length + "*v";
  }
  Patches first;
  for (unsigned threads = 1; threads <= 8; ++threads) {
    Patches patches;
    run_with_threads(threads, [&] { patches = FoundPatches(mesh_of(lines).scene()).patches; });
    if (threads == 1) first = patches;
    EXPECT_EQ(patches.patch_of, first.patch_of) << threads;
    EXPECT_GE(patches.list.size(), 12u);
  }
}

// Objects that repeat an earlier one, and the surfaces that they take over from it.

/// A pin: a cylinder with a cone at its end, along z. More of them: scripts/repeated_objects.txt.
const std::string kPin = "grid 24 x 2 round: if(v<2,2,1)*cos(2*pi*u/24); if(v<2,2,1)*sin(2*pi*u/24); 5*v-2*(v>1)";

TEST(RepeatedObjects, AreNoOthersWhereTheFileMarksEdges) {
  Scene scene = mesh_of(kPin + "\nobject\ncopy 0").scene();
  scene.corner_flags.assign(scene.faces.corners().size(), 0);
  scene.corner_flags.back() = kCornerSharp;
  const std::vector<Repetition> found = find_repetitions(scene, build_topology(scene));
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[1].original, 1u);
}

/// The surfaces taken over are those that a search of the copy alone finds.
TEST(RepeatedObjects, HaveTheSurfacesOfTheOriginal) {
  const std::string moved = "\nmap: 1.5*x+9; 1.5*(y*cos(0.7)-z*sin(0.7))+1; 1.5*(y*sin(0.7)+z*cos(0.7))+2";
  const FoundPatches both(mesh_of(kPin + "\nobject\ncopy 0" + moved).scene()), alone(mesh_of(kPin + moved).scene());
  ASSERT_EQ(alone.patches.list.size(), 2u);
  ASSERT_EQ(both.patches.list.size(), 4u);
  for (std::size_t i = 0; i < 2; ++i) {
    const Patch &own = alone.patches.list[i], &taken = both.patches.list[2 + i];
    EXPECT_EQ(taken.surface.kind, own.surface.kind);
    EXPECT_EQ(taken.outward, own.outward);
    EXPECT_NEAR(taken.sag, own.sag, 1e-6);
    EXPECT_NEAR(std::abs(glm::dot(taken.surface.axis, own.surface.axis)), 1, 1e-9);
    for (const Point3& p : alone.scene.vertices) EXPECT_NEAR(taken.surface.distance(p), own.surface.distance(p), 1e-5);
  }
  const std::size_t faces = alone.scene.faces.size();
  for (std::size_t f = 0; f < faces; ++f) EXPECT_EQ(both.patches.patch_of[faces + f], 2 + alone.patches.patch_of[f]);
}

[[maybe_unused]] const bool scripts_are_added = add_mesh_scripts(LIGNE_SOURCE_DIR "/tests/patches/scripts");

}  // namespace
}  // namespace ligne
