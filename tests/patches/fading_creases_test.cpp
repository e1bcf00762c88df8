/// Creases that end in the middle of a surface: those of a coarse smooth mesh go, long ones that stand out stay.

#include <map>

#include "patches/found_creases.hpp"
#include "scene/creases/fading_creases.hpp"
#include "support/test.hpp"

namespace ligne::test {
namespace {

/// Lengths of the lines of creases from their free ends to the next junction.
std::vector<double> loose_lines(const FoundCreases& found) {
  std::map<std::uint32_t, std::vector<std::size_t>> at;
  for (std::size_t e = 0; e < found.topology.edges.size(); ++e) {
    if (!found.is_crease(e)) continue;
    at[found.topology.edges[e].v0].push_back(e);
    at[found.topology.edges[e].v1].push_back(e);
  }
  std::vector<double> lengths;
  for (const auto& [end, creases] : at) {
    if (creases.size() != 1) continue;
    double length = 0;
    std::uint32_t v = end;
    for (std::size_t e = creases[0];;) {
      length += glm::distance(found.end(e, false), found.end(e, true));
      v = found.topology.edges[e].v0 == v ? found.topology.edges[e].v1 : found.topology.edges[e].v0;
      if (at[v].size() != 2) break;
      e = at[v][at[v][0] == e ? 1 : 0];
    }
    lengths.push_back(length);
  }
  return lengths;
}

/// A body like a potato, of so few faces that some edges bend by more than the crease angle.
std::vector<Corners> potato(int columns, int rows) {
  std::vector<Corners> polygons;
  const auto at = [&](int k, int ring) {
    const double down = kPi * ring / rows, around = 2 * kPi * (k % columns) / columns;
    const double r = 10 * (1 + 0.2 * std::sin(3 * around + 1) * std::sin(down) * std::sin(2 * down + 0.5));
    const double out = ring % rows == 0 ? 0 : std::sin(down);
    return r * Point3(1.4 * out * std::cos(around), out * std::sin(around), std::cos(down));
  };
  add_grid(polygons, columns, rows, true, at);
  std::erase_if(polygons, [](const Corners& c) {
    return glm::distance(c[0], c[1]) < 1e-9 || glm::distance(c[1], c[2]) < 1e-9 || glm::distance(c[2], c[0]) < 1e-9;
  });
  return outward(polygons);
}

TEST(FadingCreases, GoInACoarseSmoothBody) {
  constexpr double kSize = 38;  // of the diagonal of its box, at least
  for (const auto& [columns, rows] : {std::pair{10, 7}, {12, 8}, {14, 9}, {16, 10}}) {
    SCOPED_TRACE(columns);
    const FoundCreases found(potato(columns, rows));
    EXPECT_GT(found.creases.fading, 0u);
    for (const double length : loose_lines(found)) EXPECT_GT(length, kSize / 8);
  }
}

TEST(FadingCreases, GoWhateverElseTheObjectHas) {
  constexpr double kSize = 38;  // of the diagonal of the body's box, at least
  for (const auto& [columns, rows] : {std::pair{10, 7}, {12, 8}, {14, 9}, {16, 10}}) {
    SCOPED_TRACE(columns);
    std::vector<Corners> polygons = potato(columns, rows);
    std::vector<Corners> box = outward({{{-9, -9, -9}, {9, -9, -9}, {9, 9, -9}, {-9, 9, -9}},
                                        {{-9, -9, 9}, {9, -9, 9}, {9, 9, 9}, {-9, 9, 9}},
                                        {{-9, -9, -9}, {9, -9, -9}, {9, -9, 9}, {-9, -9, 9}},
                                        {{-9, 9, -9}, {9, 9, -9}, {9, 9, 9}, {-9, 9, 9}},
                                        {{-9, -9, -9}, {-9, 9, -9}, {-9, 9, 9}, {-9, -9, 9}},
                                        {{9, -9, -9}, {9, 9, -9}, {9, 9, 9}, {9, -9, 9}}});
    for (Corners& side : box) {
      for (Point3& p : side) p.x += 30;
      polygons.push_back(side);
    }
    const FoundCreases found(polygons);
    EXPECT_GT(found.creases.fading, 0u);
    for (const double length : loose_lines(found)) EXPECT_GT(length, kSize / 8);
  }
}

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

TEST(FadingCreases, StayWhereALongFoldStandsOut) {
  const FoundCreases found(fold(58, 8));
  double length = 0;
  for (std::size_t e = 0; e < found.topology.edges.size(); ++e) {
    if (!found.is_crease(e)) continue;
    EXPECT_EQ(found.end(e, false).x, 0);
    EXPECT_EQ(found.end(e, true).x, 0);
    length += glm::distance(found.end(e, false), found.end(e, true));
  }
  EXPECT_GT(length, 8);
  EXPECT_EQ(loose_lines(found).size(), 2u);  // one of them ends on the border
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
