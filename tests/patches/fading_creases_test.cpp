/// Creases that end in the middle of a surface: those of a coarse smooth mesh go, long ones that stand out stay.

#include <map>

#include "patches/found_creases.hpp"
#include "scene/creases/fading_creases.hpp"
#include "support/test.hpp"

namespace ligne::test {
namespace {

/// A bowed sheet, folded along its middle by an angle that falls from `most` degrees at one end to 0 at the other.
std::vector<Corners> fold(double most, int columns, int rows = 12) {
  std::vector<Corners> polygons;
  const auto at = [&](int u, int v) {
    const double y = 20.0 * v / rows - 10, side = 1.0 * u / columns - 1;
    const double slope = std::tan(most / 2 * (1 - (y + 10) / 20) * kPi / 180), x = 8 * side;
    return Point3(x, y, -slope * std::abs(x) - 0.01 * x * x - 0.01 * y * y);
  };
  add_grid(polygons, 2 * columns, rows, true, at);
  return polygons;
}

/// Creases may become flat over a long way, as where a plane cuts a coil, but not by one edge at their end.
TEST(FadingCreases, DoNotEndWithAFewFlatEdges) {
  for (const double most : {58.0, 150.0}) {
    FoundCreases found(fold(most, 8, 48));
    std::vector<Bend> bends(found.topology.edges.size(), Bend::none);
    std::vector<BendEnd> ends;
    std::vector<std::uint32_t> middle;
    for (std::uint32_t e = 0; e < bends.size(); ++e) {
      if (found.end(e, false).x != 0 || found.end(e, true).x != 0) continue;
      bends[e] = Bend::strong;
      middle.push_back(e);
      for (const std::uint32_t v : {found.topology.edges[e].v0, found.topology.edges[e].v1}) ends.push_back({v, e});
    }
    std::sort(ends.begin(), ends.end());
    const std::vector<glm::vec3> normals = face_normals(found.scene, found.topology);
    const EdgeRows rows(found.scene, found.topology, normals);
    const std::vector<double> sizes{30};
    const std::vector<std::uint8_t> is_freeform(found.scene.faces.size(), 1);
    const std::function<bool(std::uint32_t)> never = [](std::uint32_t) { return false; };
    drop_fading_creases(found.scene, found.topology, {rows, ends, sizes, is_freeform, never, never}, bends);
    std::size_t flat = 0, dropped = 0;
    for (const std::uint32_t e : middle) {
      const bool is_flat = rows.bend(e, found.topology.edges[e].face0) < 5 * kPi / 180;
      flat += is_flat;
      dropped += bends[e] == Bend::weak;
      EXPECT_TRUE(is_flat || bends[e] == Bend::strong);
    }
    EXPECT_GT(flat, 0u);
    EXPECT_EQ(dropped, most > 100 ? flat : 0);
  }
}

}  // namespace
}  // namespace ligne::test
