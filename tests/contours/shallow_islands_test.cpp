// Grain on the sides of scans that are seen edge on.

#include "contours/shallow_islands.hpp"

#include <gtest/gtest.h>

namespace ligne::test {
namespace {

constexpr std::uint32_t kSide = 6;
constexpr std::uint32_t kMiddle = 2 * kSide + 2;

/// A square of triangles with one sector a vertex, all of which look away but for some.
struct Grain {
  Scene scene;
  SmoothPatch patch;
  Camera camera;

  Grain() {
    for (std::uint32_t i = 0; i < kSide * kSide; ++i) scene.vertices.push_back({i % kSide, i / kSide, 0});
    for (std::uint32_t y = 0; y + 1 < kSide; ++y) {
      for (std::uint32_t x = 0; x + 1 < kSide; ++x) {
        const std::uint32_t a = y * kSide + x;
        add({a, a + 1, a + kSide + 1});
        add({a, a + kSide + 1, a + kSide});
      }
    }
    patch.g.assign(scene.vertices.size(), -0.5);
    patch.across.assign(patch.sector.size(), kNone);
    for (std::uint32_t s = 0; s < patch.sector.size(); ++s) {
      for (std::uint32_t o = 0; o < patch.sector.size(); ++o) {
        if (patch.sector[s] == patch.sector[next_corner(o)] && patch.sector[next_corner(s)] == patch.sector[o]) {
          patch.across[s] = o;
        }
      }
    }
  }
  void add(const std::array<std::uint32_t, 3>& v) {
    Triangle t;
    for (std::size_t k = 0; k < 3; ++k) t.v[k] = v[k];
    t.face = static_cast<std::uint32_t>(patch.triangles.size());
    patch.triangles.push_back(t);
    patch.sector.insert(patch.sector.end(), v.begin(), v.end());
    patch.complete.insert(patch.complete.end(), 3, 1);
  }
  double level(double g, std::uint32_t vertex, const std::vector<ScanObject>& scans) {
    patch.g[vertex] = g;
    level_shallow_islands(patch, scene, camera, scans);
    return patch.g[vertex];
  }
};

const std::vector<ScanObject> kAll{{.face_begin = 0, .face_end = 1000}};

TEST(ShallowIslands, TurnLikeWhatIsRoundThem) {
  EXPECT_LT(Grain().level(0.05, kMiddle, kAll), 0);
  EXPECT_LT(Grain().level(0, kMiddle, kAll), 0);
  Grain away;
  for (double& g : away.patch.g) g = 0.5;
  EXPECT_GT(away.level(-0.05, kMiddle, kAll), 0);
}

TEST(ShallowIslands, StayWhereTheyAreDeepOrOpenOrOnNoScan) {
  EXPECT_EQ(Grain().level(0.1, kMiddle, kAll), 0.1) << "deep";
  EXPECT_EQ(Grain().level(0.05, 0, kAll), 0.05) << "at the border of the region";
  EXPECT_EQ(Grain().level(0.05, kMiddle, {{.face_begin = 900, .face_end = 1000}}), 0.05);
  EXPECT_EQ(Grain().level(0.05, kMiddle, {}), 0.05);
}

}  // namespace
}  // namespace ligne::test
