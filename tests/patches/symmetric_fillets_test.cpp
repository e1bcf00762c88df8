/// Boxes with rounded edges: all twelve of their fillets are found, however few or many facets they have.

#include <glm/common.hpp>

#include "patches/patch_scenes.hpp"
#include "support/test.hpp"

namespace ligne::test {
namespace {

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
