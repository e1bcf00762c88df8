/// Objects that repeat an earlier one, and the surfaces that they take over from it.

#include "scene/patches/repeated_objects.hpp"
#include "support/test.hpp"

#include "patches/patch_scenes.hpp"
#include "support/mesh_text.hpp"

namespace ligne {
namespace {

using namespace test;

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

}  // namespace
}  // namespace ligne
